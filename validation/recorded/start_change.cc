#include "validation/recorded/start_change.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "core/check.h"
#include "sim/effects/catalogue.h"

namespace nao::validation {
namespace {

constexpr char kForm[] =
    "expected ROBOT.effects.EFFECT.PARAMETER=NUMBER, ROBOT.effects.EFFECT=off, "
    "world.friction=NUMBER or seed=NUMBER";

[[noreturn]] void reject(const std::string& setting, const std::string& expected) {
  throw InputError("--set " + setting + ": " + expected);
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char letter : text) {
    if (letter == '.') {
      words.emplace_back();
    } else {
      words.back() += letter;
    }
  }
  return words;
}

std::optional<double> findNumber(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return std::nullopt;
  return number;
}

/// One change of an effect of robots.
struct EffectChange {
  std::string setting;  // whole, for complaints
  std::string effect;
  std::string parameter;
  std::optional<double> value;  // none: off
};

const sim::EffectType& typeOf(const EffectChange& change) {
  if (const auto* type = sim::standardEffects().find(change.effect)) return *type;
  std::string names;
  for (const sim::EffectType& type : sim::standardEffects().types()) {
    names += (names.empty() ? "" : ", ") + type.name;
  }
  reject(change.setting, "expected one of the effects " + names);
}

// The only parameter, or the only one that an effect changes if nothing else is said; else empty.
std::string sizeOf(const sim::EffectType& type) {
  if (type.parameters.size() == 1) return type.parameters[0].name;
  std::string found;
  for (const sim::Parameter& parameter : type.parameters) {
    if (parameter.nominal == parameter.neutral) continue;
    if (!found.empty()) return "";
    found = parameter.name;
  }
  return found;
}

// The parameter that is meant, by its name or as the one that says how much of an effect there is.
std::string parameterOf(const EffectChange& change, const sim::EffectType& type) {
  if (change.parameter.empty() && !sizeOf(type).empty()) return sizeOf(type);
  std::string names;
  for (const sim::Parameter& parameter : type.parameters) {
    if (parameter.name == change.parameter) return parameter.name;
    names += (names.empty() ? "" : ", ") + parameter.name;
  }
  reject(change.setting, "expected one of the parameters " + names);
}

void apply(const EffectChange& change, RobotModel& robot) {
  const sim::EffectType& type = typeOf(change);
  auto& effects = robot.effects;
  const auto is_meant = [&type](const EffectSetting& one) { return one.name == type.name; };
  if (!change.value) {
    effects.erase(std::remove_if(effects.begin(), effects.end(), is_meant), effects.end());
    return;
  }
  const std::string parameter = parameterOf(change, type);
  if (std::none_of(effects.begin(), effects.end(), is_meant)) {
    effects.push_back({type.name, {}, {}, {}});
  }
  for (EffectSetting& one : effects) {
    if (!is_meant(one)) continue;
    one.parameters[parameter] = *change.value;
    one.place = "--set " + change.setting;
  }
}

void changeRobots(const std::string& name, const EffectChange& change, runtime::RunStart& start) {
  bool found = false;
  std::string names;
  for (sim::RobotSetup& setup : start.robots) {
    names += (names.empty() ? "" : ", ") + setup.name;
    if (name != "robot" && name != setup.name) continue;
    auto robot = std::make_shared<RobotModel>(*setup.model);
    apply(change, *robot);
    setup.model = robot;
    found = true;
  }
  if (!found) reject(change.setting, "expected `robot` or one of the robots " + names);
}

}  // namespace

void changeStart(const std::string& setting, runtime::RunStart& start) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) reject(setting, kForm);
  const std::string text = setting.substr(equals + 1);
  const std::vector<std::string> words = split(setting.substr(0, equals));
  const std::optional<double> number = findNumber(text);
  const bool is_effect = (words.size() == 3 || words.size() == 4) && words[1] == "effects";
  if (!number && !(is_effect && text == "off" && words.size() == 3)) reject(setting, kForm);
  if (is_effect) {
    changeRobots(words[0], {setting, words[2], words.size() == 4 ? words[3] : "", number}, start);
  } else if (words == std::vector<std::string>{"world", "friction"}) {
    auto world = std::make_shared<WorldModel>(*start.world);
    world->ground.friction = *number;
    start.world = world;
  } else if (words == std::vector<std::string>{"seed"} && *number >= 0) {
    start.seed = static_cast<std::uint64_t>(*number);
  } else {
    reject(setting, kForm);
  }
}

}  // namespace nao::validation
