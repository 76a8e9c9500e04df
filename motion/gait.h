#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/archive.h"
#include "core/frames.h"
#include "core/robot_io.h"
#include "core/robot_model.h"

namespace nao::motion {

/// Aldebaran's gait parameters (names and defaults of ALMotion's move configuration).
struct GaitConfig {
  double max_step_x = 0.040;        // [m]
  double min_step_x = -0.040;       // [m]
  double max_step_y = 0.140;        // [m] distance between the feet, outermost
  double max_step_theta = 0.349;    // [rad]
  double max_step_frequency = 1.0;  // 0 to 1
  double step_height = 0.020;       // [m]
  double torso_wx = 0;              // [rad]
  double torso_wy = 0;              // [rad]
};

/// A velocity on the floor.
struct Velocity2 {
  double x = 0;      // [m/s]
  double y = 0;      // [m/s]
  double theta = 0;  // [rad/s]
};

/// Lists a configuration in an archive.
void archiveConfig(Archive& archive, GaitConfig& config);

/// How a walk answers what it senses; without either it is open loop.
struct WalkFeedback {
  bool balance = true;  // ankles damp rocking, soles are levelled, the sway is kept from growing
  bool steps = true;    // landings move to catch a push (ALMotion.setPushRecoveryEnabled)
};

/// One planned support, in the odometry frame.
struct Footstep {
  Foot foot = Foot::Left;
  Pose2 place;      // of the sole
  SimTime lands{};  // when it takes load
};

/// A step somebody asks for by itself (ALMotion.setFootSteps).
struct StepOrder {
  Foot foot = Foot::Left;
  Pose2 place;        // of its sole, in the frame of the other sole
  double period = 0;  // [s] from the other foot's landing to this one's
};

/// A walk engine as the motion engine sees it. It runs on the simulation thread, once per control
/// cycle, and knows the robot by its commands and sensors alone. Before the first request it is
/// idle and update() leaves the command untouched.
class Gait {
 public:
  virtual ~Gait() = default;

  /// Walks to `target`, given in the frame R of now (or of the end of the steps under way).
  virtual void walkTo(const Pose2& target, const GaitConfig& config) = 0;

  /// Walks on and on. Fractions of the largest step, each in [-1, 1] (ALMotion.moveToward).
  virtual void walkToward(double x, double y, double theta, const GaitConfig& config) = 0;

  /// Walks on at this velocity, clipped to what the steps allow (ALMotion.move).
  virtual void walkAt(const Velocity2& velocity, const GaitConfig& config) = 0;

  /// Takes these steps, clipped to what the legs allow, and stands where the feet then are. They
  /// follow the ordered steps not yet taken, or replace those that may still change (`clear`); any
  /// other walk ends with the step under way. (ALMotion.setFootSteps)
  virtual void walkSteps(const std::vector<StepOrder>& steps, bool clear) = 0;

  /// From the next cycle on.
  virtual void setFeedback(const WalkFeedback& feedback) = 0;

  /// Ends the walk in double support, feet side by side.
  virtual void stop() = 0;

  /// Forgets the walk at once, wherever the feet are (ALMotion.killMove, a fall, a new pose).
  virtual void kill() = 0;

  /// From the first request until both feet stand and the body has come to rest.
  virtual bool active() const = 0;

  /// One cycle while active: overwrites the legs' angles in `command` (and the arms' where they
  /// swing). `measured` is the frame of this cycle.
  virtual void update(const SensorFrame& measured, JointCommand& command) = 0;

  /// Odometry since the start of the robot: pose of R and velocity, as commanded.
  virtual Pose2 position() const = 0;
  virtual Pose2 nextPosition() const = 0;  // after the steps that can no longer change
  virtual Velocity2 velocity() const = 0;
  virtual std::vector<Footstep> footsteps() const = 0;

  /// A gait that goes on bit by bit as this one would and shares nothing with it that changes.
  virtual std::unique_ptr<Gait> clone() const = 0;

  /// Lists what changes with time; a gait made alike and restored from it goes on likewise.
  virtual void archive(Archive& archive) = 0;
};

}  // namespace nao::motion
