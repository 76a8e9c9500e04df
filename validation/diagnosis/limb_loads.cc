#include "validation/diagnosis/limb_loads.h"

#include "sim/effects/coupled_stop.h"
#include "validation/diagnosis/rig_simulator.h"

namespace nao::validation {
namespace {

// Lists of effects, times motions, that are remembered: a load of 6 s takes 200 kB.
constexpr std::size_t kRemembered = 48;

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

LimbLoads::LimbLoads(std::shared_ptr<const Limb> limb, Duration step, int per_row)
    : limb_(std::move(limb)),
      options_{limb_->set().options().settle,
               step,
               per_row,
               limb_->set().options().bandwidth,
               1,
               limitersOf(limb_->model(), limb_->joint()),
               inertiaEvery(step)},
      memo_(kRemembered) {}

std::vector<std::string> LimbLoads::others() const {
  std::vector<std::string> names;
  for (const Joint other : options_.others) {
    names.push_back(limb_->model().actuators[index(other)].name);
  }
  return names;
}

std::shared_ptr<const sim::JointLoad> LimbLoads::get(std::size_t motion,
                                                     const std::vector<EffectSetting>& effects,
                                                     std::uint64_t draw,
                                                     const JointNoise& noise) const {
  std::vector<EffectSetting> all;
  if (draw > 0) {
    all = limb_->disturbances(noise);
    for (EffectSetting& one : all) {  // the joint's own noise is the rig's
      if (one.joints.front() == limb_->joint()) one.parameters["sd"] = 0;
    }
  }
  const std::vector<EffectSetting> own = limb_->effects(effects);
  all.insert(all.end(), own.begin(), own.end());
  return memo_.get(std::to_string(draw) + '/' + keyOf(motion, all), [&] {
    LoadOptions options = options_;
    options.seed = 1 + draw;
    return calcJointLoad(limb_->modelIn(motion), all, limb_->orders(motion),
                         limb_->measured(motion), limb_->joint(), options,
                         limb_->set().catalogue());
  });
}

}  // namespace nao::validation
