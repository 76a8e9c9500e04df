#include "validation/diagnosis/rig/limb_loads.h"

#include <cmath>

#include "sim/effects/coupled_stop.h"
#include "validation/diagnosis/rig/rig_simulator.h"

namespace nao::validation {
namespace {

// Lists of effects, times motions, that are remembered: a load of 6 s takes 200 kB.
constexpr std::size_t kRemembered = 48;
constexpr double kRoughly = 4;  // steps per octave, of how much neighbours are disturbed

std::vector<Joint> limitersOf(const RobotModel& limb, Joint joint) {
  std::vector<Joint> others;
  for (const CoupledLimit& limit : limb.coupled_limits) {
    if (limit.limited == joint) others.push_back(limit.driver);
  }
  const auto coupled = sim::findCoupledTo(limb, joint);
  if (others.empty() && coupled) others.push_back(*coupled);
  return others;
}

// Noise is fitted by trials of many sizes, each of which would have all loads calculated anew. That
// neighbours are shaken by up to 9 % more or less is nothing beside the joint's own noise.
JointNoise roughly(JointNoise noise) {
  if (noise.torque_sd <= 0) return noise;
  noise.torque_sd = std::exp2(std::round(kRoughly * std::log2(noise.torque_sd)) / kRoughly);
  noise.torque_time = 0;  // the joint's own: neighbours have what their robot's file says
  return noise;
}

}  // namespace

LimbLoads::LimbLoads(std::shared_ptr<const Limb> limb, Duration step, int per_row,
                     std::size_t motions)
    : limb_(std::move(limb)),
      options_{limb_->set().options().settle,
               step,
               per_row,
               limb_->set().options().bandwidth,
               1,
               limitersOf(limb_->model(), limb_->joint()),
               inertiaEvery(step)},
      loads_(kRemembered),
      motions_(motions) {}

std::vector<std::string> LimbLoads::others() const {
  std::vector<std::string> names;
  for (const Joint other : options_.others) {
    names.push_back(limb_->model().actuators[index(other)].name);
  }
  return names;
}

std::shared_ptr<const sim::JointLoad> LimbLoads::get(std::size_t motion,
                                                     const std::vector<EffectSetting>& effects,
                                                     const std::vector<EffectSetting>& moving,
                                                     std::uint64_t draw,
                                                     const JointNoise& noise) const {
  std::vector<EffectSetting> shaken;
  if (draw > 0) {
    shaken = limb_->disturbances(roughly(noise));
    for (EffectSetting& one : shaken) {  // the joint's own noise is the rig's
      if (one.joints.front() == limb_->joint()) one.parameters["sd"] = 0;
    }
  }
  std::vector<EffectSetting> all = limb_->effects(effects);
  const std::vector<EffectSetting> moved = limb_->effects(moving);
  shaken.insert(shaken.end(), moved.begin(), moved.end());
  const std::string key = std::to_string(draw) + '/' + keyOf(motion, shaken) + '/' + keyOf(all);
  return loads_.get(key, [&] {
    return loadAlong(*motionOf(motion, shaken, draw), limb_->modelIn(motion), all, limb_->joint(),
                     options_, limb_->set().catalogue());
  });
}

std::shared_ptr<const LimbMotion> LimbLoads::motionOf(std::size_t motion,
                                                      const std::vector<EffectSetting>& effects,
                                                      std::uint64_t draw) const {
  return motions_.get(std::to_string(draw) + '/' + keyOf(motion, effects), [&] {
    LoadOptions options = options_;
    options.seed = 1 + draw;
    return calcLimbMotion(limb_->modelIn(motion), effects, limb_->orders(motion),
                          limb_->measured(motion), options, limb_->set().catalogue());
  });
}

}  // namespace nao::validation
