// Pictures that a C++ program reads as a pointer: a local module the daemon's own, others a copy.

#include <alcommon/alproxy.h>
#include <alproxies/alvideodeviceproxy.h>
#include <alvision/alimage.h>
#include <gtest/gtest.h>

#include <memory>

#include "tests/sdk_cpp/robot_process.h"

namespace nao {
namespace {

std::unique_ptr<AL::ALProxy> moduleOf(int port) {
  for (;;) {  // the daemon is ready before its modules are
    try {
      return std::make_unique<AL::ALProxy>("PictureModule", "127.0.0.1", port);
    } catch (const AL::ALError&) {
    }
  }
}

TEST(LocalImage, AModuleReadsWhatTheCameraWrote) {
  // At most as fast as a robot: two looks then fall into one picture's time on a busy machine too.
  RobotProcess robot({"--module", NAO_PICTURE_MODULE}, "1");
  const auto module = moduleOf(robot.port());
  const auto size = module->call<AL::ALValue>("size");
  EXPECT_EQ(size.toString(), AL::ALValue::array(640, 480, 640 * 480 * 3).toString());
  EXPECT_TRUE(module->call<bool>("sharesPixels"));  // as only what was not copied can
  EXPECT_TRUE(module->call<bool>("isAsRemote"));
  EXPECT_TRUE(module->call<bool>("staysUntilReleased"));
  EXPECT_TRUE(module->call<bool>("nobodysIsNull"));
}

TEST(LocalImage, AProgramElsewhereGetsACopy) {
  RobotProcess robot;
  AL::ALVideoDeviceProxy video("127.0.0.1", robot.port());
  const std::string window = video.subscribeCamera("far", 0, AL::kQVGA, AL::kYuvColorSpace, 30);
  const auto* image = static_cast<const AL::ALImage*>(video.getImageLocal(window));
  ASSERT_NE(image, nullptr);
  EXPECT_EQ(image->getSize(), 320U * 240U);
  const auto* raw = static_cast<const AL::ALImage*>(video.getDirectRawImageLocal(window));
  ASSERT_NE(raw, nullptr);
  EXPECT_EQ(raw->getSize(), 2U * 320U * 240U);
  EXPECT_EQ(image->getWidth(), 320);  // still there
  EXPECT_TRUE(video.releaseImage(window));
  EXPECT_TRUE(video.releaseDirectRawImage(window));
  EXPECT_EQ(video.getImageLocal("nobody"), nullptr);
}

}  // namespace
}  // namespace nao
