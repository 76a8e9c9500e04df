#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "sim/world.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// A motion to record: what every joint is told [rad] at `t` [s] after its start.
struct RecordedMotion {
  std::string name;
  Split split = Split::Fit;
  double duration = 6;  // [s]
  std::function<JointArray<double>(double t)> angles;
  std::string start_pose{};  // for the file; empty: the robot's start posture
};

/// How a set is recorded from a simulated robot.
struct RecordingPlan {
  std::string name = "simulated";
  /// Its effects act; its variation does not, so that all repeats are of one robot.
  std::shared_ptr<const RobotModel> model;
  std::vector<EffectSetting> extra;  // on top of those, the same in every run
  std::vector<RecordedMotion> motions;
  int repeats = 6;
  Duration step = std::chrono::microseconds(250);
  sim::Mode mode = sim::Mode::Implicit;
  std::uint64_t seed = 1;  // of all that differs between runs
  double start_sd = 0;     // [s] by which the commands of a run come late, or early, drawn per run
  std::vector<std::string> joints;                // to write; empty: all
  const sim::EffectCatalogue* effects = nullptr;  // null: standardEffects()
  bool current = true;                            // write motor currents
  bool inertial_unit = false;                     // write accelerometer, gyroscope and torso angles
};

/// The standard motions of `record --protocol standard` for this robot.
std::vector<RecordedMotion> standardRecording(const std::shared_ptr<const RobotModel>& model);

/// Lets only these joints move; the others rest in the pose in which the standard motions begin, as
/// there nothing touches. A joint that another limits stays where that one's rest allows it.
/// @throws InputError for a joint that the robot does not have.
void moveOnly(const std::vector<std::string>& joints,
              const std::shared_ptr<const RobotModel>& model, std::vector<RecordedMotion>& motions);

/// Plays every motion `repeats` times on a World of this robot alone and writes down what its
/// sensors report each cycle: at each row's time the frame is read first, then the command of that
/// row is sent. Each run begins after half a second of rest in the motion's first pose.
LogSet recordSimulated(const RecordingPlan& plan);

}  // namespace nao::validation
