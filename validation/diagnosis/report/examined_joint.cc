#include "validation/diagnosis/report/examined_joint.h"

#include "core/check.h"
#include "validation/diagnosis/jobs/packed.h"

namespace nao::validation {
namespace {

constexpr int kRuns = 8;  // simulated per mean that is shown; free choice

ExaminedJoint examine(const JointTask& task, const SetDiagnosis& diagnosis,
                      const JointVerdict& verdict) {
  const JointSimulator& exact = task.joint->exact();
  const std::vector<Joint> place = task.joint->place();
  const auto found = foundEffects(diagnosis, verdict, place);
  const auto replayed = [&](const std::vector<EffectSetting>& causes) {
    return replayRuns(exact, causes, task.noise, kRuns, {Split::Fit, Split::Select});
  };
  const ReplayedRuns nominal = replayed({});
  const ReplayedRuns extended = found.empty() ? nominal : replayed(found);
  ExaminedJoint examined{compareReplay(exact, nominal, task.noise.start_sd),
                         compareReplay(exact, extended, task.noise.start_sd),
                         {}};
  if (verdict.verdict == Verdict::NoDiscrepancy) return examined;
  examined.course = worstCourse(exact, nominal, extended);
  const auto [rival, effects] = rivalEffects(diagnosis, verdict, place);
  if (!rival.empty()) addRival(examined.course, task, rival, effects, kRuns);
  return examined;
}

}  // namespace

std::vector<ExaminedJoint> examineJoints(const SetDiagnosis& diagnosis,
                                         const std::vector<JointTask>& tasks,
                                         const DiagnosisOptions& options) {
  NAO_CHECK(tasks.size() == diagnosis.joints.size());
  const auto answers =
      askAll(*options.team, "examined", tasks.size(), options.jobs, [&](std::size_t j) {
        const JointVerdict& verdict = diagnosis.joints[j];
        return options.kept.remember(verdict.joint + ".examined",
                                     [&] { return pack(examine(tasks[j], diagnosis, verdict)); });
      });
  std::vector<ExaminedJoint> joints;
  for (const std::string& answer : answers) joints.push_back(unpack<ExaminedJoint>(answer));
  return joints;
}

}  // namespace nao::validation
