#include "validation/diagnosis/extend/extension.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/config.h"
#include "sim/effects/catalogue.h"
#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/report/report_file.h"
#include "validation/merge_effects.h"

namespace nao::validation {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

template <class Names>
std::string list(const Names& names) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

InputError noSuchNumber(const std::string& file, const EffectSetting& setting, const Json& number) {
  std::vector<std::string> known;
  for (const auto& [name, value] : setting.parameters) known.push_back(name);
  return InputError(file + ": " + setting.name + " has no parameter '" +
                    number.at("parameter").get<std::string>() +
                    "', expected one of: " + list(known));
}

// A report gives the numbers that were fitted; what was not is as if switched off.
EffectSetting settingOf(const Json& cause, const std::vector<Joint>& joints,
                        const std::string& file) {
  const std::string effect = effectOf(cause);
  if (sim::standardEffects().find(effect) == nullptr) {
    throw InputError(file + ": '" + effect + "' is no effect of the catalogue");
  }
  EffectSetting setting = neutralSetting(effect, sim::standardEffects());
  setting.joints = joints;
  setting.place = file;
  for (const Json& number : cause.at("numbers")) {
    const auto parameter = setting.parameters.find(number.at("parameter").get<std::string>());
    if (parameter == setting.parameters.end()) throw noSuchNumber(file, setting, number);
    parameter->second = number.at("value");
  }
  return setting;
}

/// Takes effects out of a report, one finding after the other.
class Acceptance {
 public:
  Acceptance(std::string file, const std::vector<std::string>& causes, const RobotModel& model)
      : file_(std::move(file)), model_(model), wanted_(causes.begin(), causes.end()) {}

  void takeFrom(const Json& finding, const std::vector<Joint>& joints) {
    held_.insert(finding.at("cause").get<std::string>());
    if (wants(finding)) return take(finding, joints);
    for (const Json& rival : finding.at("rivals")) {
      if (rival.at("numbers").empty()) continue;  // what has no name
      held_.insert(rival.at("cause").get<std::string>());
      if (wanted_.count(rival.at("cause")) > 0) return take(rival, jointsOf(rival, joints));
    }
  }

  std::vector<EffectSetting> finish() {
    for (const std::string& id : wanted_) {
      if (held_.count(id) == 0) {
        throw InputError("--accept " + id + ": expected a cause of " + file_ +
                         ", one of: " + list(held_));
      }
    }
    if (settings_.empty()) {
      throw InputError(file_ + ": names no cause without a rival" +
                       (held_.empty() ? "" : "; expected --accept with one of: " + list(held_)));
    }
    return std::move(settings_);
  }

 private:
  std::vector<Joint> jointsOf(const Json& rival, const std::vector<Joint>& beside) const {
    const ReportedCause what(rival.at("cause"));
    return what.place.empty() ? beside : jointsAt(what.place, file_, model_);
  }

  bool wants(const Json& finding) const {
    if (!wanted_.empty()) return wanted_.count(finding.at("cause")) > 0;
    return finding.at("rivals").empty() && !finding.value("below_size_of_interest", false);
  }

  void take(const Json& cause, const std::vector<Joint>& joints) {
    settings_.push_back(settingOf(cause, joints, file_));
  }

  std::string file_;
  const RobotModel& model_;
  std::set<std::string> wanted_, held_;
  std::vector<EffectSetting> settings_;
};

// Every extension is of one robot.
void requireRobot(const Json& report, const std::string& robot_id, const std::string& file) {
  std::set<std::string> robots;
  for (const Json& entry : report.at("joints"))
    robots.insert(ReportedPlace(entry.at("joint")).robot_id);
  robots.erase("");
  if (robots.count(robot_id) > 0 || (robots.empty() && robot_id.empty())) return;
  const std::string fault =
      robot_id.empty() ? "is of several robots" : "is not of '" + robot_id + "'";
  throw InputError(file + ": " + fault + "; expected " +
                   (robots.empty() ? "no --robot-id" : "--robot-id with one of: " + list(robots)));
}

std::string number(double value) {
  std::ostringstream text;
  text << std::setprecision(9) << value;
  return text.str();
}

std::string lineOf(const EffectSetting& setting, const RobotModel& model) {
  std::string line = "  - {effect: " + setting.name;
  for (const auto& [name, value] : setting.parameters) line += ", " + name + ": " + number(value);
  if (!setting.joints.empty()) {
    line += ", joints: [";
    for (const Joint joint : setting.joints) {
      line += (line.back() == '[' ? "" : ", ") + model.actuators[index(joint)].name;
    }
    line += "]";
  }
  return line + "}\n";
}

// What was fitted beside the causes and is perhaps too small to be one; beside a remainder it would
// stand in for what has no name.
std::vector<Json> smallOnes(const Json& joint) {
  const std::string verdict = joint.value("verdict", "");
  if (verdict == wordOf(Verdict::Unknown) || verdict == wordOf(Verdict::PartlyExplained)) return {};
  std::vector<Json> small = joint.value("adjustments", std::vector<Json>{});
  for (const Json& finding : joint.at("findings")) {
    if (finding.value("below_size_of_interest", false)) small.push_back(finding);
  }
  return small;
}

}  // namespace

std::vector<EffectSetting> acceptedEffects(const std::string& report_file, const Accepted& accepted,
                                           const RobotModel& model) {
  Acceptance acceptance(report_file, accepted.causes, model);
  readReport(report_file, [&](const Json& report) {
    requireRobot(report, accepted.robot_id, report_file);
    for (const Json& finding : report.at("shared")) {
      if (finding.value("robot_id", "") == accepted.robot_id) acceptance.takeFrom(finding, {});
    }
    for (const Json& entry : report.at("joints")) {
      const ReportedPlace place(entry.at("joint"));
      if (place.robot_id != accepted.robot_id) continue;
      const std::vector<Joint> joints = jointsAt(place.name, report_file, model);
      for (const Json& finding : entry.at("findings")) acceptance.takeFrom(finding, joints);
    }
  });
  return acceptance.finish();
}

std::vector<EffectSetting> reportedAdjustments(const std::string& report_file,
                                               const Accepted& accepted, const RobotModel& model) {
  const std::set<std::string> taken(accepted.causes.begin(), accepted.causes.end());
  std::vector<EffectSetting> settings;
  readReport(report_file, [&](const Json& report) {
    for (const Json& entry : report.at("joints")) {
      const ReportedPlace place(entry.at("joint"));
      if (place.robot_id != accepted.robot_id) continue;
      const std::vector<Joint> joints = jointsAt(place.name, report_file, model);
      for (const Json& one : smallOnes(entry)) {
        if (taken.count(one.at("cause")) > 0) continue;
        settings.push_back(settingOf(one, joints, report_file));
      }
    }
  });
  return settings;
}

void requireNewRobot(const std::string& robots_dir, const std::string& name) {
  const fs::path folder = fs::path(robots_dir) / name;
  if (name.empty() || fs::path(name).has_parent_path() || name[0] == '.') {
    throw InputError("'" + name + "': expected the name of a new robot, without a folder");
  }
  if (fs::exists(folder)) throw InputError(folder.string() + ": there is such a robot already");
}

std::string writeExtendedRobot(const std::string& robots_dir, const std::string& name,
                               const RobotModel& model, const std::vector<EffectSetting>& causes,
                               const std::string& origin) {
  requireNewRobot(robots_dir, name);
  const fs::path folder = fs::path(robots_dir) / name;
  std::error_code failed;
  fs::create_directory(folder, failed);
  const std::string file = (folder / "body.yaml").string();
  std::ofstream out(file);
  out << "# " << model.name << ", extended by what measured data showed.\n# " << origin << "\n"
      << "like: " << model.name << "\n\neffects:\n";
  for (const EffectSetting& setting : mergedEffects(model, causes, sim::standardEffects())) {
    out << lineOf(setting, model);
  }
  if (!out.flush()) throw InputError(file + ": can not be written");
  return file;
}

}  // namespace nao::validation
