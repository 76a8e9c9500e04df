#include "validation/diagnosis/causes/cause_list.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/check.h"
#include "core/suspend.h"
#include "sim/effects/parameter.h"
#include "validation/diagnosis/causes/whole_causes.h"

namespace nao::validation {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Joint> allJoints(const RobotModel& model) {
  std::vector<Joint> joints;
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    if (!model.actuators[j].coordinates.empty()) joints.push_back(toJoint(j));
  }
  return joints;
}

// Causes of one id stand in one line, in the order in which they come first.
void add(const std::vector<PlacedCause>& placed, std::vector<ListedCause>& listed) {
  for (const PlacedCause& one : placed) {
    auto at = std::find_if(listed.begin(), listed.end(), [&](const ListedCause& other) {
      return other.cause.id == one.cause.id;
    });
    if (at == listed.end()) at = listed.insert(at, {one.cause, {}});
    at->places.push_back(one.place);
  }
}

std::vector<ListedCause> jointLevel() {
  std::vector<ListedCause> listed;
  for (const Cause& cause : jointCauses()) {
    const bool shared = cause.scope == Scope::Robot;
    listed.push_back({cause, shared ? std::vector<std::string>{"all joints", "each joint"}
                                    : std::vector<std::string>{"each joint"}});
  }
  return listed;
}

std::vector<const sim::Parameter*> numbersOf(const Cause& cause) {
  std::vector<const sim::Parameter*> numbers;
  for (const FreeNumber& number : cause.free) {
    numbers.push_back(&sim::parameterOf(sim::standardEffects(), cause.effect, number.parameter));
  }
  return numbers;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

ListedCause findCause(const std::string& id, const RobotModel& model) {
  for (const char* level : {"joint", "limb", "robot"}) {
    for (const ListedCause& one : listCauses(level, model)) {
      if (one.cause.id == id) return one;
    }
  }
  throw InputError("no cause \"" + id + "\" in the catalogue; `usarnaoqi catalog` lists them");
}

}  // namespace

std::vector<ListedCause> listCauses(const std::string& level, const RobotModel& model) {
  if (level == "joint") return jointLevel();
  const std::vector<Joint> joints = allJoints(model);
  std::vector<ListedCause> listed;
  if (level == "limb") {
    const RobotModel hung = model.fixed_base ? model : suspend(model);
    for (const std::string& limb : limbsOf(hung, joints)) {
      add(limbCauses(hung, limb, joints), listed);
    }
  } else if (level == "robot") {
    add(robotCauses(model, joints), listed);
  } else {
    throw InputError("level: expected joint, limb or robot, found '" + level + "'");
  }
  return listed;
}

std::string toText(const std::vector<ListedCause>& causes) {
  std::ostringstream out;
  for (const ListedCause& one : causes) {
    std::vector<std::string> numbers;
    for (const FreeNumber& number : one.cause.free) numbers.push_back(number.parameter);
    out << one.cause.id << "  [" << joined(numbers) << "]  " << joined(one.places) << "\n";
  }
  return out.str();
}

std::string toJson(const std::vector<ListedCause>& causes) {
  Json all = Json::array();
  for (const auto& [cause, places] : causes) {
    Json numbers = Json::array();
    for (const sim::Parameter* p : numbersOf(cause)) {
      numbers.push_back({{"name", p->name},
                         {"unit", p->unit},
                         {"min", p->min},
                         {"max", p->max},
                         {"neutral", p->neutral},
                         {"smallest", p->smallest}});
    }
    all.push_back({{"id", cause.id},
                   {"effect", cause.effect},
                   {"summary", sim::standardEffects().find(cause.effect)->summary},
                   {"numbers", numbers},
                   {"places", places},
                   {"said_as", cause.fill("JOINT", "VALUE")},
                   {"told_apart_by", cause.separate}});
  }
  return all.dump(2) + "\n";
}

std::string showCause(const std::string& id, const RobotModel& model) {
  const auto [cause, places] = findCause(id, model);
  std::ostringstream out;
  out << cause.id << ": " << sim::standardEffects().find(cause.effect)->summary << "\n";
  out << "said as: " << cause.fill("JOINT", "VALUE") << "\n";
  out << "tried on: " << joined(places) << "\n";
  for (const sim::Parameter* p : numbersOf(cause)) {
    out << "fits " << p->name << (p->unit.empty() ? "" : " [" + p->unit + "]") << ": " << p->min
        << " to " << p->max << ", " << p->neutral << " does nothing, less than " << p->smallest
        << " matters to nobody\n";
  }
  out << "told from its rivals by: " << cause.separate << "\n";
  return out.str();
}

}  // namespace nao::validation
