#include "motion/collision_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/shape_gap.h"
#include "motion/kinematics.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

std::shared_ptr<const RobotModel> loadNao() {
  return loadRobotModel(std::string(NAO_SOURCE_DIR) + "/robots", "nao_h21_v33");
}

// The least gap between a left forearm's solids and the torso's, by other kinematics. [m]
double forearmToTorso(const std::shared_ptr<const RobotModel>& model,
                      const JointArray<double>& angle) {
  Kinematics kinematics(model);
  kinematics.update(angle);
  const int forearm = *model->findBody("LElbowRoll");
  double least = std::numeric_limits<double>::max();
  for (const Shape& a : model->bodies[static_cast<std::size_t>(forearm)].collisions) {
    for (const Shape& b : model->bodies[0].collisions) {
      const Pose X_TA = kinematics.getPose(forearm) * a.X_BS;
      least = std::min(least, calcShapeGap(a, X_TA, b, kinematics.getPose(0) * b.X_BS).distance);
    }
  }
  return least;
}

// The left forearm in front of the chest, then the shoulder turned inwards as far as it goes.
struct ArmIntoTorso {
  explicit ArmIntoTorso(bool on) : bench(loadNao()) {
    bench.pose("StandInit");
    bench.post(SetCollisionProtection{on, true});
    bench.post(
        SetAngles{{bench.joint("LShoulderPitch"), bench.joint("LShoulderRoll"),
                   bench.joint("LElbowYaw"), bench.joint("LElbowRoll"), bench.joint("HeadYaw")},
                  {1.5, -0.3, 0.0, -1.5, 0.5},
                  {0.3, 0.3, 0.3, 0.3, 0.3}});
    for (int i = 0; i < 200; ++i) {
      least = std::min(least, forearmToTorso(bench.model, bench.cycle().angle));
    }
  }
  EngineBench bench;
  double least = std::numeric_limits<double>::max();
};

TEST(CollisionGuard, KeepsAnArmOutOfTheTorsoWhileOtherJointsGoOn) {
  ArmIntoTorso run(true);
  EXPECT_GE(run.least, -1e-9);
  EXPECT_LT(run.least, 1e-3);
  EXPECT_EQ(run.bench.engine.state().arms[0], Nearness::Collision);
  EXPECT_EQ(run.bench.engine.state().arms[1], Nearness::None);
  EXPECT_DOUBLE_EQ(run.bench.command("HeadYaw"), 0.5);
}

TEST(CollisionGuard, LetsTheCommandThroughWhenSwitchedOff) {
  ArmIntoTorso run(false);
  EXPECT_LT(run.least, -0.005);
  EXPECT_DOUBLE_EQ(run.bench.command("LShoulderRoll"), -0.3);
  EXPECT_DOUBLE_EQ(run.bench.command("LElbowRoll"), -1.5);
}

TEST(CollisionGuard, LetsAHeldArmGoBackAtItsJointsSpeed) {
  ArmIntoTorso run(true);
  const Joint roll = run.bench.joint("LShoulderRoll");
  run.bench.post(SetAngles{{roll}, {0.8}, {1.0}});
  double before = run.bench.command("LShoulderRoll");
  for (int i = 0; i < 100; ++i) {
    const double now = run.bench.cycle().angle[roll];
    EXPECT_LE(std::abs(now - before),
              run.bench.model->actuators[index(roll)].max_velocity * 0.0101);
    before = now;
  }
  EXPECT_DOUBLE_EQ(run.bench.command("LShoulderRoll"), 0.8);
}

TEST(CollisionGuard, LeavesEveryStandardPostureAsItIs) {
  const auto model = loadNao();
  for (const Posture& posture : model->postures) {
    CollisionGuard guard(*model);
    JointArray<double> command = posture.angle;
    guard.apply(posture.angle, 0.01, command);
    EXPECT_EQ(0, std::memcmp(command.begin(), posture.angle.begin(),
                             posture.angle.size() * sizeof(double)))
        << posture.name;
  }
}

}  // namespace
}  // namespace nao::motion
