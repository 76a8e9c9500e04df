#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/joint.h"
#include "core/lola_joints.h"
#include "core/robot_io.h"
#include "core/robot_model.h"

namespace nao::wire {

/// What clients read in the battery's second and third place: they disagree about a real V6.
enum class LolaBattery {
  StatusFirst,  // charge, status, current, temperature: B-Human, Nao Devils, Bembelbots
  CurrentFirst  // charge, current, status, temperature: ros-sports, nidhogg, railbot
};

/// Who a robot says it is. Ids have 20 letters, by which clients tell their robots apart.
struct LolaIdentity {
  std::string body;
  std::string head;
};

/// The identity of robot `number` of a daemon, the same in every run.
LolaIdentity lolaIdentity(std::size_t number);

/// Writes what a robot senses as LoLA's sensor frames, all of one size and layout:
///
///   frame    = fixmap 13 { key: value }, keys in the order of the fields below, fixstr
///   Stiffness, Position, Temperature, Current    array16 25 of float32, in the order of
///   kLolaJoints Battery 4, Accelerometer 3, Gyroscope 3, Angles 2, Sonar 2, FSR 8     fixarray of
///   float32 Status                                       array16 25 of positive fixint, 0 to 3
///   Touch 14                                     fixarray of float32, 0 or 1
///   RobotConfig 4                                body id, version, head id, version: fixstr
///
/// Units: rad (hands 0 to 1), degrees C, A, m/s^2 (at rest z is -9.81), rad/s, m, kg. What a robot
/// does not have is 0.
class LolaSensors {
 public:
  static constexpr std::size_t kSize = 896;  // bytes: what every client reads at once

  LolaSensors(const RobotModel& model, LolaIdentity identity, LolaBattery battery);

  /// `command` is what the motors follow. Valid until the next call.
  const std::string& encode(const SensorFrame& frame, const JointCommand& command);

 private:
  void key(const char* name);
  void number(double value);
  template <class Read>
  void joints(const char* name, const Read& read);
  template <class Values>
  void numbers(const char* name, const Values& values);
  void status(const SensorFrame& frame);
  void battery(const BatteryState& state);
  void touch(const SensorFrame& frame);
  void robotConfig();

  std::array<std::optional<Joint>, kLolaJoints.size()> joints_;
  LolaIdentity identity_;
  LolaBattery battery_;
  std::string bytes_;
};

}  // namespace nao::wire
