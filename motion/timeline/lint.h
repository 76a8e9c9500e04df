#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Something a motion should not do, at one joint for some time. What needs no physics is found by
/// lint(), the rest by playing it.
struct MotionFault {
  enum class Kind { File, Key, JointLimit, CoupledLimit, Velocity, Torque, Collision, Fall };
  Kind kind = Kind::Key;
  std::optional<Joint> joint;  // none: the whole robot
  double time = 0;             // [s] of the timeline, when it begins
  double until = 0;            // [s] when it is over
  double frame = 0;            // of the file, at `time`; see frameAt()
  double value = 0;            // the worst: [rad], [rad/s], [N m], [N]
  double limit = 0;            // what would have been right, in the same unit
  std::string text;            // one sentence
};

/// "joint_limit", "velocity" ...: how programs call a kind of fault.
const char* nameOf(MotionFault::Kind kind);

/// Collects what happens from moment to moment into faults: moments of one kind and joint that
/// are close together are one fault, which keeps the worst value.
class FaultLog {
 public:
  /// Moments further apart than this are two faults [s]. Free choice: shorter than any two keys
  /// that a person would tell apart.
  static constexpr double kGap = 0.1;

  struct Moment {
    MotionFault::Kind kind;
    std::optional<Joint> joint;
    double time;          // [s]
    double value, limit;  // the further `value` beyond `limit`, the worse
    std::string what;     // faults of different things, such as pairs of bodies, stay apart
  };
  void add(const Moment& moment);

  std::vector<MotionFault> take() { return std::move(faults_); }

 private:
  std::vector<MotionFault> faults_;
};

/// What is broken in its file, and what a motion asks of a robot that the robot can not give, as
/// far as its model tells: keys that could not be played as written, angles beyond joint and
/// coupled limits, speeds beyond a joint's. `start`: [rad] the pose from which it is played. Not
/// yet described.
std::vector<MotionFault> lint(const Timeline& timeline, const RobotModel& model,
                              const JointArray<double>& start);

/// Gives every fault its frame and its sentence, and puts them in order of time.
void describeFaults(const Timeline& timeline, const RobotModel& model,
                    std::vector<MotionFault>& faults);

}  // namespace nao::motion
