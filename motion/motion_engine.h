#pragma once

#include <memory>
#include <vector>

#include "core/archive.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "motion/gait.h"
#include "motion/motion_request.h"
#include "motion/motion_state.h"

namespace nao::motion {

/// Turns requests into one joint command per control cycle. Runs on the simulation thread; never
/// hears of physics. Before the first request the joints keep the start posture with stiffness 0.
/// A joint with stiffness 0 or less has its command follow its sensor, as on the robot, so that it
/// does not jump when it is made stiff again. A value: a copy goes on bit by bit as the original
/// would and shares nothing with it that changes.
class MotionEngine {
 public:
  /// `gait` may be null: a robot that does not walk. `last_accepted`: where the numbers of the
  /// requests go on, for an engine that takes the place of another.
  MotionEngine(std::shared_ptr<const RobotModel> model, std::unique_ptr<Gait> gait,
               RequestId last_accepted = 0);
  MotionEngine(const MotionEngine& other);
  MotionEngine& operator=(const MotionEngine& other);
  MotionEngine(MotionEngine&& other) noexcept;  // leaves nothing but to be assigned or destroyed
  MotionEngine& operator=(MotionEngine&& other) noexcept;
  ~MotionEngine();

  /// Takes a request over; what it changes shows from the next update().
  void accept(const MotionRequest& request);

  /// One cycle: the command for the time from `measured` on.
  JointCommand update(const SensorFrame& measured);

  /// What has been commanded, for publishing; valid after accept() or update().
  MotionState state() const;

  /// The requests that ended since the last call, in order.
  std::vector<MotionOutcome> takeOutcomes();

  /// From now on nobody hears how the requests end that were accepted until now.
  void forgetCallers();

  /// Adds all that decides how the robot goes on to a hash: joints, motions, walk; not who asked.
  void addTo(Archive& hash) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace nao::motion
