#include "validation/diagnosis/prepared_set.h"

#include <algorithm>
#include <cmath>

#include "validation/diagnosis/shared_cause.h"

namespace nao::validation {
namespace {

// Loads are calculated again if the spread they were calculated with is off by more than this
// factor: what play makes of noise grows less than in proportion to it.
constexpr double kFar = 1.5;

EffectSetting torqueOf(Joint joint, const JointNoise& noise) {
  return {"process_noise", {{"sd", noise.torque_sd}, {"time", noise.torque_time}}, {joint}, ""};
}

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

bool isFar(const std::vector<PreparedJoint>& joints) {
  return std::any_of(joints.begin(), joints.end(), [](const PreparedJoint& joint) {
    const double fitted = joint.noise.torque_sd, nominal = joint.nominal.torque_sd;
    return fitted > kFar * nominal || nominal > kFar * fitted;
  });
}

}  // namespace

PreparedSet prepareSet(const LogSet& set, std::shared_ptr<const RobotModel> model, int jobs,
                       RigOptions options) {
  options.jobs = jobs;
  for (std::size_t j = 0; j < model->jointCount(); ++j) {
    if (model->actuators[j].coordinates.empty()) continue;
    options.noise.push_back(torqueOf(toJoint(j), nominalNoise(*model, toJoint(j))));
  }
  PreparedSet prepared;
  prepared.set = std::make_shared<RigSet>(set, model, options);
  prepared.joints = onRigs(prepared.set, jobs);
  if (!isFar(prepared.joints)) return prepared;
  options.noise.clear();
  for (std::size_t i = 0; i < prepared.joints.size(); ++i) {
    options.noise.push_back(torqueOf(prepared.set->joints()[i], prepared.joints[i].noise));
  }
  prepared.set = std::make_shared<RigSet>(set, model, options);
  prepared.joints = onRigs(prepared.set, jobs);
  return prepared;
}

}  // namespace nao::validation
