#include "naoqi_api/services/al_frame_manager.h"

#include <gtest/gtest.h>

#include <cmath>

#include "naoqi_api/services/al_motion.h"
#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

using rpc::Value;
using Names = std::vector<std::string>;

// A head that looks 45 degrees to the left within two seconds.
const char* const kLookLeft =
    "<ChoregrapheProject xar_version=\"3\"><Box name=\"root\" id=\"-1\"><Timeline enable=\"1\" "
    "fps=\"25\" start_frame=\"1\"><ActuatorList><ActuatorCurve actuator=\"HeadYaw\" unit=\"0\">"
    "<Key frame=\"51\" value=\"45\"/></ActuatorCurve><ActuatorCurve actuator=\"Wheel\">"
    "<Key frame=\"51\" value=\"45\"/></ActuatorCurve></ActuatorList></Timeline></Box>"
    "</ChoregrapheProject>";

class AlFrameManagerTest : public testing::Test {
 protected:
  AlFrameManagerTest() {
    bench.cycle();
    bench.call(*makeAlMotion(bench.link), "setStiffnesses", {"Body", 1.0F});
  }
  Value call(const std::string& name, const std::vector<Value>& arguments = {}) {
    return bench.call(*frames, name, arguments);
  }
  std::string load() { return *call("newBehavior", {"look.xar", kLookLeft}).findText(); }
  double yaw() const { return bench.link.state()->command.angle[0]; }

  RobotBench bench;
  Names warnings;
  std::shared_ptr<rpc::Service> frames =
      makeAlFrameManager(bench.link, [this](const std::string& text) { warnings.push_back(text); });
};

TEST_F(AlFrameManagerTest, PlaysABehaviorToItsEnd) {
  const std::string id = load();
  EXPECT_FLOAT_EQ(call("getMotionLength", {id}).to<float>(), 2.0F);
  EXPECT_FALSE(call("isBehaviorRunning", {id}).to<bool>());
  call("playBehavior", {id});
  EXPECT_TRUE(call("isBehaviorRunning", {id}).to<bool>());
  const auto complete = frames->call("completeBehavior", {id});
  bench.run(1.9);
  EXPECT_FALSE(complete.isDone());
  bench.run(0.2);
  EXPECT_TRUE(complete.isDone());
  EXPECT_FALSE(call("isBehaviorRunning", {id}).to<bool>());
  EXPECT_NEAR(yaw(), 45 * M_PI / 180, 1e-9);
}

TEST_F(AlFrameManagerTest, PlaysMotionsOfEveryKind) {
  const std::string id =
      *call("newBehavior", {"wave.motion", "#WEBOTS_MOTION,V1.0,HeadYaw\n00:01:500,a,0.3\n"})
           .findText();
  EXPECT_FLOAT_EQ(call("getMotionLength", {id}).to<float>(), 1.5F);
  call("completeBehavior", {id});
  EXPECT_NEAR(yaw(), 0.3, 1e-9);
}

TEST_F(AlFrameManagerTest, FramesPerSecondAreThoseOfTheFile) {
  EXPECT_EQ(call("getTimelineFps", {load()}).to<int>(), 25);
}

TEST_F(AlFrameManagerTest, SaysWhatItLeavesOut) {
  load();
  EXPECT_EQ(warnings, Names{"look.xar:1: this robot has no joint Wheel"});
}

TEST_F(AlFrameManagerTest, CompleteStartsABehaviorThatNeverRan) {
  const std::string id = load();
  call("completeBehavior", {id});
  EXPECT_NEAR(yaw(), 45 * M_PI / 180, 1e-9);
  EXPECT_TRUE(frames->call("completeBehavior", {id}).isDone());  // it has run
}

TEST_F(AlFrameManagerTest, ExitEndsABehaviorHalfWay) {
  const std::string id = load();
  call("playBehavior", {id});
  bench.run(1);
  const auto complete = frames->call("completeBehavior", {id});
  call("exitBehavior", {id});
  bench.run(0.5);
  EXPECT_TRUE(complete.isDone());
  EXPECT_NEAR(yaw(), 22.5 * M_PI / 180, 0.05);
}

TEST_F(AlFrameManagerTest, CancelingTheWaitEndsTheBehavior) {
  const std::string id = load();
  const auto complete = frames->call("completeBehavior", {id});
  bench.run(1);
  complete.cancel();
  bench.run(0.1);
  EXPECT_FALSE(call("isBehaviorRunning", {id}).to<bool>());
}

TEST_F(AlFrameManagerTest, DeletedBehaviorsAreGoneAndNobodyWaitsForThem) {
  const std::string first = load();
  const std::string second = load();
  EXPECT_EQ(call("behaviors").to<Names>(), (Names{first, second}));
  const auto complete = frames->call("completeBehavior", {first});
  call("deleteBehavior", {first});
  EXPECT_TRUE(complete.isDone());
  EXPECT_EQ(bench.errorOf(*frames, "playBehavior", {first}),
            "\tALFrameManager::playBehavior\n\tunknown behavior: " + first);
  call("cleanBehaviors");
  EXPECT_TRUE(call("behaviors").to<Names>().empty());
  bench.run(0.1);
  EXPECT_TRUE(bench.link.state()->tasks.empty());
}

TEST_F(AlFrameManagerTest, MistakesInABehaviorAreToldWithTheirLine) {
  EXPECT_EQ(bench.errorOf(*frames, "newBehavior", {"", "\n<Box/>"}),
            "\tALFrameManager::newBehavior\n\tbehavior:1: expected a <ChoregrapheProject>, the "
            "root of a behavior");
}

TEST_F(AlFrameManagerTest, FilesOfTheHostAreOutOfReach) {
  EXPECT_EQ(bench.errorOf(*frames, "newBehaviorFromFile", {"/etc/passwd", "x"}),
            "\tALFrameManager::newBehaviorFromFile\n\tno installed behavior is called /etc/passwd: "
            "send the text of the file with newBehavior");
}

TEST_F(AlFrameManagerTest, AClientCannotLeaveBehaviorsWithoutEnd) {
  for (int i = 0; i < 256; ++i) load();
  EXPECT_EQ(bench.errorOf(*frames, "newBehavior", {"", kLookLeft}),
            "\tALFrameManager::newBehavior\n\ttoo many behaviors: delete some first");
}

}  // namespace
}  // namespace nao::services
