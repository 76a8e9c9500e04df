// Proxies of a daemon's services, as programs use them.

#include <alcommon/albroker.h>
#include <alcommon/alproxy.h>
#include <almemoryfastaccess/almemoryfastaccess.h>
#include <alproxies/almemoryproxy.h>
#include <alproxies/almotionproxy.h>
#include <alproxies/alrobotpostureproxy.h>
#include <alproxies/altexttospeechproxy.h>
#include <alproxies/alvideodeviceproxy.h>
#include <alvision/alimage.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "tests/core/temporary_folder.h"
#include "tests/sdk_cpp/robot_process.h"

namespace nao {
namespace {

using AL::ALValue;

class ProxyTest : public testing::Test {
 protected:
  RobotProcess robot_;
  const std::string host_ = "127.0.0.1";
};

// What the head's gear and friction leave of an angle that was reached.
constexpr float kServo = 0.02F;

TEST_F(ProxyTest, TheHeadGoesWhereItIsTold) {
  AL::ALMotionProxy motion(host_, robot_.port());
  motion.stiffnessInterpolation("HeadYaw", 1.0F, 0.1F);
  motion.angleInterpolation("HeadYaw", ALValue::array(-0.5F, 0.5F), ALValue::array(0.5F, 1.5F),
                            true);
  const std::vector<float> angles = motion.getAngles("HeadYaw", true);
  ASSERT_EQ(angles.size(), 1U);
  EXPECT_NEAR(angles[0], 0.5F, kServo);
}

TEST_F(ProxyTest, OneOfSeveralRobotsIsMeantByItsPortOrItsHost) {
  RobotProcess other;
  AL::ALMemoryProxy(host_, robot_.port()).insertData("Which", std::string("first"));
  AL::ALMemoryProxy(host_, other.port()).insertData("Which", std::string("second"));
  const std::string both = robot_.setting() + ",127.0.0.1:" + std::to_string(other.port());
  const std::size_t name = both.find('=');
  ::setenv(both.substr(0, name).c_str(), both.substr(name + 1).c_str(), 1);
  const auto which = [](const std::string& host, int port) {
    return AL::ALMemoryProxy(host, port).getData("Which").toString();
  };
  const std::vector<std::string> found = {which("localhost", 9559), which("127.0.0.1", 9559),
                                          which("10.0.0.1", 9560), which("10.0.0.2", 9559)};
  ::unsetenv("NAOQI_ADDRESS");
  const std::vector<std::string> wanted = {"\"first\"", "\"first\"", "\"second\"", "\"second\""};
  EXPECT_EQ(found, wanted);
}

TEST_F(ProxyTest, ListsOfNamesAndAnglesAreVectors) {
  AL::ALMotionProxy motion(host_, robot_.port());
  const std::vector<std::string> names = {"HeadYaw", "HeadPitch"};
  motion.setStiffnesses(names, 1.0F);
  motion.angleInterpolationWithSpeed(names, std::vector<float>{0.3F, -0.2F}, 0.5F);
  const std::vector<float> angles = motion.getAngles(names, false);
  ASSERT_EQ(angles.size(), 2U);
  EXPECT_NEAR(angles[1], -0.2F, 1e-4F);
}

TEST_F(ProxyTest, APostedCallIsWaitedFor) {
  AL::ALMotionProxy motion(host_, robot_.port());
  motion.setStiffnesses("Head", 1.0F);
  const int id = motion.post.angleInterpolation("HeadYaw", 0.4F, 1.0F, true);
  EXPECT_GT(id, 0);
  EXPECT_FALSE(motion.wait(id, 0));
  EXPECT_FALSE(motion.isRunning(id));
  EXPECT_NEAR(motion.getAngles("HeadYaw", false)[0], 0.4F, 1e-4F);
}

TEST_F(ProxyTest, AGenericProxyCallsByName) {
  AL::ALProxy motion("ALMotion", host_, robot_.port());
  EXPECT_TRUE(motion.call<bool>("ping"));
  EXPECT_EQ(motion.call<std::vector<std::string>>("getBodyNames", std::string("Head")),
            (std::vector<std::string>{"HeadYaw", "HeadPitch"}));
  motion.callVoid("setStiffnesses", "Head", 0.5F);
}

TEST_F(ProxyTest, MemoryGivesBackWhatItWasGiven) {
  AL::ALMemoryProxy memory(host_, robot_.port());
  const ALValue value = ALValue::array("a", 1, 2.5F, ALValue::array(true));
  memory.insertData("Test/Value", value);
  EXPECT_TRUE(memory.getData("Test/Value") == value) << memory.getData("Test/Value");
}

TEST_F(ProxyTest, ARobotsRefusalIsAnAlError) {
  AL::ALMemoryProxy memory(host_, robot_.port());
  try {
    memory.getData("No/Such/Key");
    FAIL();
  } catch (const AL::ALError& error) {
    EXPECT_STREQ(error.what(), "\tALMemory::getData\n\tData not found No/Such/Key");
  }
}

TEST_F(ProxyTest, PointersAreForLocalModules) {
  AL::ALMemoryProxy memory(host_, robot_.port());
  try {
    memory.getDataPtr("Device/SubDeviceList/HeadYaw/Position/Sensor/Value");
    FAIL();
  } catch (const AL::ALError& error) {
    EXPECT_EQ(error.getDescription(),
              "Cannot be called remotely: only a local module has pointers");
  }
}

TEST_F(ProxyTest, FastAccessReadsAndWritesAListOfKeys) {
  const auto broker = AL::ALBroker::createBroker("broker", "0.0.0.0", 0, host_, robot_.port(), 0);
  AL::ALMemoryProxy(broker).insertListData(
      ALValue::array(ALValue::array("Test/A", 1), ALValue::array("Test/B", 2.5F)));
  AL::ALMemoryFastAccess fast;
  std::vector<float> values;
  EXPECT_THROW(fast.GetValues(values), AL::ALError);
  fast.ConnectToVariables(broker, {"Test/A", "Test/B"});
  fast.GetValues(values);
  EXPECT_EQ(values, (std::vector<float>{1, 2.5F}));
  fast.SetValues(std::vector<int>{3, 4});
  std::vector<int> whole;
  fast.GetValues(whole);
  EXPECT_EQ(whole, (std::vector<int>{3, 4}));
  EXPECT_THROW(fast.SetValues(std::vector<int>{3}), AL::ALError);
}

TEST_F(ProxyTest, AnUnknownServiceIsToldAtOnce) {
  EXPECT_THROW(AL::ALProxy("ALNoSuch", host_, robot_.port()), AL::ALError);
}

TEST_F(ProxyTest, NobodyThereIsToldWithTheAddress) {
  try {
    AL::ALBroker::createBroker("broker", "0.0.0.0", 0, host_, 1);
    FAIL();
  } catch (const AL::ALError& error) {
    EXPECT_NE(error.toString().find("Cannot connect to tcp://127.0.0.1:1"), std::string::npos);
  }
}

TEST_F(ProxyTest, ABrokerMakesProxies) {
  const auto broker = AL::ALBroker::createBroker("broker", "0.0.0.0", 0, host_, robot_.port(), 0);
  AL::ALMotionProxy motion(broker);
  EXPECT_FALSE(motion.robotIsWakeUp());
  EXPECT_EQ(broker->getMotionProxy()->getBodyNames("Head").size(), 2U);
  EXPECT_TRUE(broker->isModulePresent("ALMemory"));
  EXPECT_FALSE(broker->isModulePresent("ALNoSuch"));
}

TEST_F(ProxyTest, ACameraSendsPictures) {
  AL::ALVideoDeviceProxy camera(host_, robot_.port());
  const std::string name =
      camera.subscribeCamera("test", AL::kTopCamera, AL::kQQVGA, AL::kBGRColorSpace, 30);
  ALValue picture;
  while (picture.getSize() < 7) picture = camera.getImageRemote(name);
  const AL::ALImage image(picture);
  EXPECT_EQ(image.getWidth(), 160);
  EXPECT_EQ(image.getHeight(), 120);
  EXPECT_EQ(image.getSize(), 160U * 120U * 3U);
  camera.unsubscribe(name);
}

TEST_F(ProxyTest, ALostRobotEndsCallsWithAnError) {
  AL::ALMotionProxy motion(host_, robot_.port());
  robot_.process().interrupt();
  robot_.process().wait();
  EXPECT_THROW(motion.getSummary(), AL::ALError);
}

TEST(Credentials, TheEnvironmentsAreSaid) {
  const TemporaryFolder folder;
  const RobotProcess robot({"--auth", folder.write("users", "ada secret\n")});
  const std::vector<std::string> words = {NAO_CPP_MOTION, "127.0.0.1",
                                          std::to_string(robot.port())};
  EXPECT_EQ(Process(words, {"USARNAOQI_USER=ada", "USARNAOQI_TOKEN=secret"}).wait(), 0);
  EXPECT_EQ(Process(words, {"USARNAOQI_USER=ada", "USARNAOQI_TOKEN=wrong"}).wait(), 1);
  try {
    AL::ALMotionProxy("127.0.0.1", robot.port());
    FAIL();
  } catch (const AL::ALError& error) {
    EXPECT_NE(error.toString().find("Authentication failed"), std::string::npos);
  }
}

}  // namespace
}  // namespace nao
