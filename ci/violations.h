#pragma once

#include <vector>

#include "ci/moment.h"
#include "runtime/simulation.h"

namespace nao::ci {

/// Finds, beat by beat, what a robot should not be asked for, or do:
///   joint_limit     an encoder reports more than 2 degrees beyond the joint's range
///   coupled_limit   the same for a range that another joint's angle leaves
///   velocity        a stiff joint's command moves faster than the joint's top speed
///   torque          a servo is held at its limit for 100 ms
///   self_collision  two of the robot's bodies push each other with more than 1 N
///   heat            a motor's board holds back because it is hot
/// Simulation thread.
class ViolationFinder {
 public:
  explicit ViolationFinder(std::size_t robots) : robots_(robots) {}

  /// `sensors` by robot.
  std::vector<Violation> look(runtime::Simulation& simulation,
                              const std::vector<std::shared_ptr<const SensorFrame>>& sensors);

 private:
  struct Before {  // of one robot
    SimTime time{};
    JointCommand command;
    std::vector<SimTime> free;  // when each servo was last within its limit
  };
  void lookAtRobot(runtime::Simulation& simulation, std::size_t robot, const SensorFrame& sensors);
  void lookAtAngles(const RobotModel& model, const SensorFrame& sensors);
  void lookAtSpeeds(const RobotModel& model, const motion::MotionState& state);
  void lookAtMotors(runtime::Simulation& simulation, const RobotModel& model);
  void lookAtContacts(const sim::ContactReport& contacts, const RobotModel& model);
  void add(const char* kind, std::string text);

  std::vector<Before> robots_;
  std::size_t robot_ = 0;  // looked at now
  std::vector<Violation> found_;
};

}  // namespace nao::ci
