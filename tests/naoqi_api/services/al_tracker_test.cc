#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

/// A robot that is shown pictures of a red disc.
class AlTrackerTest : public ServicesBench {
 protected:
  AlTrackerTest() {
    bench_.gait->legs = 0;  // upright
    call("ALMotion", "wakeUp");
    call("ALTracker", "registerTarget", {"RedBall", 0.06F});
    for (const char* event : {"TargetDetected", "TargetLost", "TargetReached"}) {
      tokens_.push_back(services_.memory().store().listen(
          std::string("ALTracker/") + event,
          [this](const auto& key, const auto& value) { heard_.push_back(key + value.print()); }));
    }
  }

  // To every window, ten times a second: a disc at this place of the picture (0 to 1), this wide.
  void show(double x, double y, double diameter, double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 10 + 0.5); ++i) {
      const auto windows = images_->subscriptions();
      for (const auto& window : *windows) {
        window.window->publish(draw(x, y, diameter, bench_.frame.time));
      }
      run(0.1);
    }
  }
  static camera::Image draw(double x, double y, double diameter, SimTime time) {
    camera::Image image;
    image.size = {320, 240};
    image.time = time;
    auto bytes = std::make_shared<camera::Bytes>(320 * 240 * 3, 90);
    for (int row = 0; row < 240; ++row) {
      for (int column = 0; column < 320; ++column) {
        if (std::hypot(column - 320 * x, row - 240 * y) > 160 * diameter) continue;
        auto* pixel = &(*bytes)[static_cast<std::size_t>(row * 320 + column) * 3];
        pixel[0] = 220;
        pixel[1] = pixel[2] = 20;
      }
    }
    image.bytes = std::move(bytes);
    return image;
  }
  bool heard(const std::string& text) const {
    return std::find(heard_.begin(), heard_.end(), text) != heard_.end();
  }
  double angle(const char* joint) {
    return number(call("ALMotion", "getAngles", {joint, true}).findItems()->at(0));
  }

  std::vector<std::shared_ptr<void>> tokens_;
  std::vector<std::string> heard_;
};

TEST_F(AlTrackerTest, TheHeadTurnsToTheBallAndEventsTellOfIt) {
  call("ALTracker", "track", {"RedBall"});
  show(0.2, 0.5, 0.1, 1);
  EXPECT_GT(angle("HeadYaw"), 0.2);  // it is to the left
  EXPECT_TRUE(heard("ALTracker/TargetDetected\"RedBall\""));
  EXPECT_EQ(call("ALTracker", "isTargetLost"), Value(false));
  run(1);
  EXPECT_TRUE(heard("ALTracker/TargetLost\"RedBall\""));
  EXPECT_TRUE(call("ALTracker", "getTargetPosition", {0}).findItems()->empty());
}

TEST_F(AlTrackerTest, FramesAgree) {
  call("ALTracker", "track", {"RedBall"});
  show(0.5, 0.5, 0.1, 0.5);
  const auto torso = call("ALTracker", "getTargetPosition", {0}).to<std::vector<float>>();
  const auto robot = call("ALTracker", "getTargetPosition", {2}).to<std::vector<float>>();
  const auto height = call("ALMotion", "getPosition", {"Torso", 2, true}).to<std::vector<float>>();
  ASSERT_EQ(torso.size(), 3U);
  EXPECT_NEAR(robot[2], torso[2] + height[2], 0.06);
}

TEST_F(AlTrackerTest, InModeMoveTheFeetFollowUntilTheTargetIsReached) {
  call("ALTracker", "setMode", {"Move"});
  call("ALTracker", "setRelativePosition", {Value::list({-0.3F, 0.0F, 0.0F, 0.1F, 0.1F, 0.3F})});
  call("ALTracker", "track", {"RedBall"});
  show(0.5, 0.5, 0.06, 1);  // a metre off
  EXPECT_EQ(call("ALMotion", "moveIsActive"), Value(true));
  EXPECT_FALSE(heard("ALTracker/TargetReached\"RedBall\""));
  show(0.5, 0.5, 0.2, 2);  // as near as it is to be
  EXPECT_TRUE(heard("ALTracker/TargetReached\"RedBall\""));
  EXPECT_EQ(call("ALMotion", "moveIsActive"), Value(false));
}

TEST_F(AlTrackerTest, APlaceThatAnEventTellsIsLookedAt) {
  call("ALTracker", "trackEvent", {"my/target"});
  EXPECT_EQ(call("ALTracker", "getActiveTarget"), Value("my/target"));
  for (int i = 0; i < 20; ++i) {
    call("ALMemory", "raiseEvent", {"my/target", Value::list({1.0F, 1.0F, 0.4F, "more"})});
    run(0.1);
  }
  EXPECT_NEAR(angle("HeadYaw"), 0.79, 0.05);
  EXPECT_TRUE(heard("ALTracker/TargetDetected\"my/target\""));
  call("ALMemory", "raiseEvent", {"my/target", "nowhere"});
  run(2);
  EXPECT_TRUE(heard("ALTracker/TargetLost\"my/target\""));
  call("ALTracker", "stopTracker");
  EXPECT_EQ(services_.memory().store().listenerCount("my/target"), 0U);
}

TEST_F(AlTrackerTest, InModeWholeBodyAllJointsHelpTheHead) {
  call("ALMotion", "angleInterpolationWithSpeed", {"Head", 0.0F, 0.5F});
  const double hip = angle("LHipPitch");
  call("ALTracker", "setMode", {"WholeBody"});
  call("ALTracker", "trackEvent", {"my/target"});
  for (int i = 0; i < 30; ++i) {
    call("ALMemory", "raiseEvent", {"my/target", Value::list({0.5F, 0.3F, 0.0F})});
    run(0.1);
  }
  EXPECT_GT(angle("HeadYaw"), 0.2);
  EXPECT_GT(std::abs(angle("LHipPitch") - hip) + std::abs(angle("HeadPitch")), 0.05);
  call("ALTracker", "stopTracker");
  call("ALMotion", "angleInterpolationWithSpeed", {"HeadYaw", -0.5F, 0.5F});
  run(0.5);
  EXPECT_NEAR(angle("HeadYaw"), -0.5, 0.02);  // nobody leads it any more
}

TEST_F(AlTrackerTest, ALostTargetIsNotWalkedTo) {
  call("ALTracker", "setMode", {"Move"});
  call("ALTracker", "track", {"RedBall"});
  show(0.5, 0.5, 0.06, 1);
  run(3);
  EXPECT_EQ(call("ALMotion", "moveIsActive"), Value(false));
}

TEST_F(AlTrackerTest, AnArmPointsAtAPlace) {
  call("ALTracker", "pointAt", {"LArm", Value::list({1.0F, 0.1F, 0.1F}), 0, 0.5F});
  run(3);
  const auto hand = call("ALMotion", "getPosition", {"LArm", 0, true}).to<std::vector<float>>();
  EXPECT_GT(hand[0], 0.15);
  EXPECT_NEAR(angle("LShoulderPitch"), 0, 0.1);
}

TEST_F(AlTrackerTest, SearchesWithTheHeadIfItIsToldTo) {
  call("ALTracker", "toggleSearch", {true});
  call("ALTracker", "track", {"RedBall"});
  run(1);
  EXPECT_GT(std::abs(angle("HeadYaw")), 0.4);
}

}  // namespace
}  // namespace nao::services
