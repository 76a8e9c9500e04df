#include "motion/joint_set.h"

namespace nao::motion {

JointSet jointsOfGroup(const RobotModel& model, std::string_view group) {
  JointSet joints;
  const auto found = model.groups.find(std::string(group));
  if (found == model.groups.end()) return joints;
  for (const std::string& name : found->second) {
    if (const auto joint = model.findJoint(name)) joints.set(index(*joint));
  }
  return joints;
}

JointSet allJoints(const RobotModel& model) {
  JointSet joints;
  for (std::size_t i = 0; i < model.jointCount(); ++i) joints.set(i);
  return joints;
}

}  // namespace nao::motion
