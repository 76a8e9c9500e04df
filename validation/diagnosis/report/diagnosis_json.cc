#include "validation/diagnosis/report/diagnosis_json.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "validation/report.h"

namespace nao::validation {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const FoundNumber& number) {
  const auto [low, high] = valueInterval(number);
  return {{"parameter", number.parameter}, {"unit", number.unit},
          {"value", number.value},         {"interval_90", {low, high}},
          {"deviation", number.deviation}, {"deviation_90", {number.low, number.high}}};
}

Json toJson(const std::vector<FoundNumber>& numbers) {
  Json list = Json::array();
  for (const FoundNumber& number : numbers) list.push_back(toJson(number));
  return list;
}

Json toJson(const std::vector<ProfilePoint>& profile) {
  Json list = Json::array();
  for (const ProfilePoint& point : profile) {
    list.push_back({{"deviation", point.deviation}, {"lost_nats", point.lost}});
  }
  return list;
}

Json toJson(const StatementKind& kind, const std::string& record) {
  if (record.empty()) return nullptr;
  return {{"level", kind.level},     {"verdict", kind.verdict}, {"size", kind.size},
          {"signals", kind.signals}, {"repeats", kind.repeats}, {"text", record}};
}

Json toJson(const Finding& finding) {
  Json rivals = Json::array();
  for (const Rival& rival : finding.rivals) {
    rivals.push_back({{"cause", rival.label()},
                      {"effect", rival.effect},
                      {"numbers", toJson(rival.numbers)},
                      {"behind_nats", rival.behind}});
  }
  return {{"cause", finding.cause},
          {"effect", finding.effect},
          {"sentence", finding.sentence},
          {"numbers", toJson(finding.numbers)},
          {"gain_nats", finding.gain},
          {"share_of_excess", finding.share},
          {"held_out_gain_nats", finding.held_out_gain},
          {"folds", finding.folds},
          {"folds_better", finding.folds_better},
          {"one_motion_only", finding.one_motion_only},
          {"below_size_of_interest", finding.small},
          {"as_shaped", toJson(finding.as_shaped)},
          {"rivals", rivals},
          {"experiment", finding.experiment},
          {"profile", toJson(finding.profile)},
          {"confusion", {{"causes", finding.confusion.causes}, {"share", finding.confusion.share}}},
          {"record", toJson(finding.kind, finding.record)}};
}

Json toJson(const JointVerdict& joint) {
  Json findings = Json::array(), rejected = Json::array();
  for (const Finding& finding : joint.findings) findings.push_back(toJson(finding));
  for (const Rejected& one : joint.rejected) {
    rejected.push_back({{"cause", one.cause}, {"gain_nats", one.gain}, {"reason", one.reason}});
  }
  Json adjustments = Json::array();
  for (const Adjustment& one : joint.adjustments) {
    adjustments.push_back({{"cause", one.cause},
                           {"effect", one.effect},
                           {"numbers", toJson(std::vector{one.number})}});
  }
  return {{"joint", joint.joint},
          {"verdict", wordOf(joint.verdict)},
          {"findings", findings},
          {"adjustments", adjustments},
          {"rejected", rejected},
          {"not_tried", joint.not_tried},
          {"critical_gain_nats", joint.critical_gain},
          {"misfit_before", joint.misfit_before},
          {"misfit_after", joint.misfit_after},
          {"remainder_score", joint.remainder_score},
          {"remainder_critical", joint.remainder_critical},
          {"signature", joint.signature},
          {"repeat_split_ratio", joint.split_ratio},
          {"with_repeats", joint.with_repeats},
          {"repeats", joint.repeats},
          {"torque_noise_nm", joint.noise},
          {"nominal_torque_noise_nm", joint.nominal_noise},
          {"record", toJson(joint.kind, joint.record)},
          {"runs", joint.runs}};
}

void write(std::ostream& out, const std::string& who, const Finding& finding) {
  out << who << ": " << finding.sentence;
  if (!finding.numbers.empty() && finding.numbers[0].low < finding.numbers[0].high) {
    out << " (90 %: " << sizeIntervalText(finding) << ")";
  }
  out << ": " << finding.cause;
  for (const Rival& rival : finding.rivals) out << " or " << rival.label();
  if (!finding.rivals.empty()) out << "; to tell them apart: " << finding.experiment;
  if (finding.one_motion_only) out << " (seen in one motion only)";
  out << "\n";
  if (!finding.record.empty()) out << "  such statements before: " << finding.record << "\n";
}

// What a verdict of `unknown` or `partly_explained` leaves open.
std::string unexplainedBy(const JointVerdict& joint) {
  std::ostringstream out;
  if (joint.verdict == Verdict::PartlyExplained && joint.remainder_critical > 0 &&
      !joint.remains()) {
    out << "a part is explained by a cause too small to be of interest alone, which may stand in "
           "for one that is in no catalogue";
  } else {
    out << "something remains that no cause of the catalogue explains (misfit "
        << joint.misfit_after << " of the noise floor)";
  }
  return out.str();
}

}  // namespace

std::string toJson(const SetDiagnosis& diagnosis, const Provenance& provenance) {
  Json shared = Json::array(), joints = Json::array();
  for (const SharedFinding& one : diagnosis.shared) {
    Json entry = toJson(one.finding);
    entry["joints"] = one.joints;
    if (!one.robot_id.empty()) entry["robot_id"] = one.robot_id;
    shared.push_back(entry);
  }
  for (const JointVerdict& joint : diagnosis.joints) joints.push_back(toJson(joint));
  const Json all = {{"command", provenance.command},
                    {"set", provenance.set},
                    {"set_sha256", provenance.set_sha256},
                    {"model", provenance.model},
                    {"model_sha256", provenance.model_sha256},
                    {"level", provenance.level},
                    {"verdict", wordOf(diagnosis.verdict)},
                    {"exit_code", exitCodeOf(diagnosis.verdict)},
                    {"critical_gain_nats", diagnosis.critical_gain},
                    {"null_sets", diagnosis.null_sets},
                    {"runs", diagnosis.runs},
                    {"shared", shared},
                    {"joints", joints}};
  return all.dump(2);
}

std::string toText(const SetDiagnosis& diagnosis) {
  std::ostringstream out;
  out << "verdict: " << wordOf(diagnosis.verdict) << "\n";
  for (const SharedFinding& one : diagnosis.shared) {
    write(out, (one.robot_id.empty() ? "" : one.robot_id + "/") + "all joints", one.finding);
  }
  for (const JointVerdict& joint : diagnosis.joints) {
    for (const Finding* finding : joint.named()) write(out, joint.joint, *finding);
    if (joint.verdict == Verdict::Unknown || joint.verdict == Verdict::PartlyExplained) {
      out << joint.joint << ": " << unexplainedBy(joint);
      if (!joint.signature.empty()) out << "; what the model lacks goes with " << joint.signature;
      out << "\n";
      if (!joint.record.empty()) out << "  such statements before: " << joint.record << "\n";
    }
    if (joint.scattersOtherwise()) {
      out << joint.joint << ": process_noise: its repeats scatter as under random torques of "
          << fixed(joint.noise, 3) << " N m, " << fixed(joint.noise / joint.nominal_noise, 1)
          << " times those of the robot's file\n";
    }
    if (!joint.not_tried.empty()) {
      out << joint.joint << ": unfinished, not tried:";
      for (const std::string& cause : joint.not_tried) out << " " << cause;
      out << "\n";
    }
  }
  if (diagnosis.verdict == Verdict::NoDiscrepancy && !diagnosis.joints.empty()) {
    out << "such statements before: " << diagnosis.joints.front().record << "\n";
  }
  out << diagnosis.joints.size() << " joints, threshold " << diagnosis.critical_gain
      << " nats from " << diagnosis.null_sets << " null sets, " << diagnosis.runs << " runs\n";
  return out.str();
}

}  // namespace nao::validation
