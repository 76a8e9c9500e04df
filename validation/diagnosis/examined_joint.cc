#include "validation/diagnosis/examined_joint.h"

#include "core/check.h"
#include "validation/diagnosis/packed.h"

namespace nao::validation {
namespace {

constexpr int kRuns = 16;  // simulated per mean that is shown; free choice

ExaminedJoint examine(const JointTask& task, const std::vector<EffectSetting>& found) {
  const std::vector<Split> seen{Split::Fit, Split::Select};
  return {replayJoint(*task.joint, {}, task.noise, kRuns, seen),
          replayJoint(*task.joint, found, task.noise, kRuns, seen),
          worstCourse(task, found, kRuns)};
}

}  // namespace

std::vector<ExaminedJoint> examineJoints(const SetDiagnosis& diagnosis,
                                         const std::vector<JointTask>& tasks,
                                         const DiagnosisOptions& options) {
  NAO_CHECK(tasks.size() == diagnosis.joints.size());
  const auto answers =
      askAll(*options.team, "examined", tasks.size(), options.jobs, [&](std::size_t j) {
        const JointVerdict& verdict = diagnosis.joints[j];
        return options.kept.remember(verdict.joint + ".examined", [&] {
          return pack(examine(tasks[j], foundEffects(diagnosis, verdict, tasks[j].joint->place())));
        });
      });
  std::vector<ExaminedJoint> joints;
  for (const std::string& answer : answers) joints.push_back(unpack<ExaminedJoint>(answer));
  return joints;
}

}  // namespace nao::validation
