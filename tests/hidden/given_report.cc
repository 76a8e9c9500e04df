#include "tests/hidden/given_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/check.h"

namespace nao::hidden {
namespace {

using Json = nlohmann::json;

validation::StatementKind kindOf(const Json& from) {
  if (!from.contains("record") || from.at("record").is_null()) return {};
  const Json& record = from.at("record");
  return {record.at("level"), record.at("verdict"), record.at("size"), record.at("signals"),
          record.at("repeats")};
}

void readNumbers(const Json& numbers, GivenCause& cause) {
  for (const Json& number : numbers) {
    const double value = number.at("value").is_null() ? 0 : number.at("value").get<double>();
    if (cause.has_number) {
      cause.shape.emplace_back(number.at("parameter"), value);
      continue;
    }
    cause.has_number = true;
    cause.parameter = number.at("parameter");
    cause.value = value;
    const auto read = [](const Json& x) { return x.is_number() ? x.get<double>() : 0.0; };
    cause.deviation = read(number.at("deviation"));
    cause.low = read(number.at("deviation_90").at(0));
    cause.high = read(number.at("deviation_90").at(1));
  }
}

GivenCause causeOf(const Json& finding, const std::string& joint) {
  GivenCause cause;
  cause.cause = finding.at("cause");
  cause.effect = finding.at("effect");
  cause.joint = joint;
  cause.gain = finding.at("gain_nats");
  cause.kind = kindOf(finding);
  for (const Json& rival : finding.at("rivals")) cause.rivals.push_back(rival.at("cause"));
  readNumbers(finding.at("numbers"), cause);
  return cause;
}

GivenCause adjustmentOf(const Json& adjustment, const std::string& joint) {
  GivenCause cause;
  cause.cause = adjustment.at("cause");
  cause.effect = adjustment.at("effect");
  cause.joint = joint;
  readNumbers(adjustment.at("numbers"), cause);
  return cause;
}

bool isSmall(const Json& finding) { return finding.at("below_size_of_interest").get<bool>(); }

void addCauses(const Json& findings, const std::string& joint, GivenReport& report) {
  for (const Json& finding : findings) {
    if (!isSmall(finding)) report.causes.push_back(causeOf(finding, joint));
  }
}

// As `extend` takes them.
void addAdjustments(const Json& of, GivenReport& report) {
  const std::string joint = of.at("joint"), verdict = of.at("verdict");
  for (const Json& one : of.value("adjustments", Json::array())) {
    report.adjustments.push_back(adjustmentOf(one, joint));
  }
  if (verdict == "unknown" || verdict == "partly_explained") return;
  for (const Json& one : of.at("findings")) {
    if (isSmall(one)) report.adjustments.push_back(adjustmentOf(one, joint));
  }
}

}  // namespace

bool GivenReport::remains(const std::string& joint) const {
  return std::any_of(joints.begin(), joints.end(), [&](const GivenJoint& one) {
    return (joint.empty() || one.joint == joint) &&
           (one.verdict == "unknown" || one.verdict == "partly_explained");
  });
}

GivenReport readReport(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    GivenReport report;
    report.verdict = json.at("verdict");
    if (json.contains("shared")) addCauses(json.at("shared"), "", report);
    if (json.contains("joints")) {
      for (const Json& joint : json.at("joints")) {
        report.joints.push_back(
            {joint.at("joint"), joint.at("verdict"), joint.at("signature"), kindOf(joint)});
        addCauses(joint.at("findings"), joint.at("joint"), report);
        addAdjustments(joint, report);
      }
    }
    std::stable_sort(report.causes.begin(), report.causes.end(),
                     [](const GivenCause& a, const GivenCause& b) { return a.gain > b.gain; });
    return report;
  } catch (const Json::exception& error) {
    throw InputError(std::string("expected the report of a diagnosis: ") + error.what());
  }
}

std::vector<std::string> readFaults(const std::string& printed) {
  std::vector<std::string> faults;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind, next;
    if (words >> kind >> next && next != "(note)") faults.push_back(kind);
  }
  return faults;
}

}  // namespace nao::hidden
