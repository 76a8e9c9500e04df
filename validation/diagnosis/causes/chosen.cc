#include "validation/diagnosis/causes/chosen.h"

#include <algorithm>

namespace nao::validation {

std::vector<EffectSetting> settingsOf(const std::vector<Cause>& causes, const CauseList& chosen) {
  std::vector<EffectSetting> settings;
  for (const Chosen& one : chosen) settings.push_back(settingOf(causes[one.cause], one.x));
  return settings;
}

bool has(const CauseList& model, std::size_t cause) {
  return std::any_of(model.begin(), model.end(),
                     [&](const Chosen& one) { return one.cause == cause; });
}

std::vector<double> numbersOf(const CauseList& model) {
  std::vector<double> all;
  for (const Chosen& one : model) all.insert(all.end(), one.x.begin(), one.x.end());
  return all;
}

Eigen::VectorXd columnOf(const CauseList& model) {
  const std::vector<double> all = numbersOf(model);
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

CauseList withNumbers(CauseList model, const std::vector<double>& numbers) {
  std::size_t next = 0;
  for (Chosen& one : model) {
    for (double& x : one.x) x = numbers[next++];
  }
  return model;
}

}  // namespace nao::validation
