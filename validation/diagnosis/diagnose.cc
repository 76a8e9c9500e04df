#include "validation/diagnosis/diagnose.h"

#include <algorithm>
#include <memory>

#include "validation/diagnosis/shared_cause.h"

namespace nao::validation {
namespace {

using Searches = std::vector<std::unique_ptr<JointSearch>>;

// The largest of all joints but `left_out`, by null set.
NullRecord largest(const Searches& searches, std::size_t left_out) {
  NullRecord all;
  for (std::size_t j = 0; j < searches.size(); ++j) {
    if (j == left_out) continue;
    const NullRecord& one = searches[j]->nulls();
    all.gains.resize(std::max(all.gains.size(), one.gains.size()), 0);
    all.remainders.resize(std::max(all.remainders.size(), one.remainders.size()), -1e9);
    for (std::size_t n = 0; n < one.gains.size(); ++n) {
      all.gains[n] = std::max(all.gains[n], one.gains[n]);
      all.remainders[n] = std::max(all.remainders[n], one.remainders[n]);
    }
  }
  return all;
}

void tell(const DiagnosisOptions& options, const std::string& what, double part) {
  if (options.progress) options.progress(what, part);
}

SharedFinding describe(const SharedCause& shared, const std::vector<Cause>& causes) {
  const Cause& cause = causes[shared.cause];
  const auto numberOf = [](const Cause& of, double x) {
    const FreeNumber& free = of.free[0];
    return FoundNumber{free.parameter, free.unit, shownValue(free, x), x, x, x};
  };
  SharedFinding found;
  found.joints = shared.joints;
  found.finding.cause = cause.id;
  found.finding.effect = cause.effect;
  found.finding.gain = shared.gain;
  found.finding.numbers = {numberOf(cause, shared.x)};
  found.finding.experiment = cause.separate;
  found.finding.sentence = cause.fill("every joint", valueText(found.finding.numbers[0]));
  for (const auto& [rival, x] : shared.rivals) {
    found.finding.rivals.push_back({causes[rival].id, {numberOf(causes[rival], x)}, 0});
  }
  return found;
}

}  // namespace

SetDiagnosis diagnoseJoints(const std::vector<JointTask>& tasks, const std::vector<Cause>& causes,
                            const DiagnosisOptions& options) {
  SetDiagnosis result;
  result.null_sets = options.effort.null_sets;
  Searches searches;
  for (const JointTask& task : tasks) {
    searches.push_back(std::make_unique<JointSearch>(*task.joint, task.noise, causes,
                                                     options.effort, options.runs_per_joint));
  }
  if (searches.empty()) return result;
  tell(options, "looking at every cause", 0);
  inParallel(searches.size(), options.jobs, [&](std::size_t j) { searches[j]->begin(); });
  result.critical_gain = quantile(largest(searches, searches.size()).gains, 0.99);

  tell(options, "trying causes that all joints share", 0.4);
  const auto shared = findShared(searches, result.critical_gain, options.jobs);
  if (shared) {
    result.shared.push_back(describe(*shared, searches.front()->causes()));
    inParallel(searches.size(), options.jobs,
               [&](std::size_t j) { searches[j]->give(shared->cause, shared->x); });
  }
  std::vector<NullRecord> others;
  for (std::size_t j = 0; j < searches.size(); ++j) others.push_back(largest(searches, j));
  tell(options, "searching every joint", 0.6);
  result.joints.resize(searches.size());
  inParallel(searches.size(), options.jobs,
             [&](std::size_t j) { result.joints[j] = searches[j]->conclude(others[j]); });
  for (const JointVerdict& joint : result.joints) result.runs += joint.runs;
  result.verdict = overall(result.joints);
  if (!result.shared.empty() && result.verdict == Verdict::NoDiscrepancy) {
    result.verdict = result.shared[0].finding.rivals.empty() ? Verdict::Named : Verdict::Ambiguous;
  }
  tell(options, "done", 1);
  return result;
}

}  // namespace nao::validation
