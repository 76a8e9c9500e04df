#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/memo.h"
#include "validation/diagnosis/grid.h"
#include "validation/diagnosis/joint_load.h"

namespace nao::validation {

class RigSet;

/// The loads of one joint in the motions of a set, for any list of effects: each from a quiet run
/// of the joint's limb alone, as nothing passes from limb to limb of a robot whose base is held.
/// Any thread.
class LimbLoads {
 public:
  /// `set` must outlive it. `step`: of the runs.
  LimbLoads(const RigSet& set, Joint joint, Duration step);

  /// `effects`: all that act on the robot, the model's own included.
  std::shared_ptr<const sim::JointLoad> get(std::size_t motion,
                                            const std::vector<EffectSetting>& effects) const;

  /// Names of the joints whose angles limit this one's.
  std::vector<std::string> others() const;

 private:
  sim::JointLoad calc(std::size_t motion, const std::vector<EffectSetting>& effects) const;
  std::vector<JointCommand> ordersOf(const GriddedMotion& motion,
                                     const MeasuredMotion& measured) const;
  MeasuredMotion measuredOf(std::size_t motion) const;
  std::vector<EffectSetting> ofLimb(const std::vector<EffectSetting>& effects) const;

  const RigSet& set_;
  RobotModel limb_;
  std::vector<Joint> whole_;        // of the limb's joints, what the whole robot calls them
  std::map<Joint, Joint> in_limb_;  // the other way
  Joint joint_;                     // of the limb
  LoadOptions options_;
  mutable Memo<sim::JointLoad> memo_;
};

}  // namespace nao::validation
