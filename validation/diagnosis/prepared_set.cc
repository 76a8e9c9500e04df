#include "validation/diagnosis/prepared_set.h"

#include "validation/diagnosis/shared_cause.h"

namespace nao::validation {
namespace {

std::vector<PreparedJoint> onRigs(const std::shared_ptr<const RigSet>& set, int jobs) {
  std::vector<PreparedJoint> joints(set->joints().size());
  inParallel(joints.size(), jobs, [&](std::size_t i) {
    PreparedJoint& joint = joints[i];
    joint.simulator = std::make_unique<RigSimulator>(set, set->joints()[i]);
    joint.nominal = nominalNoise(set->model(), set->joints()[i]);
    joint.moments = compareNoise(*joint.simulator, joint.nominal);
    joint.noise = fitNoise(*joint.simulator, joint.nominal);
  });
  return joints;
}

}  // namespace

PreparedSet prepareSet(const LogSet& set, std::shared_ptr<const RobotModel> model, int jobs,
                       RigOptions options) {
  PreparedSet prepared;
  prepared.set = std::make_shared<RigSet>(set, model, options);
  prepared.joints = onRigs(prepared.set, jobs);
  return prepared;
}

}  // namespace nao::validation
