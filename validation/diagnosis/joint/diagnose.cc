#include "validation/diagnosis/joint/diagnose.h"

#include <algorithm>

#include "validation/diagnosis/joint/joint_crowd.h"
#include "validation/diagnosis/joint/shared_cause.h"
#include "validation/diagnosis/joint/shared_link.h"

namespace nao::validation {
namespace {

SharedFinding describe(const SharedCause& shared, const std::vector<Cause>& causes) {
  const Cause& cause = causes[shared.cause];
  const auto numberOf = [](const Cause& of, double x, double low, double high) {
    const FreeNumber& free = of.free[0];
    return FoundNumber{free.parameter, free.unit, shownValue(free, x), x, low, high, free.form};
  };
  SharedFinding found;
  found.joints = shared.joints;
  found.finding.cause = cause.id;
  found.finding.effect = cause.effect;
  found.finding.gain = shared.gain;
  found.finding.numbers = {numberOf(cause, shared.x, shared.low, shared.high)};
  found.finding.experiment = cause.separate;
  found.finding.sentence = cause.fill("every joint", valueText(found.finding.numbers[0]));
  for (const auto& [rival, x, place] : shared.rivals) {
    found.finding.rivals.push_back(
        {causes[rival].id, causes[rival].effect, place, {numberOf(causes[rival], x, x, x)}, 0});
  }
  return found;
}

// Beside a remainder it may be the nearest imitation of a law that is not in the catalogue.
void doubt(SharedFinding& shared, const std::vector<JointVerdict>& joints) {
  if (std::none_of(joints.begin(), joints.end(),
                   [](const JointVerdict& joint) { return joint.remains(); })) {
    return;
  }
  Finding& finding = shared.finding;
  finding.rivals.push_back(whatHasNoName());
  if (finding.rivals.size() == 1) finding.experiment = "look at the signature of the unknown";
}

// What several joints share. Where the link of one explains the same better than one gravity for
// all, that is given to those that carry it, and nothing is shared.
std::optional<SharedCause> sharedUnlessOfALink(JointCrowd& joints,
                                               const std::vector<JointTask>& tasks,
                                               double critical) {
  std::optional<SharedCause> shared = findShared(joints, critical);
  if (!shared || !joints.causes()[shared->cause].one_for_all) return shared;
  const std::optional<SharedLink> link = findLink(joints, critical);
  if (!link || link->gain < shared->gain - critical) return shared;
  if (link->gain <= shared->gain + critical) {
    shared->rivals.push_back({link->cause, link->x[0], tasks[link->joint].joint->joint()});
    return shared;
  }
  joints.giveLink(link->joint, link->cause, link->x, shared->cause);
  return std::nullopt;
}

}  // namespace

Verdict overall(const SetDiagnosis& diagnosis) {
  const Verdict joints = overall(diagnosis.joints);
  if (joints == Verdict::Unknown && !diagnosis.shared.empty()) return Verdict::PartlyExplained;
  if (joints != Verdict::NoDiscrepancy || diagnosis.shared.empty()) return joints;
  const auto rivals = [](const SharedFinding& one) { return !one.finding.rivals.empty(); };
  const bool any = std::any_of(diagnosis.shared.begin(), diagnosis.shared.end(), rivals);
  return any ? Verdict::Ambiguous : Verdict::Named;
}

SetDiagnosis diagnoseJoints(const std::vector<JointTask>& tasks, const std::vector<Cause>& causes,
                            const DiagnosisOptions& options) {
  SetDiagnosis result;
  result.null_sets = options.effort.null_sets;
  if (tasks.empty()) return result;
  JointCrowd joints(tasks, causes, options);
  joints.begin();
  result.critical_gain = quantile(joints.largestNulls().gains, 1 - options.effort.false_alarms);
  const auto shared = sharedUnlessOfALink(joints, tasks, result.critical_gain);
  if (shared) {
    result.shared.push_back(describe(*shared, joints.causes()));
    joints.give(shared->cause, shared->x);
  }
  result.joints = joints.conclude();
  if (shared) doubt(result.shared.back(), result.joints);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    result.joints[i].nominal_noise = tasks[i].nominal.torque_sd;
    result.runs += result.joints[i].runs;
  }
  result.verdict = overall(result);
  return result;
}

}  // namespace nao::validation
