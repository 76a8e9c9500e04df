#include "motion/cartesian.h"

#include <algorithm>

namespace nao::motion {

std::optional<Chain> findChain(const RobotModel& model, std::string_view name) {
  const bool biped = model.feet.size() == 2;
  const JointSet legs = jointsOfGroup(model, "LLeg") | jointsOfGroup(model, "RLeg");
  if (name == "Torso") {
    if (!biped) return std::nullopt;
    return Chain{Chain::Kind::Torso, Effector{}, legs};
  }
  const auto chains = model.groups.find("Chains");
  if (chains == model.groups.end() ||
      std::find(chains->second.begin(), chains->second.end(), name) == chains->second.end()) {
    return std::nullopt;
  }
  const auto place = findEffector(model, name);
  if (!place) return std::nullopt;
  if (biped && name == "LLeg") return Chain{Chain::Kind::LeftLeg, *place, legs};
  if (biped && name == "RLeg") return Chain{Chain::Kind::RightLeg, *place, legs};
  Chain chain{Chain::Kind::Upper, *place, jointsOfGroup(model, name)};
  for (std::size_t i = 0; i < model.jointCount(); ++i) {
    if (model.actuators[i].coordinates.empty()) chain.joints.reset(i);  // a hand
  }
  return chain;
}

Pose calcSpace(const Kinematics& body, Space space, const Pose2& odometry) {
  if (space == Space::Torso) return Pose::Identity();
  const Pose X_TR = body.calcRobotFrame();
  if (space == Space::Robot) return X_TR;
  Pose X_WR = translation({odometry.x, odometry.y, 0});
  X_WR.linear() = rotationFromRpy(0, 0, odometry.theta);
  return X_TR * X_WR.inverse();
}

}  // namespace nao::motion
