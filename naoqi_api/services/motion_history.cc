#include "naoqi_api/services/motion_history.h"

#include <algorithm>
#include <cmath>

#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;

constexpr std::chrono::seconds kKept{2};  // longer than an image is old that a client works on

// A command that a joint can not follow at its top speed has jumped; the rest is rounding.
constexpr double kJump = 1e-3;  // [rad]

// [seconds, microseconds] of NaoQi's clock.
Duration readStamp(const rpc::Value& stamp) {
  constexpr double kMost = 4e9;  // [s] of 1970; far from overflow
  const auto numbers = stamp.to<std::vector<double>>();
  const auto is_sound = [](double number, double most) { return number >= 0 && number < most; };
  if (numbers.size() != 2 || !is_sound(numbers[0], kMost) || !is_sound(numbers[1], 1e6)) {
    throw CallError("expected [seconds, microseconds], got " + stamp.print());
  }
  return std::chrono::seconds(static_cast<std::int64_t>(numbers[0])) +
         std::chrono::microseconds(static_cast<std::int64_t>(numbers[1]));
}

}  // namespace

void MotionHistory::declare(rpc::Service& service) {
  addFunction(
      service, "_getCumulatedDisplacement",
      [this] {
        return std::vector<float>{static_cast<float>(way_.x), static_cast<float>(way_.y),
                                  static_cast<float>(way_.theta)};
      },
      "How far the robot has gone by its odometry, forth and back both counted: along its x and y "
      "[m], and turned [rad].")
      .at(184);
  addFunction(
      service, "_getSensorTransformAtTime",
      [this](const std::string& sensor, const rpc::Value& stamp) {
        return transformAt(sensor, SimTime(readStamp(stamp) - epoch_));
      },
      "Where something was in the torso's frame by measured joints: 4 by 4, row by row. Of the "
      "last two seconds.",
      Argument{"sensorName", "Name of a chain, joint, camera or other sensor."},
      Argument{"timestamp", "[seconds, microseconds], as an image has it."})
      .at(203);
  addFunction(
      service, "_resetNumJointCommandDiscontinuities", [this] { jumps_ = 0; }, "Counts from 0.")
      .at(317);
  addFunction(
      service, "_getNumJointCommandDiscontinuities", [this] { return jumps_; },
      "How often a joint's command moved on faster than the joint can.")
      .at(318);
}

void MotionHistory::deliver() {
  if (link_.now() == SimTime{}) return;
  const auto state = link_.state();
  if (state->set_back != set_back_) {
    set_back_ = state->set_back;
    has_seen_ = false;
    moments_.clear();
  }
  remember(*link_.sensors());
  if (has_seen_ && state->time > seen_) {
    countJumps(*state, toSeconds(state->time - seen_));
    addWay(*state);
  }
  if (has_seen_ && state->time == seen_) return;
  has_seen_ = true;
  seen_ = state->time;
  command_ = state->command.angle;
  position_ = state->position;
}

void MotionHistory::remember(const SensorFrame& sensors) {
  if (!moments_.empty() && sensors.time <= moments_.back().time) return;
  moments_.push_back({sensors.time, sensors.angle});
  while (moments_.front().time < sensors.time - kKept) moments_.pop_front();
}

void MotionHistory::countJumps(const motion::MotionState& state, double dt) {
  const auto& actuators = link_.model().actuators;
  for (std::size_t i = 0; i < actuators.size(); ++i) {
    const double step = std::abs(state.command.angle[i] - command_[i]);
    if (step > actuators[i].max_velocity * dt + kJump) ++jumps_;
  }
}

void MotionHistory::addWay(const motion::MotionState& state) {
  const Pose2 step = relativeTo(position_, state.position);
  way_.x += std::abs(step.x);
  way_.y += std::abs(step.y);
  way_.theta += std::abs(step.theta);
}

// Between two cycles, on the straight line.
JointArray<double> MotionHistory::anglesAt(SimTime time) const {
  const auto after =
      std::lower_bound(moments_.begin(), moments_.end(), time,
                       [](const Moment& moment, SimTime at) { return moment.time < at; });
  if (after == moments_.end() || (after == moments_.begin() && after->time != time)) {
    throw CallError("no joint angles are kept of that time, only of the last two seconds");
  }
  JointArray<double> angles = after->angle;
  if (after->time == time) return angles;
  const Moment& before = *std::prev(after);
  const double part = toSeconds(time - before.time) / toSeconds(after->time - before.time);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i] = before.angle[i] + part * (angles[i] - before.angle[i]);
  }
  return angles;
}

std::vector<float> MotionHistory::transformAt(const std::string& sensor, SimTime time) {
  const auto place = motion::findEffector(link_.model(), sensor);
  if (!place) throw CallError("unknown chain, joint or sensor name: " + sensor);
  kinematics_.update(anglesAt(time));
  const Pose X_TF = kinematics_.calcPose(*place);
  std::vector<float> numbers;
  for (int i = 0; i < 16; ++i) {
    numbers.push_back(static_cast<float>(X_TF.matrix()(i / 4, i % 4)));
  }
  return numbers;
}

}  // namespace nao::services
