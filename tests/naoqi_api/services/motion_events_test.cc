#include "naoqi_api/services/motion_events.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "naoqi_api/services/al_motion.h"
#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class MotionEventsTest : public ::testing::Test {
 protected:
  MotionEventsTest() {
    bench_.cycle();
    events_.deliver();
  }
  void listen(const std::string& event) {
    tokens_.push_back(memory_.store().listen(event, [this](const auto& key, const auto& value) {
      heard_.push_back(key + " " + value.print());
    }));
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 100 + 0.5); ++i) {
      bench_.cycle();
      events_.deliver();
    }
  }

  RobotBench bench_;
  memory::RobotMemory memory_{*bench_.model, bench_.ports, "nao",
                              [this] { return bench_.link.now().time_since_epoch(); }};
  MotionEvents events_{bench_.link, memory_};
  std::shared_ptr<rpc::Service> motion_ = makeAlMotion(bench_.link);
  std::vector<std::shared_ptr<void>> tokens_;
  std::vector<std::string> heard_;
};

TEST_F(MotionEventsTest, AFallIsToldOnceAndSoIsItsEnd) {
  for (const char* event : {"robotIsFalling", "robotHasFallen"}) listen(event);
  motion_->call("wakeUp", {});
  run(3);
  EXPECT_THAT(heard_, IsEmpty());
  bench_.frame.angle_y = 0.9;
  run(0.2);
  bench_.frame.angle_y = 1.5;
  run(2);
  EXPECT_THAT(heard_,
              ElementsAre("robotIsFalling true", "robotHasFallen true", "robotIsFalling false"));
  heard_.clear();
  bench_.frame.angle_y = 0;
  run(2);
  EXPECT_THAT(heard_, ElementsAre("robotHasFallen false"));
}

TEST_F(MotionEventsTest, WakingAndRestingAreToldInOrder) {
  for (const char* event :
       {"ALMotion/Stiffness/wakeUpStarted", "ALMotion/Stiffness/wakeUpFinished",
        "ALMotion/Stiffness/restStarted", "ALMotion/Stiffness/restFinished", "robotIsWakeUp"}) {
    listen(event);
  }
  bench_.call(*motion_, "wakeUp", {});
  EXPECT_THAT(heard_, IsEmpty());  // the bench's own cycles deliver no events
  motion_->call("rest", {});
  run(3);
  EXPECT_THAT(heard_, ElementsAre("robotIsWakeUp true", "ALMotion/Stiffness/restStarted true",
                                  "robotIsWakeUp false", "ALMotion/Stiffness/restFinished true"));
  heard_.clear();
  motion_->call("wakeUp", {});
  run(3);
  EXPECT_THAT(heard_, ElementsAre("ALMotion/Stiffness/wakeUpStarted true", "robotIsWakeUp true",
                                  "ALMotion/Stiffness/wakeUpFinished true"));
}

TEST_F(MotionEventsTest, BodyStiffnessHasThreeLevels) {
  listen("BodyStiffnessChanged");
  for (const double stiffness : {1.0, 0.9, 0.5, 0.04}) {
    motion_->call("setStiffnesses", {"Body", stiffness});
    run(0.1);
  }
  EXPECT_THAT(heard_, ElementsAre("BodyStiffnessChanged 2", "BodyStiffnessChanged 1",
                                  "BodyStiffnessChanged 0"));
}

TEST_F(MotionEventsTest, AMoveThatIsRefusedAndOneThatIsEndedFail) {
  motion_->call("setFallManagerEnabled", {false});
  listen("ALMotion/MoveFailed");
  listen("ALMotion/Safety/MoveFailed");
  motion_->call("moveToward", {0.5, 0.0, 0.0});  // on limp legs
  run(3);
  EXPECT_THAT(heard_, ElementsAre("ALMotion/MoveFailed [\"Internal stop\", 0, nothing]",
                                  "ALMotion/Safety/MoveFailed [\"Internal stop\", 0, nothing]"));
  heard_.clear();
  motion_->call("wakeUp", {});
  run(3);
  motion_->call("moveToward", {0.5, 0.0, 0.0});
  run(3);
  EXPECT_THAT(heard_, IsEmpty());
  bench_.frame.angle_y = 1.5;
  run(1);
  EXPECT_THAT(heard_, ElementsAre("ALMotion/MoveFailed [\"Internal stop\", 1, nothing]",
                                  "ALMotion/Safety/MoveFailed [\"Internal stop\", 1, nothing]"));
}

TEST_F(MotionEventsTest, PosturesAreToldOncePerSecond) {
  listen("PostureChanged");
  listen("PostureFamilyChanged");
  listen("footContactChanged");
  motion_->call("wakeUp", {});  // from Crouch to StandInit
  run(5);
  EXPECT_THAT(heard_, Contains("PostureChanged \"StandInit\""));
  EXPECT_EQ(heard_.back(), "PostureFamilyChanged \"Standing\"");
  EXPECT_LE(heard_.size(), 4U);  // there may be a moment of Unknown between
  heard_.clear();
  for (FootForces& foot : bench_.frame.feet) foot.total = 0;
  run(2);
  EXPECT_THAT(heard_, ElementsAre("footContactChanged false"));
}

TEST_F(MotionEventsTest, PosesHaveTheNamesOf1xToo) {
  listen("robotPoseChanged");
  run(1);
  EXPECT_EQ(memory_.read("robotPose")->value, rpc::Value("Crouch"));
  motion_->call("wakeUp", {});
  run(5);
  ASSERT_FALSE(heard_.empty());
  EXPECT_EQ(heard_.back(), "robotPoseChanged \"Stand\"");
  EXPECT_EQ(memory_.read("robotPose")->value, rpc::Value("Stand"));
}

TEST_F(MotionEventsTest, ADeviceEventIsReadAndHasAHistory) {
  bench_.frame.feet[0].bumper[0] = true;
  run(0.1);
  bench_.frame.feet[0].bumper[0] = false;
  run(0.1);
  EXPECT_EQ(memory_.read("LeftBumperPressed")->value, rpc::Value(0.0F));
  const memory::Entry* entry = memory_.store().find("LeftBumperPressed");
  ASSERT_NE(entry, nullptr);
  ASSERT_EQ(entry->history.size(), 2U);
  EXPECT_EQ(entry->history[0].value, rpc::Value(1.0F));
}

}  // namespace
}  // namespace nao::services
