#pragma once

#include <memory>
#include <string>

#include "core/archive.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "motion/joint_set.h"
#include "motion/stiffness.h"

namespace nao::motion {

class Walking;
class WholeBody;

/// What a phase works on: the robot as commanded and as measured in this cycle.
struct Body {
  const RobotModel& model;
  JointArray<double> angle;  // [rad] the command in the making
  Stiffness stiffness;
  SensorFrame measured;
  bool upright = true;   // neither falling nor fallen
  bool grounded = true;  // a foot has felt the ground of late
  bool awake = false;
  bool self_guarded = false;        // for this cycle: what moves the arms knows where the body is
  Walking* walking = nullptr;       // of the same robot; during a cycle only
  WholeBody* whole_body = nullptr;  // likewise; null while it walks

  explicit Body(const RobotModel& robot)
      : model(robot), angle(robot.jointCount()), stiffness(robot.jointCount()) {}
};

/// One stretch of a motion: keys to follow, a glide to a posture, a stiffness ramp, a walk.
/// Lives on the simulation thread. begin() once, from where the robot then is; then advance()
/// once per cycle, the first time in the cycle of begin(), until it no longer says Running.
class Phase {
 public:
  enum class Progress { Running, Done, Failed };

  virtual ~Phase() = default;
  virtual void begin(Body& body) = 0;

  /// One cycle of `dt` [s]; writes the angles of joints in `mine` only.
  virtual Progress advance(double dt, const JointSet& mine, Body& body) = 0;

  /// Why advance() said Failed, one sentence.
  virtual std::string failure() const { return {}; }

  /// A phase that goes on bit by bit as this one would and shares nothing with it that changes.
  virtual std::unique_ptr<Phase> clone() const = 0;

  /// Lists what decides how it goes on, for hashing.
  virtual void archive(Archive& archive) = 0;
};

}  // namespace nao::motion
