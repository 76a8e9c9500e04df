// What every file of motions/ must be: read without a complaint, and within what a Nao can do.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "motion/limits.h"
#include "motion/timeline/motion_file.h"
#include "motion/trajectory.h"
#include "tests/support/models.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kRounding = 0.11 * kDegree;  // files hold tenths of a degree
constexpr double kCycle = 0.01;               // [s]

std::vector<std::filesystem::path> shippedMotions() {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(NAO_SOURCE_DIR "/motions")) {
    if (entry.path().extension() == ".xar") files.insert(entry.path());
  }
  return {files.begin(), files.end()};
}

// The commands of a timeline that is played from StandInit, by cycle.
std::vector<JointArray<double>> commandsOf(const Timeline& timeline, const RobotModel& model) {
  const JointArray<double>& start = model.findPosture("StandInit")->angle;
  std::vector<JointArray<double>> commands;
  for (double t = 0; t < timeline.length + kCycle; t += kCycle) {
    JointArray<double> angle = start;
    for (const Curve& curve : timeline.curves) {
      angle[curve.joint] = Trajectory(start[curve.joint], curve.keys).at(t);
    }
    commands.push_back(angle);
  }
  return commands;
}

class ShippedMotion : public testing::TestWithParam<std::filesystem::path> {
 protected:
  const std::shared_ptr<const RobotModel> robot_ = test::robot("nao_h21_v33");
  const Timeline timeline_ = loadMotion(GetParam(), *robot_);
};

TEST_P(ShippedMotion, IsReadWithoutAWarning) {
  EXPECT_FALSE(timeline_.curves.empty());
  for (const std::string& warning : timeline_.warnings) ADD_FAILURE() << warning;
}

TEST_P(ShippedMotion, StaysWithinJointAndCoupledLimits) {
  for (const JointArray<double>& command : commandsOf(timeline_, *robot_)) {
    JointArray<double> clipped = command;
    clipToLimits(*robot_, allJoints(*robot_), clipped);
    for (std::size_t j = 0; j < robot_->jointCount(); ++j) {
      ASSERT_NEAR(command[j], clipped[j], kRounding) << robot_->actuators[j].name;
    }
  }
}

TEST_P(ShippedMotion, AsksNoJointForMoreThanItsSpeed) {
  const auto commands = commandsOf(timeline_, *robot_);
  for (std::size_t k = 1; k < commands.size(); ++k) {
    for (std::size_t j = 0; j < robot_->jointCount(); ++j) {
      const double speed = std::abs(commands[k][j] - commands[k - 1][j]) / kCycle;
      ASSERT_LE(speed, robot_->actuators[j].max_velocity)
          << robot_->actuators[j].name << " at " << kCycle * static_cast<double>(k) << " s";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, ShippedMotion, testing::ValuesIn(shippedMotions()),
                         [](const auto& file) { return file.param.stem().string(); });

TEST(ShippedMotions, RoutesEndInTheirPosture) {
  const auto robot = test::robot("nao_h21_v33");
  for (const char* file : {"stand_up_back.route", "stand_up_front.route"}) {
    const Timeline timeline =
        loadMotion(std::string(NAO_SOURCE_DIR "/robots/nao_h21_v33/motions/") + file, *robot);
    ASSERT_EQ(timeline.curves.size(), robot->jointCount()) << file;
    for (const Curve& curve : timeline.curves) {
      EXPECT_EQ(curve.keys.back().angle, robot->findPosture("Stand")->angle[curve.joint]) << file;
      EXPECT_NEAR(curve.keys.back().time, timeline.length, 1e-9) << file;
    }
  }
}

TEST(ShippedMotions, KicksAndBalanceEndAsTheyBegan) {
  const auto robot = test::robot("nao_h21_v33");
  const JointArray<double>& start = robot->findPosture("StandInit")->angle;
  for (const char* file : {"kick_left.xar", "kick_right.xar", "balance.xar"}) {
    const Timeline timeline = loadMotion(std::string(NAO_SOURCE_DIR "/motions/") + file, *robot);
    const JointArray<double> end = commandsOf(timeline, *robot).back();
    for (std::size_t j = 0; j < robot->jointCount(); ++j) {
      EXPECT_NEAR(end[j], start[j], kRounding) << file << ": " << robot->actuators[j].name;
    }
  }
}

}  // namespace
}  // namespace nao::motion
