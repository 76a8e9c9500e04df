#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "motion/timeline/timeline.h"
#include "validation/experiment.h"

namespace nao::validation {

/// What runs differ in beyond the variation that the robot's file lists; nothing without a seed.
/// The motion side goes on to believe the file's masses.
struct Spread {
  double mass = 0.05;            // each body: 1 + U(-mass, mass) times its own
  double lowest_friction = 0.3;  // of the floor, U(lowest, highest), in place of the file's
  double highest_friction = 1.0;
};

/// The robot with this spread listed in its variation.
std::shared_ptr<const RobotModel> withSpread(const RobotModel& model, const Spread& spread);

/// The angle of a joint's (first) hinge [rad], on the limb's side, whatever encoders say.
double calcHingeAngle(const SceneFrame::Robot& robot, Joint joint);

/// What one run of a motion showed, by control cycle.
struct MotionRecord {
  std::vector<double> t;                    // [s] since the motion was asked for
  std::vector<JointArray<double>> command;  // [rad] after all clipping
  std::vector<JointArray<double>> sensor;   // [rad] Position/Sensor/Value of the same moment
  std::vector<JointArray<double>> hinge;    // [rad] on the limb's side
  bool fell = false;
  double max_tilt = 0;             // [rad] of the torso from upright
  Pose2 start, end;                // where frame R really was
  std::vector<double> foot_moved;  // [m] how far each sole went, forward as R headed at the start
  std::uint64_t hash = 0;
  std::map<std::string, double> draw;
};

/// Wakes a robot up, asks it for `action`, and watches for `seconds`. `seed` 0: no chance.
MotionRecord runMotion(const ExperimentSettings& settings,
                       const std::shared_ptr<const RobotModel>& model, std::uint64_t seed,
                       const motion::MotionAction& action, double seconds);

/// A timeline as angleInterpolationBezier would be asked for.
motion::MotionAction playing(const motion::Timeline& timeline);

/// How well joints followed their commands and how alike the runs were, over all runs added that
/// did not end in a fall. Both in degrees, by joint.
class Tracking {
 public:
  explicit Tracking(std::size_t joints) : joints_(joints) {}

  void add(const MotionRecord& record);

  /// The root of the mean square of sensor - command. 0 before the first run.
  std::vector<double> calcRms() const;
  /// The root of the mean, over the cycles, of the runs' variance (n - 1). 0 for a single run.
  std::vector<double> calcSd() const;

 private:
  struct Moment {
    double mean = 0;     // [rad] of the sensor, over the runs
    double scatter = 0;  // [rad^2] sum of squared deviations from it
    double lag = 0;      // [rad^2] sum of squared sensor - command
  };
  std::vector<double> calcRoot(double Moment::*sum, double runs) const;

  std::size_t joints_;
  std::size_t runs_ = 0;
  std::vector<Moment> moments_;  // by cycle, then joint
};

}  // namespace nao::validation
