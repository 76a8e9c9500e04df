#include "naoqi_api/services/al_video_device.h"

#include <gtest/gtest.h>

#include "naoqi_api/tasks.h"

namespace nao::services {
namespace {

using rpc::Value;

constexpr int kYuv422 = 9;
constexpr int kRgb = 11;
constexpr int kQvga = 1;
constexpr int kVga = 2;

std::shared_ptr<const RobotModel> robotWithTwoCameras() {
  RobotModel robot;
  robot.version = "V3.3";
  for (const char* name : {"CameraTop", "CameraBottom"}) {
    CameraModel camera;
    camera.name = name;
    camera.hfov = 0.8;
    camera.vfov = 0.6;
    camera.frame_rates = {5, 10, 15, 30};
    robot.cameras.push_back(camera);
  }
  return std::make_shared<const RobotModel>(robot);
}

class AlVideoDeviceTest : public testing::Test {
 protected:
  rpc::Pending<Value> start(const std::string& method, const std::vector<Value>& arguments,
                            const std::shared_ptr<rpc::Session>& session = nullptr) {
    rpc::Caller caller;
    caller.session = session;
    return service_.call(method, arguments, caller);
  }

  Value call(const std::string& method, const std::vector<Value>& arguments,
             const std::shared_ptr<rpc::Session>& session = nullptr) {
    const auto pending = start(method, arguments, session);
    EXPECT_TRUE(pending.isDone()) << method;
    if (!pending.isDone()) return {};
    EXPECT_TRUE(pending.outcome()->value) << pending.outcome()->error.value_or("canceled");
    return pending.outcome()->value.value_or(Value());
  }

  std::string errorOf(const std::string& method, const std::vector<Value>& arguments) {
    const auto pending = start(method, arguments);
    return pending.isDone() ? pending.outcome()->error.value_or("") : "";
  }

  std::string subscribe(const std::string& name, int camera = 0, int resolution = kQvga,
                        int space = kYuv422, int rate = 15) {
    return call("subscribeCamera", {name, camera, resolution, space, rate}).to<std::string>();
  }

  /// Plays the camera thread: a picture for every window.
  camera::Image showPictures(SimTime time) {
    camera::Image image;
    for (const auto& subscription : *feed_->subscriptions()) {
      image.size = subscription.request.size;
      image.camera = subscription.request.camera;
      image.color_space = subscription.request.color_space;
      image.time = time;
      image.bytes = std::make_shared<const camera::Bytes>(
          image.size.width * image.size.height * camera::layers(image.color_space), 7);
      subscription.window->publish(image);
    }
    return image;
  }

  std::shared_ptr<camera::ImageFeed> feed_ = std::make_shared<camera::ImageFeed>();
  AlVideoDevice device_{robotWithTwoCameras(), feed_, std::chrono::seconds(1'300'000'000)};
  rpc::Service service_ = device_.describe();
};

TEST_F(AlVideoDeviceTest, ReturnsTheTwelveFieldsOfAnImage) {
  const std::string handle = subscribe("test", 1, kQvga, kRgb);
  const camera::Image shown = showPictures(SimTime(std::chrono::milliseconds(2345)));
  const Value reply = call("getImageRemote", {handle});
  ASSERT_NE(reply.findItems(), nullptr);
  const std::vector<Value>& field = *reply.findItems();
  ASSERT_EQ(field.size(), 12u);
  EXPECT_EQ(field[0], Value(320));
  EXPECT_EQ(field[1], Value(240));
  EXPECT_EQ(field[2], Value(3));
  EXPECT_EQ(field[3], Value(kRgb));
  EXPECT_EQ(field[4], Value(1'300'000'002));
  EXPECT_EQ(field[5], Value(345'000));
  EXPECT_EQ(field[7], Value(1));
  EXPECT_EQ(field[8], Value(0.4F));
  EXPECT_EQ(field[9], Value(0.3F));
  EXPECT_EQ(field[10], Value(-0.4F));
  EXPECT_EQ(field[11], Value(-0.3F));
  EXPECT_EQ(field[6].findBytes(), shown.bytes);  // the very same bytes: nothing was copied
}

TEST_F(AlVideoDeviceTest, TheFirstPictureIsWaitedFor) {
  const std::string handle = subscribe("test");
  const auto early = start("getImageRemote", {handle});
  device_.deliverImages();
  EXPECT_FALSE(early.isDone());
  showPictures(SimTime(Duration(0)));
  device_.deliverImages();
  ASSERT_TRUE(early.isDone());
  EXPECT_EQ(early.outcome()->value->findItems()->size(), 12u);
  EXPECT_TRUE(start("getImageRemote", {handle}).isDone());
}

TEST_F(AlVideoDeviceTest, AnUnknownHandleGivesNothing) {
  EXPECT_TRUE(call("getImageRemote", {"nobody_0"}).isVoid());
  EXPECT_EQ(call("releaseImage", {"nobody_0"}), Value(false));
  EXPECT_EQ(call("unsubscribe", {"nobody_0"}), Value(false));
  EXPECT_NE(errorOf("getResolution", {"nobody_0"}), "");
}

TEST_F(AlVideoDeviceTest, ReleasingTwiceHarmsNothingAndAnUnknownHandleIsFalse) {
  const std::string handle = subscribe("test");
  showPictures(SimTime(std::chrono::seconds(1)));
  call("getImageRemote", {handle});
  EXPECT_EQ(call("releaseImage", {handle}), Value(true));
  EXPECT_EQ(call("releaseImage", {handle}), Value(true));
  EXPECT_EQ(call("getImageRemote", {handle}).to<std::vector<Value>>().size(), 12u);
  EXPECT_EQ(call("releaseImage", {"nobody_0"}), Value(false));
  EXPECT_EQ(call("releaseDirectRawImage", {"nobody_0"}), Value(false));
}

TEST_F(AlVideoDeviceTest, HandlesCountUpAndAreReusedAndEnd) {
  for (std::size_t i = 0; i < AlVideoDevice::kMostOfOneName; ++i) {
    EXPECT_EQ(subscribe("vision"), "vision_" + std::to_string(i));
  }
  EXPECT_EQ(subscribe("vision"), "");
  EXPECT_EQ(subscribe("other"), "other_0");
  EXPECT_EQ(call("unsubscribe", {"vision_3"}), Value(true));
  EXPECT_EQ(subscribe("vision"), "vision_3");
  call("unsubscribeAllInstances", {"vision"});
  EXPECT_EQ(call("getSubscribers", {}).to<std::vector<std::string>>(),
            std::vector<std::string>{"other_0"});
}

TEST_F(AlVideoDeviceTest, AThousandSubscribersAreRefusedAtTheLimit) {
  std::size_t granted = 0;
  for (int i = 0; i < 1000; ++i) granted += subscribe("s" + std::to_string(i)).empty() ? 0 : 1;
  EXPECT_EQ(granted, AlVideoDevice::kMost);
}

TEST_F(AlVideoDeviceTest, WhatNoCameraCanDoGetsAnEmptyHandle) {
  EXPECT_EQ(subscribe("test", 2), "");
  EXPECT_EQ(subscribe("test", -1), "");
  EXPECT_EQ(subscribe("test", 0, 77), "");
  EXPECT_EQ(subscribe("test", 0, kVga, 99), "");
  EXPECT_EQ(subscribe("test", 0, kVga, kRgb, 0), "");
  EXPECT_FALSE(feed_->subscriptions());
}

TEST_F(AlVideoDeviceTest, WishesAreRoundedToWhatTheCameraOffers) {
  const std::string slow = subscribe("slow", 0, 3, kRgb, 7);  // 1280x960 on a 640x480 sensor
  EXPECT_EQ(call("getResolution", {slow}), Value(kVga));
  EXPECT_EQ(call("getFrameRate", {slow}), Value(10));
  EXPECT_EQ(call("getFrameRate", {subscribe("fast", 0, kVga, kRgb, 60)}), Value(30));
  EXPECT_EQ(feed_->subscriptions()->front().request.size, (camera::ImageSize{640, 480}));
}

TEST_F(AlVideoDeviceTest, AChangedWindowWaitsForAPictureOfItsNewKind) {
  const std::string handle = subscribe("test");
  showPictures(SimTime(Duration(0)));
  EXPECT_EQ(call("setResolution", {handle, kVga}), Value(true));
  EXPECT_EQ(call("setColorSpace", {handle, kRgb}), Value(true));
  EXPECT_EQ(call("setColorSpace", {handle, 99}), Value(false));
  const auto reply = start("getImageRemote", {handle});
  EXPECT_FALSE(reply.isDone());
  showPictures(SimTime(Duration(0)));
  device_.deliverImages();
  EXPECT_EQ((*reply.outcome()->value->findItems())[0], Value(640));
  EXPECT_EQ((*reply.outcome()->value->findItems())[3], Value(kRgb));
}

TEST_F(AlVideoDeviceTest, OldStyleWindowsFollowTheActiveCamera) {
  const auto handle = call("subscribe", {"old", kQvga, kYuv422, 10}).to<std::string>();
  const std::string fixed = subscribe("new", 0);
  EXPECT_EQ(call("getActiveCamera", {}), Value(0));
  call("setParam", {18, 1});
  EXPECT_EQ(call("getActiveCamera", {}), Value(1));
  EXPECT_EQ(call("getActiveCamera", {handle}), Value(1));
  EXPECT_EQ(call("getActiveCamera", {fixed}), Value(0));
  EXPECT_EQ(call("setActiveCamera", {0}), Value(true));
  EXPECT_EQ(call("getActiveCamera", {handle}), Value(0));
  EXPECT_EQ(call("setActiveCamera", {handle, 1}), Value(true));  // from now on it stays there
  call("setParam", {18, 0});
  EXPECT_EQ(call("getActiveCamera", {handle}), Value(1));
  EXPECT_EQ(call("setActiveCamera", {5}), Value(false));
}

TEST_F(AlVideoDeviceTest, UnsubscribingEndsWaitingCallsWithNothing) {
  const std::string handle = subscribe("test");
  const auto waiting = start("getImageRemote", {handle});
  call("unsubscribe", {handle});
  ASSERT_TRUE(waiting.isDone());
  EXPECT_TRUE(waiting.outcome()->value->isVoid());
}

TEST_F(AlVideoDeviceTest, ACallThatWasGivenUpIsNotDelivered) {
  const std::string handle = subscribe("test");
  const auto waiting = start("getImageRemote", {handle});
  waiting.cancel();
  showPictures(SimTime(Duration(0)));
  device_.deliverImages();
  EXPECT_TRUE(waiting.outcome()->isCanceled());
}

TEST_F(AlVideoDeviceTest, WindowsCloseWithTheirClient) {
  const auto client = std::make_shared<rpc::Session>(7, "tcp://127.0.0.1:9559");
  const std::vector<Value> wish = {"gone", 0, kQvga, kYuv422, 5};
  call("subscribeCamera", wish, client);
  call("subscribeCamera", wish, client);
  subscribe("stays");
  client->end();
  EXPECT_EQ(call("getSubscribers", {}).to<std::vector<std::string>>(),
            std::vector<std::string>{"stays_0"});
  EXPECT_EQ(feed_->subscriptions()->size(), 1u);
}

TEST_F(AlVideoDeviceTest, AClientMayOutliveTheDevice) {
  const auto client = std::make_shared<rpc::Session>(7, "tcp://127.0.0.1:9559");
  {
    AlVideoDevice device(robotWithTwoCameras(), feed_, Duration(0));
    rpc::Service service = device.describe();
    rpc::Caller caller;
    caller.session = client;
    service.call("subscribeCamera", {"gone", 0, kQvga, kYuv422, 5}, caller);
  }
  client->end();
  EXPECT_EQ(feed_->subscriptions()->size(), 1u);  // nobody was there to close it
}

TEST_F(AlVideoDeviceTest, ParametersAreRememberedPerCameraWithinTheirRange) {
  EXPECT_EQ(call("getParameter", {0, 0}), Value(128));
  EXPECT_EQ(call("setParameter", {0, 0, 200}), Value(true));
  EXPECT_EQ(call("setParameter", {0, 0, 256}), Value(false));
  EXPECT_EQ(call("getParameter", {0, 0}), Value(200));
  EXPECT_EQ(call("getParameter", {1, 0}), Value(128));
  EXPECT_EQ(call("getParameterRange", {0, 0}).to<std::vector<int>>(), (std::vector<int>{0, 255}));
  EXPECT_EQ(call("setAllParametersToDefault", {0}), Value(true));
  EXPECT_EQ(call("getParameter", {0, 0}), Value(128));
  EXPECT_NE(errorOf("getParameter", {0, 999}), "");
  EXPECT_NE(errorOf("setParameter", {9, 0, 1}), "");
}

TEST_F(AlVideoDeviceTest, ParametersGoToTheCamera) {
  EXPECT_EQ(feed_->controls(), nullptr);
  EXPECT_EQ(call("setParameter", {1, 17, 300}), Value(true));
  const auto& sensor = camera::sensorType("OV7670");
  ASSERT_EQ(feed_->controls()->size(), 2u);
  EXPECT_EQ((*feed_->controls())[1].settings.get(sensor, camera::Parameter::kExposure), 300);
  EXPECT_EQ(call("setParameterToDefault", {1, 17}), Value(true));
  EXPECT_EQ((*feed_->controls())[1].settings.get(sensor, camera::Parameter::kExposure), 255);
}

TEST_F(AlVideoDeviceTest, ARawImageIsTheSensorsWhateverTheWindowShows) {
  const std::string handle = subscribe("test", 0, kQvga, kRgb);
  const auto first = start("getDirectRawImageRemote", {handle});
  EXPECT_FALSE(first.isDone());
  showPictures(SimTime(std::chrono::seconds(1)));
  device_.deliverImages();
  ASSERT_TRUE(first.isDone());
  const auto fields = first.outcome()->value->to<std::vector<Value>>();
  EXPECT_EQ(fields[2], Value(2));
  EXPECT_EQ(fields[3], Value(kYuv422));
  EXPECT_EQ(call("getImageRemote", {handle}).to<std::vector<Value>>()[3], Value(kRgb));
  EXPECT_EQ(feed_->subscriptions()->size(), 2u);
  call("unsubscribe", {handle});
  EXPECT_TRUE(feed_->subscriptions()->empty());
}

TEST_F(AlVideoDeviceTest, ParametersAreReachedThroughAHandleAndTheOldNames) {
  const std::string bottom = subscribe("test", 1);
  EXPECT_EQ(call("setCameraParameter", {bottom, 6, 100}), Value(true));
  EXPECT_EQ(call("getCameraParameter", {bottom, 6}), Value(100));
  EXPECT_EQ(call("getParam", {6, 1}), Value(100));
  EXPECT_EQ(call("getParam", {6}), Value(16));  // the active camera is the top one
  call("setParam", {6, 50});
  EXPECT_EQ(call("getParameter", {0, 6}), Value(50));
}

TEST_F(AlVideoDeviceTest, CamerasTellWhatTheyAre) {
  EXPECT_EQ(call("getHorizontalFOV", {0}), Value(0.8F));
  EXPECT_EQ(call("getVerticalFOV", {1}), Value(0.6F));
  EXPECT_EQ(call("getCameraModel", {0}), Value(1));
  EXPECT_EQ(call("getCameraName", {1}), Value("CameraBottom"));
  EXPECT_EQ(call("getCameraIndexes", {}).to<std::vector<int>>(), (std::vector<int>{0, 1}));
  EXPECT_EQ(call("isCameraOpen", {1}), Value(true));
  EXPECT_EQ(call("isCameraOpen", {2}), Value(false));
  EXPECT_EQ(call("resolutionToSizes", {kVga}).to<std::vector<int>>(), (std::vector<int>{640, 480}));
  EXPECT_EQ(call("sizesToResolution", {640, 480}), Value(kVga));
  EXPECT_EQ(call("sizesToResolution", {3, 4}), Value(-1));
  EXPECT_NE(errorOf("getHorizontalFOV", {2}), "");
}

TEST_F(AlVideoDeviceTest, SignaturesAreNaoQis) {
  const auto has = [&](const std::string& name, const std::string& parameters,
                       const std::string& result) {
    for (const auto& [unused, method] : service_.methods()) {
      if (method.name == name && method.parameters_signature == parameters) {
        return method.return_signature == result;
      }
    }
    return false;
  };
  EXPECT_TRUE(has("subscribeCamera", "(siiii)", "s"));
  EXPECT_TRUE(has("subscribe", "(siii)", "s"));
  EXPECT_TRUE(has("getImageRemote", "(s)", "m"));
  EXPECT_TRUE(has("releaseImage", "(s)", "b"));
  EXPECT_TRUE(has("unsubscribe", "(s)", "b"));
  EXPECT_TRUE(has("getSubscribers", "()", "m"));
  EXPECT_TRUE(has("getParameterRange", "(ii)", "m"));
  EXPECT_TRUE(has("getHorizontalFOV", "(i)", "f"));
  EXPECT_TRUE(has("setParam", "(ii)", "v"));
  EXPECT_TRUE(has("setActiveCamera", "(si)", "b"));
}

}  // namespace
}  // namespace nao::services
