#include "validation/diagnosis/extend/ambiguity.h"

#include <nlohmann/json.hpp>

#include "core/config.h"
#include "validation/diagnosis/report/report_file.h"
#include "validation/merge_effects.h"

namespace nao::validation {
namespace {

using Json = nlohmann::json;

class Reader {
 public:
  Reader(const std::string& file, const RobotModel& model, std::string level)
      : file_(file), model_(model), level_(std::move(level)) {}

  Ambiguity read(const std::string& place, const Json& finding) const {
    Ambiguity one;
    one.place = place;
    one.level = level_;
    one.advice = finding.value("experiment", "");
    const std::string here = ReportedPlace(place).name;
    add(finding, here, one);
    for (const Json& rival : finding.at("rivals")) {
      if (rival.at("cause") != "unknown") add(rival, here, one);
    }
    return one;
  }

 private:
  void add(const Json& cause, const std::string& place, Ambiguity& to) const {
    const std::string label = cause.at("cause");
    const ReportedCause what(label);
    EffectSetting setting = neutralSetting(effectOf(cause), sim::standardEffects());
    setting.joints = jointsAt(what.place.empty() ? place : what.place, file_, model_);
    if (level_ == "joint" && setting.joints.size() != 1) {
      throw InputError(file_ + ": expected a joint at joint level, found '" + place + "'");
    }
    for (const Json& number : cause.at("numbers")) {
      const std::string name = number.at("parameter");
      if (setting.parameters.count(name) == 0) {
        throw InputError(file_ + ": no effect '" + setting.name + "' with '" + name + "'");
      }
      setting.parameters[name] = number.at("value");
    }
    to.causes.push_back(label);
    to.settings.push_back(std::move(setting));
  }

  const std::string& file_;
  const RobotModel& model_;
  std::string level_;
};

}  // namespace

std::vector<Ambiguity> ambiguitiesOf(const std::string& report_file, const RobotModel& model) {
  std::vector<Ambiguity> found;
  readReport(report_file, [&](const Json& report) {
    const Reader reader(report_file, model, report.value("level", "joint"));
    for (const Json& entry : report.at("joints")) {
      for (const Json& finding : entry.at("findings")) {
        Ambiguity one = reader.read(entry.at("joint"), finding);
        if (one.causes.size() > 1) found.push_back(std::move(one));
      }
    }
  });
  if (found.empty()) throw InputError(report_file + ": nothing is ambiguous between named causes");
  return found;
}

}  // namespace nao::validation
