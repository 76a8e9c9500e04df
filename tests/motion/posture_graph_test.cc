#include "motion/posture_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/posture_family.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

using Kind = MotionOutcome::Kind;

Way makeWay(const std::string& name, const std::string& from, const std::string& to,
            double time = 1) {
  Way way{name, {from}, to, {}};
  way.keys.resize(1);
  way.keys[0].time = time;
  return way;
}

std::vector<std::string> namesOf(const std::vector<const Way*>& ways) {
  std::vector<std::string> names;
  for (const Way* way : ways) names.push_back(way->name);
  return names;
}

using Names = std::vector<std::string>;

TEST(PostureGraph, TakesTheRouteThatIsShortestInTime) {
  RobotModel model;
  model.ways = {makeWay("straight up", "LyingBack", "Standing", 9),
                makeWay("sit up", "LyingBack", "Sitting", 2),
                makeWay("up from the seat", "Sitting", "Standing", 4)};
  EXPECT_EQ(namesOf(*findRoute(model, "LyingBack", "Standing")),
            (Names{"sit up", "up from the seat"}));
  model.ways[0].keys[0].time = 5;
  EXPECT_EQ(namesOf(*findRoute(model, "LyingBack", "Standing")), (Names{"straight up"}));
}

TEST(PostureGraph, KnowsOnePlaceForARobotOnItsFeet) {
  RobotModel model;
  model.ways = {makeWay("sit down", "Standing", "Sitting")};
  EXPECT_EQ(findRoute(model, "Crouching", "Standing")->size(), 0U);
  EXPECT_EQ(namesOf(*findRoute(model, "Crouching", "Sitting")), (Names{"sit down"}));
  EXPECT_FALSE(findRoute(model, "Sitting", "Standing"));
}

TEST(PostureGraph, FindsTheWayAroundWithinAFamily) {
  RobotModel model;
  model.ways = {makeWay("up", "LyingBelly", "Standing"),
                makeWay("arms", "LyingBelly", "LyingBelly")};
  EXPECT_EQ(findWayAround(model, "LyingBelly"), &model.ways[1]);
  EXPECT_EQ(findWayAround(model, "Sitting"), nullptr);
}

/// On its belly, with a way to its back of two keys, the first of which waits for the torso.
class FollowWayTest : public testing::Test {
 protected:
  FollowWayTest() {
    const auto model = makeTestRobot();
    Posture lying = *model->findPosture("Stand");
    lying.name = "Lying";
    lying.family = "LyingBack";
    model->postures.push_back(lying);
    Way way = makeWay("over", "LyingBelly", "LyingBack", 0.5);
    way.keys[0].angles = {{*model->findJoint("LKneePitch"), 1.0}};
    way.keys[0].pitch_low = -2;
    way.keys[0].pitch_high = -1;
    way.keys[0].patience = 2;
    way.keys.push_back(makeWay("", "", "", 0.5).keys[0]);
    way.keys[1].angles = {{*model->findJoint("LKneePitch"), 0.2}};
    model->ways = {way};
    bench = std::make_unique<EngineBench>(model);
    bench->frame.angle_y = 1.5;  // limp, and stiff only once it lies
    bench->pose("Crouch");
    id = bench->post(GoToPosture{"Lying", 1});
  }
  std::unique_ptr<EngineBench> bench;
  RequestId id = 0;
};

TEST_F(FollowWayTest, HoldsStillUntilTheTorsoHasThePitchOfTheKey) {
  bench->run(1.5);
  EXPECT_NEAR(bench->command("LKneePitch"), 1.0, 1e-9);
  bench->frame.angle_y = -1.5;
  bench->run(0.6);
  EXPECT_NEAR(bench->command("LKneePitch"), 0.2, 1e-9);
  EXPECT_GT(bench->cyclesUntilEnd(id), 0);
  EXPECT_EQ(bench->findOutcome(id)->kind, Kind::Done);
}

TEST_F(FollowWayTest, GivesUpWhenItsPatienceEnds) {
  EXPECT_NEAR(bench->cyclesUntilEnd(id), 280, 5);  // 0.5 s, 2 s of patience, 0.3 s at rest
  EXPECT_EQ(bench->findOutcome(id)->kind, Kind::Failed);
  EXPECT_EQ(bench->findOutcome(id)->reason, "the way over did not lead there");
}

TEST_F(FollowWayTest, MovesAlongACubicThatBeginsAndEndsAtRest) {
  const double start = bench->command("LKneePitch");
  bench->run(0.25);
  EXPECT_NEAR(bench->command("LKneePitch"), (start + 1.0) / 2, 1e-6);
  bench->run(0.24);
  const double almost = bench->command("LKneePitch");
  EXPECT_LT(almost - 1.0, 0.002 * start);
}

TEST(BodyFamily, TellsEverySideByTheTorso) {
  const auto model = makeTestRobot();
  SensorFrame frame;
  frame.angle = model->findPosture("Stand")->angle;
  frame.angle_y = -M_PI / 2;
  EXPECT_EQ(bodyFamily(*model, frame), "LyingBack");
  frame.angle_y = M_PI / 2;
  EXPECT_EQ(bodyFamily(*model, frame), "LyingBelly");
  frame.angle_y = 0;
  frame.angle_x = M_PI / 2;
  EXPECT_EQ(bodyFamily(*model, frame), "LyingRight");
  frame.angle_x = -M_PI / 2;
  EXPECT_EQ(bodyFamily(*model, frame), "LyingLeft");
}

TEST(BodyFamily, TellsThePosturesOfANaoByHipsKneesAndSoles) {
  const auto model = loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33");
  // The torso's pitch in these postures is a published figure of NAOqi 2.8.
  const std::vector<std::pair<std::string, double>> pitches = {
      {"Stand", 0.039}, {"StandInit", 0.104}, {"StandZero", 0.040}, {"Crouch", -0.052},
      {"Sit", -0.288},  {"SitRelax", -0.237}, {"LyingBack", -1.57}, {"LyingBelly", 1.377}};
  for (const auto& [name, pitch] : pitches) {
    SensorFrame frame;
    const Posture& posture = *model->findPosture(name);
    frame.angle = posture.angle;
    frame.angle_y = pitch;
    EXPECT_EQ(bodyFamily(*model, frame), posture.family) << name;
  }
}

TEST(TorsoPitch, GoesOnBeyondARightAngle) {
  SensorFrame frame;
  frame.angle_y = 1.4;
  EXPECT_NEAR(torsoPitch(frame), 1.4, 1e-12);
  frame.angle_x = M_PI;  // past the vertical, upside down
  EXPECT_NEAR(torsoPitch(frame), M_PI - 1.4, 1e-12);
}

}  // namespace
}  // namespace nao::motion
