#include "validation/diagnosis/joint/prepared_set.h"

#include <utility>

#include "validation/diagnosis/jobs/packed.h"
#include "validation/diagnosis/jobs/team.h"

namespace nao::validation {
namespace {

PreparedSet onRigs(const LogSet& set, std::shared_ptr<const RobotModel> model,
                   const RigOptions& options) {
  PreparedSet prepared;
  prepared.set = std::make_shared<RigSet>(set, std::move(model), options);
  for (const Joint joint : prepared.set->joints()) {
    PreparedJoint one;
    one.simulator = std::make_unique<RigSimulator>(prepared.set, joint);
    one.nominal = nominalNoise(prepared.set->model(), joint);
    prepared.joints.push_back(std::move(one));
  }
  return prepared;
}

}  // namespace

PreparedSet prepareSet(const LogSet& set, std::shared_ptr<const RobotModel> model, int jobs,
                       RigOptions options) {
  PreparedSet prepared = onRigs(set, std::move(model), options);
  inParallel(prepared.joints.size(), jobs, [&](std::size_t i) {
    PreparedJoint& joint = prepared.joints[i];
    joint.moments = compareNoise(*joint.simulator, joint.nominal);
    joint.noise = fitNoise(*joint.simulator, joint.nominal);
  });
  return prepared;
}

PreparedSet prepareSet(const LogSet& set, std::shared_ptr<const RobotModel> model,
                       const DiagnosisOptions& options) {
  PreparedSet prepared = onRigs(set, std::move(model), {});
  auto& joints = prepared.joints;
  const auto noise =
      askAll(*options.team, "noise", joints.size(), options.jobs, [&](std::size_t i) {
        const RigSimulator& joint = *joints[i].simulator;
        return options.kept.remember(joint.joint() + ".noise",
                                     [&] { return pack(fitNoise(joint, joints[i].nominal)); });
      });
  for (std::size_t i = 0; i < joints.size(); ++i) joints[i].noise = unpack<JointNoise>(noise[i]);
  return prepared;
}

}  // namespace nao::validation
