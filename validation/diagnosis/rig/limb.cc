#include "validation/diagnosis/rig/limb.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "validation/diagnosis/ensemble/noise_fit.h"
#include "validation/diagnosis/rig/rig_simulator.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

// Times nominal, that a robot's neighbours are shaken at most: a joint that scatters by more
// sticks, slips or has play of its own.
constexpr double kShaken = 4;

// Where all joints are when the first motion begins.
JointArray<double> firstPose(const RigSet& set) {
  JointArray<double> pose(set.model().jointCount());
  for (std::size_t j = 0; j < set.model().jointCount(); ++j) {
    pose[j] = set.measured(0).angle(0, static_cast<Eigen::Index>(j));
  }
  return pose;
}

// The limb of a joint; limbs that share motors with it are stiff if those motors only hold.
RobotModel limbOf(const RigSet& set, Joint joint) {
  const RobotModel& model = set.model();
  const std::string& name = model.actuators[index(joint)].name;
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    if (model.actuators[j].coordinates.size() < 2) continue;
    for (std::size_t m = 0; m < set.motions().size(); ++m) {
      if (!set.measured(m).assumed[j]) return cutLimbs(model, {name});
    }
  }
  return cutLimbOf(model, name, firstPose(set));
}

}  // namespace

int inertiaEvery(Duration step) {
  constexpr Duration kInertiaStep = std::chrono::milliseconds(1);
  return step < kInertiaStep ? static_cast<int>(kInertiaStep / step) : 2;
}

std::string keyOf(std::size_t motion, const std::vector<EffectSetting>& effects) {
  return std::to_string(motion) + keyOf(effects);
}

std::string keyOf(const std::vector<EffectSetting>& effects) {
  std::ostringstream key;
  key.precision(17);
  for (const EffectSetting& effect : effects) {
    key << '|' << effect.name;
    for (const auto& [name, value] : effect.parameters) key << ' ' << name << '=' << value;
    for (const Joint joint : effect.joints) key << ' ' << index(joint);
  }
  return key.str();
}

Limb::Limb(const RigSet& set, Joint joint_of_robot)
    : set_(set),
      model_(limbOf(set, joint_of_robot)),
      joint_(*model_.findJoint(set.model().actuators[index(joint_of_robot)].name)) {
  for (std::size_t j = 0; j < model_.jointCount(); ++j) {
    whole_.push_back(*set.model().findJoint(model_.actuators[j].name));
    in_limb_[whole_.back()] = toJoint(j);
  }
}

std::vector<Joint> Limb::carried() const {
  std::vector<bool> hangs(model_.bodies.size(), false);
  std::vector<Joint> found;
  for (std::size_t b = 1; b < model_.bodies.size(); ++b) {  // parents come before their children
    const Joint own = model_.coordinates[b - 1].joint;
    const bool carried = hangs[static_cast<std::size_t>(model_.bodies[b].parent)];
    hangs[b] = carried || own == joint_;
    if (carried && own != joint_) found.push_back(whole_[index(own)]);
  }
  return found;
}

double Limb::linkInertia() const {
  std::vector<Vec3> axes(model_.bodies.size(), Vec3::Zero());  // of the joint, in what it turns
  double squares = 0;
  for (std::size_t b = 1; b < model_.bodies.size(); ++b) {
    const Body& body = model_.bodies[b];
    const bool own = model_.coordinates[b - 1].joint == joint_;
    const Vec3& before = axes[static_cast<std::size_t>(body.parent)];
    axes[b] = own ? body.axis : Vec3(body.X_PB.linear().transpose() * before);
    const double inertia = axes[b].dot(body.I_Bcm * axes[b]);
    squares += inertia * inertia;
  }
  const double rotor = model_.actuators[index(joint_)].rotor_inertia;
  return rotor > 0 ? std::sqrt(squares) / rotor : 0;
}

RobotModel Limb::modelIn(std::size_t motion) const {
  RobotModel model = model_;
  for (Actuator& actuator : model.actuators) actuator.kp *= set_.motions()[motion].kp_scale;
  return model;
}

// Joints that were not told anything hold what they had.
std::vector<JointCommand> Limb::orders(std::size_t m) const {
  const GriddedMotion& motion = set_.motions()[m];
  const MeasuredMotion measured = this->measured(m);
  const GriddedMotion::Run& run = motion.runs.front();
  std::vector<JointCommand> orders(motion.rows, {JointArray<double>(model_.jointCount()),
                                                 JointArray<double>(model_.jointCount(), 1.0)});
  for (std::size_t j = 0; j < model_.jointCount(); ++j) {
    const auto command = run.command.find(whole_[j]);
    const auto stiffness = run.stiffness.find(whole_[j]);
    for (std::size_t k = 0; k < motion.rows; ++k) {
      orders[k].angle[j] = command != run.command.end()
                               ? command->second[k]
                               : measured.angle(0, static_cast<Eigen::Index>(j));
      if (stiffness != run.stiffness.end()) orders[k].stiffness[j] = stiffness->second[k];
    }
  }
  return orders;
}

MeasuredMotion Limb::measured(std::size_t motion) const {
  const MeasuredMotion& all = set_.measured(motion);
  MeasuredMotion mine{all.dt, Eigen::MatrixXd(all.angle.rows(), whole_.size()), {}};
  for (std::size_t j = 0; j < whole_.size(); ++j) {
    mine.angle.col(static_cast<Eigen::Index>(j)) =
        all.angle.col(static_cast<Eigen::Index>(index(whole_[j])));
    mine.assumed.push_back(all.assumed[index(whole_[j])]);
  }
  return mine;
}

std::vector<EffectSetting> Limb::disturbances(const JointNoise& noise) const {
  const double nominal = nominalNoise(model_, joint_).torque_sd;
  const double times = nominal > 0 ? std::min(noise.torque_sd / nominal, kShaken) : 1;
  std::vector<EffectSetting> all;
  for (std::size_t j = 0; j < model_.jointCount(); ++j) {
    JointNoise one = nominalNoise(model_, toJoint(j));
    one.torque_sd *= times;
    if (toJoint(j) == joint_) one = noise;
    EffectSetting setting{"process_noise", {{"sd", one.torque_sd}}, {toJoint(j)}, ""};
    if (one.torque_time > 0) setting.parameters["time"] = one.torque_time;
    all.push_back(std::move(setting));
  }
  return all;
}

std::vector<EffectSetting> Limb::effects(const std::vector<EffectSetting>& on_robot) const {
  std::vector<EffectSetting> kept;
  for (EffectSetting effect : on_robot) {
    const bool all = effect.joints.empty();
    std::vector<Joint> joints;
    for (const Joint joint : effect.joints) {
      const auto at = in_limb_.find(joint);
      if (at != in_limb_.end()) joints.push_back(at->second);
    }
    effect.joints = std::move(joints);
    if (all || !effect.joints.empty()) kept.push_back(std::move(effect));
  }
  return kept;
}

}  // namespace nao::validation
