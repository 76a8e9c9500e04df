#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "motion/gait.h"
#include "runtime/ground_truth.h"
#include "sim/world.h"
#include "walk_engine/zmp_gait.h"

namespace nao::test {

/// One robot on flat ground, physics at 2 ms, driven by a gait alone: legs from the gait, the rest
/// as it stood, all joints stiff.
class Trial {
 public:
  /// Stands in `posture` of the robot's file for half a second first. `seed`: of the
  /// robot's variation, 0 for none.
  explicit Trial(const std::string& robot, const std::string& posture = "StandInit",
                 const walk::Tuning& tuning = {}, const WorldModel& world = {},
                 std::uint64_t seed = 0)
      : model_(loadRobotModel(NAO_SOURCE_DIR "/robots", robot)),
        gait_(walk::makeZmpGait(model_, tuning)),
        world_(std::make_shared<WorldModel>(world), {{"nao", model_, {}}}, options(seed)),
        command_{model_->findPosture(posture)->angle, JointArray<double>(model_->jointCount(), 1)} {
    world_.placeRobot(0, {}, &command_.angle);
    run(0.5);
    start_ = floorPose();
    max_tilt_ = 0;
  }

  motion::Gait& gait() { return *gait_; }
  sim::World& world() { return world_; }
  const RobotModel& model() const { return *model_; }
  const JointCommand& command() const { return command_; }

  void run(double seconds) {
    const SimTime end = world_.now() + fromSeconds(seconds);
    while (world_.now() < end) cycle();
  }

  /// Runs, and forgets the tilt so far: the posture at the start may lean.
  void settle(double seconds) {
    run(seconds);
    max_tilt_ = 0;
  }

  /// Until the gait has ended, `limit` [s] at most; then half a second more.
  void runToEnd(double limit = 60) {
    const SimTime end = world_.now() + fromSeconds(limit);
    while (gait_->active() && world_.now() < end) cycle();
    run(0.5);
  }

  Pose2 truth() const { return relativeTo(start_, floorPose()); }  // of R, since the start
  Pose2 odometry() const { return gait_->position(); }
  double maxTilt() const { return max_tilt_; }  // [rad] of the torso from vertical
  bool fallen() const { return max_tilt_ > 0.7; }
  double seconds() const { return toSeconds(world_.now()) - 0.5; }

  /// One line: time, odometry, truth, tilt.
  std::string summary() const {
    const Pose2 o = odometry();
    const Pose2 t = truth();
    char line[200];
    std::snprintf(line, sizeof line,
                  "%5.2f s  odometry %+.3f %+.3f m %+6.1f deg  true %+.3f %+.3f m %+6.1f deg  "
                  "tilt %.1f deg%s",
                  seconds(), o.x, o.y, o.theta * 180 / M_PI, t.x, t.y, t.theta * 180 / M_PI,
                  max_tilt_ * 180 / M_PI, fallen() ? "  FALLEN" : "");
    return line;
  }

 private:
  static sim::WorldOptions options(std::uint64_t seed) {
    sim::WorldOptions options(fromSeconds(0.002));
    options.seed = seed;
    return options;
  }

  void cycle() {
    gait_->update(world_.readSensors(0), command_);
    world_.setCommand(0, command_);
    for (Duration t{}; t < model_->cycle; t += world_.stepSize()) world_.step();
    const Vec3 up = world_.scene().robots[0].X_WB[0].linear().col(2);
    max_tilt_ = std::max(max_tilt_, std::acos(std::min(1.0, up.z())));
  }

  Pose2 floorPose() const { return runtime::calcFloorPose(*model_, world_.scene().robots[0].X_WB); }

  std::shared_ptr<const RobotModel> model_;
  std::unique_ptr<motion::Gait> gait_;
  sim::World world_;
  JointCommand command_;
  Pose2 start_;
  double max_tilt_ = 0;
};

}  // namespace nao::test
