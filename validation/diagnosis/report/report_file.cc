#include "validation/diagnosis/report/report_file.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/config.h"
#include "validation/diagnosis/causes/whole_causes.h"

namespace nao::validation {

void readReport(const std::string& file, const std::function<void(const nlohmann::json&)>& take) {
  std::ifstream in(file);
  if (!in) throw InputError(file + ": can not be read, expected the report.json of a diagnosis");
  try {
    take(nlohmann::json::parse(in));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file + ": expected the report.json of a diagnosis: " + error.what());
  }
}

std::string reportedModel(const std::string& file, const std::string& wanted) {
  std::string model;
  readReport(file, [&](const nlohmann::json& report) { report.at("model").get_to(model); });
  if (!wanted.empty() && wanted != model) {
    throw InputError("--model " + wanted + ": expected '" + model + "', the nominal robot of " +
                     file);
  }
  return model;
}

ReportedPlace::ReportedPlace(const std::string& text) {
  const std::size_t slash = text.rfind('/');
  name = slash == std::string::npos ? text : text.substr(slash + 1);
  robot_id = slash == std::string::npos ? "" : text.substr(0, slash);
}

ReportedCause::ReportedCause(const std::string& text) {
  constexpr char kAt[] = " at ";
  const std::size_t at = text.find(kAt);
  id = text.substr(0, at);
  if (at != std::string::npos) place = text.substr(at + sizeof kAt - 1);
}

std::string effectOf(const nlohmann::json& cause) {
  const ReportedCause what(cause.at("cause"));
  return cause.value("effect", what.id.substr(0, what.id.find('.')));
}

std::vector<Joint> jointsAt(const std::string& place, const std::string& file,
                            const RobotModel& model) {
  if (place == "robot") return {};
  if (const auto joint = model.findJoint(place)) return {*joint};
  std::vector<Joint> all;
  for (const Actuator& actuator : model.actuators) all.push_back(*model.findJoint(actuator.name));
  const std::vector<Joint> limb = jointsOf(model, place, all);
  if (limb.empty()) {
    throw InputError(file + ": robot '" + model.name + "' has no joint or limb '" + place + "'");
  }
  return limb;
}

}  // namespace nao::validation
