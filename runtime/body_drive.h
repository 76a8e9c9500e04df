#pragma once

#include <cstdint>

#include "core/archive.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "core/sim_time.h"

namespace nao::runtime {

/// Who drives a body: a program past its motion side (LoLA) from its first command until it has
/// been silent for 500 ms, else the motion side. A value, on the simulation thread.
class BodyDrive {
 public:
  /// Its last command holds so long; then the body is the motion side's, without stiffness.
  static constexpr Duration kHold = std::chrono::milliseconds(500);

  /// One cycle: takes over what the program asked for last, null before its first time; whether
  /// that is new.
  bool update(const BodyCommand* newest, SimTime now);

  /// Lets go: the next command drives again.
  void release() { state_.drives = false; }

  bool drives() const { return state_.drives; }

  /// What the body is given this cycle: joints never asked for stay where they are measured, and
  /// all within their limits.
  const JointCommand& drive(const RobotModel& model, const SensorFrame& measured);

  /// The same once more.
  const JointCommand& given() const { return state_.given; }

  /// Goes back to how `other` was; which command was seen last is not part of that.
  void restore(const BodyDrive& other) { state_ = other.state_; }

  /// Adds what decides how it goes on.
  void addTo(Archive& hash) const;

 private:
  struct State {
    bool drives = false;
    SimTime heard{};  // the last command
    JointArray<double> angle;
    JointArray<double> stiffness;
    JointCommand given;
  };
  State state_;
  std::uint64_t seen_ = 0;
};

}  // namespace nao::runtime
