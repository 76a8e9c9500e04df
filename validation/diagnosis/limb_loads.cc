#include "validation/diagnosis/limb_loads.h"

#include <sstream>

#include "core/check.h"
#include "sim/effects/coupled_stop.h"
#include "validation/diagnosis/rig_simulator.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

// Lists of effects, times motions, that are remembered: a load of 6 s takes 200 kB.
constexpr std::size_t kRemembered = 32;

std::string keyOf(std::size_t motion, const std::vector<EffectSetting>& effects) {
  std::ostringstream key;
  key.precision(17);
  key << motion;
  for (const EffectSetting& effect : effects) {
    key << '|' << effect.name;
    for (const auto& [name, value] : effect.parameters) key << ' ' << name << '=' << value;
    for (const Joint joint : effect.joints) key << ' ' << index(joint);
  }
  return key.str();
}

// The limb of a joint without the limbs that share motors with it, if those motors only hold.
RobotModel limbOf(const RigSet& set, Joint joint) {
  const RobotModel& model = set.model();
  const std::string& name = model.actuators[index(joint)].name;
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    if (model.actuators[j].coordinates.size() < 2) continue;
    for (std::size_t m = 0; m < set.motions().size(); ++m) {
      if (!set.measured(m).assumed[j]) return cutLimbs(model, {name});
    }
  }
  return cutLimbOf(model, name);
}

std::vector<Joint> limitersOf(const RobotModel& limb, Joint joint) {
  std::vector<Joint> others;
  for (const CoupledLimit& limit : limb.coupled_limits) {
    if (limit.limited == joint) others.push_back(limit.driver);
  }
  const auto coupled = sim::findCoupledTo(limb, joint);
  if (others.empty() && coupled) others.push_back(*coupled);
  return others;
}

}  // namespace

LimbLoads::LimbLoads(const RigSet& set, Joint joint, Duration step)
    : set_(set),
      limb_(limbOf(set, joint)),
      joint_(*limb_.findJoint(set.model().actuators[index(joint)].name)),
      memo_(kRemembered) {
  for (std::size_t j = 0; j < limb_.jointCount(); ++j) {
    whole_.push_back(*set.model().findJoint(limb_.actuators[j].name));
    in_limb_[whole_.back()] = toJoint(j);
  }
  options_ = {set.options().settle, step, set.perRow(), set.options().bandwidth,
              limitersOf(limb_, joint_)};
}

std::vector<std::string> LimbLoads::others() const {
  std::vector<std::string> names;
  for (const Joint other : options_.others) names.push_back(limb_.actuators[index(other)].name);
  return names;
}

std::shared_ptr<const sim::JointLoad> LimbLoads::get(
    std::size_t motion, const std::vector<EffectSetting>& effects) const {
  const std::vector<EffectSetting> own = ofLimb(effects);
  return memo_.get(keyOf(motion, own), [&] { return calc(motion, own); });
}

sim::JointLoad LimbLoads::calc(std::size_t motion,
                               const std::vector<EffectSetting>& effects) const {
  const GriddedMotion& played = set_.motions()[motion];
  const MeasuredMotion measured = measuredOf(motion);
  RobotModel limb = limb_;
  for (Actuator& actuator : limb.actuators) actuator.kp *= played.kp_scale;
  return calcJointLoad(limb, effects, ordersOf(played, measured), measured, joint_, options_,
                       set_.catalogue());
}

// Joints that were not told anything hold what they had.
std::vector<JointCommand> LimbLoads::ordersOf(const GriddedMotion& motion,
                                              const MeasuredMotion& measured) const {
  const GriddedMotion::Run& run = motion.runs.front();
  std::vector<JointCommand> orders(motion.rows, {JointArray<double>(limb_.jointCount()),
                                                 JointArray<double>(limb_.jointCount(), 1.0)});
  for (std::size_t j = 0; j < limb_.jointCount(); ++j) {
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

MeasuredMotion LimbLoads::measuredOf(std::size_t motion) const {
  const MeasuredMotion& all = set_.measured(motion);
  MeasuredMotion mine{all.dt, Eigen::MatrixXd(all.angle.rows(), whole_.size()), {}};
  for (std::size_t j = 0; j < whole_.size(); ++j) {
    mine.angle.col(static_cast<Eigen::Index>(j)) =
        all.angle.col(static_cast<Eigen::Index>(index(whole_[j])));
    mine.assumed.push_back(all.assumed[index(whole_[j])]);
  }
  return mine;
}

std::vector<EffectSetting> LimbLoads::ofLimb(const std::vector<EffectSetting>& effects) const {
  std::vector<EffectSetting> kept;
  for (EffectSetting effect : effects) {
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
