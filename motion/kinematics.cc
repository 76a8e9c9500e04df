#include "motion/kinematics.h"

#include <algorithm>
#include <utility>

#include "core/check.h"

namespace nao::motion {
namespace {

std::optional<Effector> findFrame(const RobotModel& model, std::string_view name) {
  for (const Frame& frame : model.frames) {
    if (frame.name == name) return Effector{frame.body, frame.X_BF};
  }
  return std::nullopt;
}

std::optional<Effector> findHinge(const RobotModel& model, std::string_view name) {
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    if (model.coordinates[i].name == name)
      return Effector{static_cast<int>(i) + 1, Pose::Identity()};
  }
  return std::nullopt;
}

// The last member of the chain that turns something: a hand's actuator has no hinge.
std::optional<Effector> findChainEnd(const RobotModel& model, std::string_view name) {
  const auto group = model.groups.find(std::string(name));
  if (group == model.groups.end()) return std::nullopt;
  for (auto member = group->second.rbegin(); member != group->second.rend(); ++member) {
    if (const auto hinge = findHinge(model, *member)) return hinge;
  }
  return std::nullopt;
}

Effector solePlace(const FootModel& foot) { return {foot.body, foot.X_BS}; }

}  // namespace

std::optional<Effector> findEffector(const RobotModel& model, std::string_view name) {
  if (name == "Torso") return Effector{};
  if (const auto frame = findFrame(model, name)) return frame;
  if (model.feet.size() == 2 && name == "LLeg") return solePlace(model.feet[0]);
  if (model.feet.size() == 2 && name == "RLeg") return solePlace(model.feet[1]);
  if (const auto chain_end = findChainEnd(model, name)) return chain_end;
  if (const auto body = model.findBody(name)) return Effector{*body, Pose::Identity()};
  return findHinge(model, name);
}

Kinematics::Kinematics(std::shared_ptr<const RobotModel> model)
    : model_(std::move(model)), X_TB_(model_->bodies.size(), Pose::Identity()) {
  for (const Body& body : model_->bodies) total_mass_ += body.mass;
  update(JointArray<double>(model_->jointCount(), 0.0));
}

void Kinematics::update(const JointArray<double>& angle) {
  NAO_CHECK(angle.size() == model_->jointCount());
  for (std::size_t i = 1; i < model_->bodies.size(); ++i) {
    const Body& body = model_->bodies[i];
    const double q = angle[model_->coordinates[i - 1].joint];
    X_TB_[i] = getPose(body.parent) * body.X_PB * Eigen::AngleAxisd(q, body.axis);
  }
}

Pose Kinematics::calcPose(const Effector& place) const { return getPose(place.body) * place.X_BF; }

Pose Kinematics::calcSole(Foot foot) const {
  NAO_CHECK(model_->feet.size() == 2);
  return calcPose(solePlace(model_->feet[index(foot)]));
}

Vec3 Kinematics::calcCom() const {
  Vec3 moment = Vec3::Zero();  // [kg m]
  for (std::size_t i = 0; i < model_->bodies.size(); ++i) {
    moment += model_->bodies[i].mass * (X_TB_[i] * model_->bodies[i].p_BoBcm);
  }
  return moment / total_mass_;
}

Pose Kinematics::calcRobotFrame() const {
  if (model_->feet.size() != 2) return Pose::Identity();
  const Pose X_TL = calcSole(Foot::Left);
  const Pose X_TR = calcSole(Foot::Right);
  const Eigen::Quaterniond left(X_TL.linear());
  const Eigen::Quaterniond right(X_TR.linear());
  Pose X_TRobot = translation(0.5 * (X_TL.translation() + X_TR.translation()));
  X_TRobot.linear() = left.slerp(0.5, right).toRotationMatrix();
  // A lifted foot does not lift the frame: move along its own vertical to the lower sole.
  const Vec3 up = X_TRobot.linear().col(2);
  const double half = 0.5 * std::abs(up.dot(X_TL.translation() - X_TR.translation()));
  X_TRobot.translation() -= half * up;
  return X_TRobot;
}

}  // namespace nao::motion
