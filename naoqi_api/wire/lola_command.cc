#include "naoqi_api/wire/lola_command.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "naoqi_api/call_error.h"
#include "naoqi_api/value.h"

namespace nao::wire {
namespace {

std::string print(double number) { return rpc::Value(static_cast<float>(number)).print(); }

std::string rangeError(const char* list, std::size_t i, double found, double low, double high) {
  return std::string(list) + "[" + std::to_string(i) + "], " + kLolaJoints[i] + ": expected " +
         print(low) + " to " + print(high) + ", found " + print(found);
}

BodyCommand nothingAsked(const RobotModel& model) {
  BodyCommand command;
  command.angle = JointArray<double>(model.jointCount(), std::numeric_limits<double>::quiet_NaN());
  command.stiffness = JointArray<double>(model.jointCount());
  return command;
}

}  // namespace

LolaCommand::LolaCommand(const std::shared_ptr<const RobotModel>& model) : model_(model) {
  for (std::size_t i = 0; i < joints_.size(); ++i) joints_[i] = model->findJoint(kLolaJoints[i]);
}

std::string LolaCommand::take(const LolaActuators& frame) {
  std::string note;
  BodyCommand body = body_.value_or(nothingAsked(*model_));
  if (!frame.stiffness.empty()) body.stiffness = stiffnessOf(frame.stiffness, note);
  if (!frame.position.empty()) takeAngles(body, frame.position, note);
  if (!frame.unknown.empty()) note = "'" + frame.unknown.front() + "' is no key of LoLA's: ignored";
  if (!frame.position.empty() || !frame.stiffness.empty()) body_ = body;
  for (const auto& [name, brightness] : frame.leds) {
    const auto value = static_cast<float>(brightness);
    const auto [led, first] = leds_.emplace(name, value);
    if (!first && led->second == value) continue;
    led->second = value;
    changed_leds_.push_back({name, value});
  }
  return note;
}

void LolaCommand::takeAngles(BodyCommand& body, const std::vector<double>& position,
                             std::string& note) const {
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (!joints_[i]) continue;
    const Joint joint = *joints_[i];
    const Actuator& actuator = model_->actuators[index(joint)];
    const double held = std::clamp(position[i], actuator.lower, actuator.upper);
    const bool far = std::abs(held - position[i]) > kTolerance;
    if (held != position[i]) {
      note = rangeError("Position", i, position[i], actuator.lower, actuator.upper);
      if (far && body.stiffness[joint] > 0) throw rpc::CallError(note);
      note += far ? ": ignored, the joint is limp" : ": held at the end of its range";
    }
    if (!far) body.angle[joint] = held;
  }
}

JointArray<double> LolaCommand::stiffnessOf(const std::vector<double>& stiffness,
                                            std::string& note) const {
  JointArray<double> held(model_->jointCount());
  for (std::size_t i = 0; i < stiffness.size(); ++i) {
    if (!joints_[i]) continue;
    held[*joints_[i]] = std::clamp(stiffness[i], -1.0, 1.0);
    if (stiffness[i] > 1) note = rangeError("Stiffness", i, stiffness[i], -1, 1) + ": held at 1";
  }
  return held;
}

std::vector<LedOrder> LolaCommand::takeLeds() { return std::exchange(changed_leds_, {}); }

}  // namespace nao::wire
