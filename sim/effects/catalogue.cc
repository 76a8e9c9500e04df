#include "sim/effects/catalogue.h"

#include <algorithm>
#include <sstream>

#include "core/check.h"

namespace nao::sim {
namespace {

std::string textOf(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

[[noreturn]] void reject(const EffectSetting& setting, const std::string& sentence) {
  throw InputError((setting.place.empty() ? "" : setting.place + ": ") + sentence);
}

template <class Named>
std::string namesOf(const std::vector<Named>& items) {
  std::string names;
  for (const Named& item : items) names += (names.empty() ? "" : ", ") + item.name;
  return names;
}

template <class Named>
const Named& need(const std::vector<Named>& items, const std::string& name, const char* what,
                  const EffectSetting& setting) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Named& n) { return n.name == name; });
  if (found != items.end()) return *found;
  reject(setting,
         std::string("expected ") + what + ": " + namesOf(items) + "; found '" + name + "'");
}

ParameterValues completeValues(const EffectType& type, const EffectSetting& setting) {
  ParameterValues values;
  for (const Parameter& parameter : type.parameters) values[parameter.name] = parameter.nominal;
  for (const auto& [name, value] : setting.parameters) {
    const Parameter& p =
        need(type.parameters, name, ("a parameter of " + type.name).c_str(), setting);
    if (!(value >= p.min && value <= p.max)) {
      reject(setting, "`" + name + "` of " + type.name + ": expected a number in [" +
                          textOf(p.min) + ", " + textOf(p.max) + "] " + p.unit + ", found " +
                          textOf(value));
    }
    values[name] = value;
  }
  return values;
}

JointArray<bool> maskOf(const EffectSetting& setting, const RobotModel& model) {
  JointArray<bool> mask(model.jointCount(), setting.joints.empty());
  for (const Joint joint : setting.joints) mask[joint] = true;
  return mask;
}

}  // namespace

void DriveTerms::reset(std::size_t joints) {
  JointArray<double>* const sums[] = {&resist_forward, &resist_backward, &creep_forward,
                                      &creep_backward, &creep_slope,     &viscous,
                                      &disturbance};
  JointArray<double>* const parts[] = {&torque_part, &speed_part};
  const bool resized = viscous.size() != joints;
  const auto fill = [&](JointArray<double>& term, double value) {
    if (resized) term = JointArray<double>(joints);
    std::fill(term.begin(), term.end(), value);
  };
  for (JointArray<double>* term : sums) fill(*term, 0);
  for (JointArray<double>* term : parts) fill(*term, 1);
}

void EffectCatalogue::add(EffectType type) {
  NAO_CHECK(!find(type.name));
  types_.push_back(std::move(type));
}

const EffectType* EffectCatalogue::find(std::string_view name) const {
  const auto found = std::find_if(types_.begin(), types_.end(),
                                  [&](const EffectType& type) { return type.name == name; });
  return found == types_.end() ? nullptr : &*found;
}

EffectChain::EffectChain(const EffectCatalogue& catalogue,
                         const std::vector<EffectSetting>& settings, const RobotModel& model,
                         Duration step, std::uint64_t seed, std::string_view robot_name,
                         Random::Pair pair) {
  for (const EffectSetting& setting : settings) {
    const EffectType& type = need(catalogue.types(), setting.name, "an effect", setting);
    const std::string stream =
        std::string(robot_name) + "/" + setting.name + "/" + std::to_string(effects_.size());
    const ParameterValues values = completeValues(type, setting);
    const JointArray<bool> joints = maskOf(setting, model);
    effects_.push_back(type.make(
        {values, joints, model, step, Random(seed, stream, pair), !setting.joints.empty()}));
    names_.push_back(setting.name);
    Effect* const effect = effects_.back().get();
    const Acts acts = effect->needed(type.acts);
    if (includes(acts, Acts::OnCommand)) on_command_.push_back(effect);
    if (includes(acts, Acts::OnDrive)) on_drive_.push_back(effect);
    if (includes(acts, Acts::OnImu)) on_imu_.push_back(effect);
    if (includes(acts, Acts::OnSensors)) on_sensors_.push_back(effect);
  }
  Archive saving = Archive::saving(beginning_);
  archive(saving);
}

void EffectChain::restart() {
  Archive loading = Archive::loading(beginning_);
  archive(loading);
}

void EffectChain::alterPlan(BodyPlan& plan) {
  for (const auto& effect : effects_) effect->alterPlan(plan);
}

void EffectChain::alterStart(Pose2& start) {
  for (const auto& effect : effects_) effect->alterStart(start);
}

void EffectChain::alterCommand(JointCommand& command, SimTime now, double h) {
  for (Effect* effect : on_command_) effect->alterCommand(command, now, h);
}

void EffectChain::alterDrive(const DriveMoment& moment, DriveTerms& terms) {
  terms.reset(moment.angle.size());
  for (Effect* effect : on_drive_) effect->alterDrive(moment, terms);
}

void EffectChain::alterImu(SensorFrame& frame, Duration cycle) {
  for (Effect* effect : on_imu_) effect->alterImu(frame, cycle);
}

void EffectChain::alterSensors(SensorFrame& frame, Duration cycle) {
  for (Effect* effect : on_sensors_) effect->alterSensors(frame, cycle);
}

void EffectChain::archive(Archive& archive) {
  for (const auto& effect : effects_) effect->archive(archive);
}

std::map<std::string, double> EffectChain::draw() const {
  std::map<std::string, double> all;
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    std::map<std::string, double> one;
    effects_[i]->listDraw(one);
    for (const auto& [name, value] : one) all[names_[i] + "." + name] = value;
  }
  return all;
}

}  // namespace nao::sim
