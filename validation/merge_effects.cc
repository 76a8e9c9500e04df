#include "validation/merge_effects.h"

#include <algorithm>
#include <utility>

namespace nao::validation {
namespace {

using sim::EffectType;
using sim::Parameter;

bool actsOn(const EffectSetting& setting, std::size_t joint) {
  if (setting.joints.empty()) return true;
  return std::find(setting.joints.begin(), setting.joints.end(), toJoint(joint)) !=
         setting.joints.end();
}

double deviation(const EffectSetting& setting, const Parameter& parameter) {
  const auto found = setting.parameters.find(parameter.name);
  return (found == setting.parameters.end() ? parameter.nominal : found->second) -
         parameter.neutral;
}

std::vector<Joint> allJoints(const RobotModel& model) {
  std::vector<Joint> all;
  for (std::size_t j = 0; j < model.jointCount(); ++j) all.push_back(toJoint(j));
  return all;
}

// Takes `joint` away from a setting; one that acts on nothing any more is left to the caller.
void release(EffectSetting& setting, std::size_t joint, const RobotModel& model) {
  if (setting.joints.empty()) setting.joints = allJoints(model);
  setting.joints.erase(std::remove(setting.joints.begin(), setting.joints.end(), toJoint(joint)),
                       setting.joints.end());
}

EffectSetting sumOf(const EffectSetting& own, const EffectSetting& cause, const EffectType& type) {
  EffectSetting sum = own;
  for (const Parameter& p : type.parameters) {
    const double value = p.neutral + deviation(own, p) + deviation(cause, p);
    sum.parameters[p.name] = std::clamp(value, p.min, p.max);
  }
  return sum;
}

void within(EffectSetting& setting, const EffectType& type) {
  for (const Parameter& p : type.parameters) {
    const auto found = setting.parameters.find(p.name);
    if (found != setting.parameters.end()) found->second = std::clamp(found->second, p.min, p.max);
  }
}

// One cause on one joint: true if the model's own effect took it up.
bool addToOwn(std::vector<EffectSetting>& effects, const EffectSetting& cause, std::size_t joint,
              const EffectType& type, const RobotModel& model) {
  for (std::size_t i = 0; i < effects.size(); ++i) {
    if (effects[i].name != cause.name || !actsOn(effects[i], joint)) continue;
    EffectSetting sum = sumOf(effects[i], cause, type);
    sum.joints = {toJoint(joint)};
    release(effects[i], joint, model);
    const auto at = effects.begin() + static_cast<std::ptrdiff_t>(i);
    if (at->joints.empty()) {
      *at = std::move(sum);
    } else {
      effects.insert(at + 1, std::move(sum));
    }
    return true;
  }
  return false;
}

void add(std::vector<EffectSetting>& effects, EffectSetting cause, const RobotModel& model,
         const sim::EffectCatalogue& catalogue) {
  const EffectType* type = catalogue.find(cause.name);
  if (type == nullptr) {  // the chain that is made of the list says so with file and line
    effects.push_back(std::move(cause));
    return;
  }
  const auto same = [&](const EffectSetting& one) { return one.name == cause.name; };
  if (std::none_of(effects.begin(), effects.end(), same)) {
    within(cause, *type);
    effects.push_back(std::move(cause));
    return;
  }
  EffectSetting rest = cause;
  rest.joints.clear();
  for (const Joint joint : cause.joints.empty() ? allJoints(model) : cause.joints) {
    if (!addToOwn(effects, cause, index(joint), *type, model)) rest.joints.push_back(joint);
  }
  within(rest, *type);
  if (!rest.joints.empty()) effects.push_back(std::move(rest));
}

}  // namespace

EffectSetting neutralSetting(const std::string& effect, const sim::EffectCatalogue& catalogue) {
  EffectSetting setting;
  setting.name = effect;
  const EffectType* type = catalogue.find(effect);
  if (type == nullptr) return setting;
  for (const Parameter& p : type->parameters) setting.parameters[p.name] = p.neutral;
  return setting;
}

std::vector<EffectSetting> mergedEffects(const RobotModel& model,
                                         const std::vector<EffectSetting>& causes,
                                         const sim::EffectCatalogue& catalogue) {
  std::vector<EffectSetting> effects = model.effects;
  for (const EffectSetting& cause : causes) add(effects, cause, model, catalogue);
  return effects;
}

double presentDeviation(const RobotModel& model, std::size_t joint, const std::string& effect,
                        const std::string& parameter, const sim::EffectCatalogue& catalogue) {
  const EffectType* type = catalogue.find(effect);
  if (type == nullptr) return 0;
  double sum = 0;
  for (const EffectSetting& own : model.effects) {
    if (own.name != effect || !actsOn(own, joint)) continue;
    for (const Parameter& p : type->parameters) {
      if (p.name == parameter) sum += deviation(own, p);
    }
  }
  return sum;
}

}  // namespace nao::validation
