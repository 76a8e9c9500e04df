#include "naoqi_api/services/al_motion_names.h"

#include <algorithm>
#include <cmath>

#include "naoqi_api/convert.h"
#include "naoqi_api/services/finite.h"

namespace nao::services {
namespace {

using Numbers = std::vector<double>;
using Lists = std::vector<Numbers>;

Numbers readNumbers(const rpc::Value& value) {
  const auto* items = value.findItems();
  if (items == nullptr) return {readNumber(value)};
  Numbers numbers;
  for (const rpc::Value& item : *items) numbers.push_back(readNumber(item));
  return numbers;
}

bool isListOfLists(const rpc::Value& value) {
  const auto* items = value.findItems();
  return items != nullptr && std::any_of(items->begin(), items->end(),
                                         [](const rpc::Value& item) { return item.isList(); });
}

std::string count(std::size_t number, const char* noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

Lists readLists(const rpc::Value& value, std::size_t joints, const char* noun) {
  Lists lists;
  for (const rpc::Value& item : *value.findItems()) lists.push_back(readNumbers(item));
  if (lists.size() != joints) {
    throw rpc::CallError("expected one list of " + std::string(noun) + "s per joint, got " +
                         count(lists.size(), "list") + " for " + count(joints, "joint"));
  }
  return lists;
}

Lists readValues(const rpc::Value& values, std::size_t joints) {
  if (isListOfLists(values)) return readLists(values, joints, "angle");
  const Numbers flat = readNumbers(values);
  if (joints == 1) return {flat};
  if (!values.isList()) return Lists(joints, flat);
  if (flat.size() != joints) {
    throw rpc::CallError("expected one angle per joint, got " + count(flat.size(), "angle") +
                         " for " + count(joints, "joint"));
  }
  Lists lists;
  for (const double number : flat) lists.push_back({number});
  return lists;
}

// A flat list of times is one per joint where each joint has one value, else shared by all.
Lists readTimes(const rpc::Value& times, const Lists& values) {
  if (isListOfLists(times)) return readLists(times, values.size(), "time");
  const Numbers flat = readNumbers(times);
  const bool single_values = std::all_of(values.begin(), values.end(),
                                         [](const Numbers& list) { return list.size() == 1; });
  if (values.size() > 1 && single_values && flat.size() == values.size()) {
    Lists lists;
    for (const double time : flat) lists.push_back({time});
    return lists;
  }
  return Lists(values.size(), flat);
}

void checkTimes(const Course& course) {
  if (course.values.size() != course.times.size()) {
    throw rpc::CallError("expected one time per angle, got " + count(course.times.size(), "time") +
                         " for " + count(course.values.size(), "angle"));
  }
  double before = 0;
  for (const double time : course.times) {
    if (time <= before) throw rpc::CallError("times must be positive and ascending");
    before = time;
  }
}

}  // namespace

double readNumber(const rpc::Value& value) {
  const auto number = value.findNumber();
  if (!number) throw rpc::CallError("expected a number, got " + value.print());
  return finite(*number);
}

std::vector<std::string> expandNames(const RobotModel& model,
                                     const std::vector<std::string>& names) {
  std::vector<std::string> expanded;
  for (const std::string& name : names) {
    const auto group = model.groups.find(name);
    if (group != model.groups.end() && name != "Chains") {
      expanded.insert(expanded.end(), group->second.begin(), group->second.end());
    } else if (model.findJoint(name)) {
      expanded.push_back(name);
    } else {
      throw rpc::CallError("unknown joint or chain name: " + name);
    }
  }
  return expanded;
}

std::vector<Joint> jointsNamed(const RobotModel& model, const std::vector<std::string>& names) {
  std::vector<Joint> joints;
  for (const std::string& name : expandNames(model, names)) {
    joints.push_back(*model.findJoint(name));
  }
  return joints;
}

std::vector<std::string> readNames(const rpc::Value& names) {
  return names.to<std::vector<std::string>>();
}

JointNames::JointNames(const RobotModel& model) : model_(model) {
  const auto add = [this](const std::string& name) { joints_[name] = jointsNamed(model_, {name}); };
  for (const Actuator& actuator : model.actuators) add(actuator.name);
  for (const auto& [name, meant] : model.aliases) add(name);
  for (const auto& [name, members] : model.groups) {
    if (name != "Chains") add(name);
  }
}

std::vector<Joint> JointNames::find(const rpc::Value& names) const {
  const auto* items = names.findItems();
  std::vector<Joint> joints;
  if (!items) return jointsNamed(model_, readNames(names));
  joints.reserve(items->size());
  for (const rpc::Value& item : *items) {
    const std::string* name = item.findText();
    const auto found = name ? joints_.find(*name) : joints_.end();
    if (found == joints_.end()) return jointsNamed(model_, readNames(names));  // which says why
    joints.insert(joints.end(), found->second.begin(), found->second.end());
  }
  return joints;
}

std::vector<Course> spreadCourses(const RobotModel& model, const std::vector<std::string>& names,
                                  const rpc::Value& values, const rpc::Value& times) {
  const std::vector<Joint> joints = jointsNamed(model, names);
  const Lists all_values = readValues(values, joints.size());
  const Lists all_times = readTimes(times, all_values);
  std::vector<Course> courses;
  motion::JointSet seen;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Course course{joints[i], all_values[i], all_times[i]};
    checkTimes(course);
    if (seen.test(index(joints[i]))) continue;
    seen.set(index(joints[i]));
    courses.push_back(course);
  }
  return courses;
}

std::vector<double> spreadNumbers(std::size_t joints, const rpc::Value& values) {
  std::vector<double> numbers = readNumbers(values);
  if (!values.isList() || (numbers.size() == 1 && joints > 1)) numbers.resize(joints, numbers[0]);
  if (numbers.size() != joints) {
    throw rpc::CallError("expected one value per joint, got " + count(numbers.size(), "value") +
                         " for " + count(joints, "joint"));
  }
  return numbers;
}

double readFraction(double fraction) {
  if (!(finite(fraction) > 0)) {
    throw rpc::CallError("the fraction of maximum speed must be above 0, up to 1");
  }
  return std::min(fraction, 1.0);
}

}  // namespace nao::services
