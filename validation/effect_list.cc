#include "validation/effect_list.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "sim/effects/catalogue.h"

namespace nao::validation {
namespace {

std::string lineOf(const sim::Parameter& p) {
  char line[200];
  std::snprintf(line, sizeof line, "    %-12s %-10g %g to %g %s, nothing at %g, matters from %g\n",
                p.name.c_str(), p.nominal, p.min, p.max, p.unit.c_str(), p.neutral, p.smallest);
  return line;
}

nlohmann::ordered_json jsonOf(const sim::Parameter& p) {
  return {{"name", p.name}, {"unit", p.unit}, {"nominal", p.nominal},  {"neutral", p.neutral},
          {"min", p.min},   {"max", p.max},   {"smallest", p.smallest}};
}

}  // namespace

std::string listEffectsAsText() {
  std::string text;
  for (const sim::EffectType& type : sim::standardEffects().types()) {
    text += type.name + "\n    " + type.summary + "\n";
    for (const sim::Parameter& parameter : type.parameters) text += lineOf(parameter);
  }
  return text;
}

std::string listEffectsAsJson() {
  nlohmann::ordered_json all;
  for (const sim::EffectType& type : sim::standardEffects().types()) {
    nlohmann::ordered_json& one = all[type.name];
    one["summary"] = type.summary;
    one["parameters"] = nlohmann::ordered_json::array();
    for (const sim::Parameter& p : type.parameters) one["parameters"].push_back(jsonOf(p));
  }
  return all.dump(2);
}

}  // namespace nao::validation
