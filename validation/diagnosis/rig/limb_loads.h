#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/memo.h"
#include "validation/diagnosis/rig/limb.h"

namespace nao::validation {

/// The loads of one joint in the motions of a set, for any list of effects: each from a run of the
/// joint's limb. Any thread.
class LimbLoads {
 public:
  /// `step` of the runs; loads have `per_row` values per row. `motions` are remembered for further
  /// loads along them.
  LimbLoads(std::shared_ptr<const Limb> limb, Duration step, int per_row, std::size_t motions = 0);

  /// `effects`: all that act on the robot, the model's own included; `moving`: those of them by
  /// which the limb moves, where the others do no more than weigh. In quick motions neighbours
  /// rattle in the play of their gears, and a change of 1e-6 N m makes another course of it: each
  /// `draw` is one, of neighbours disturbed roughly as `noise` says; 0: of a run without noise.
  std::shared_ptr<const sim::JointLoad> get(std::size_t motion,
                                            const std::vector<EffectSetting>& effects,
                                            const std::vector<EffectSetting>& moving,
                                            std::uint64_t draw, const JointNoise& noise) const;

  /// Names of the joints whose angles limit this one's.
  std::vector<std::string> others() const;

 private:
  std::shared_ptr<const LimbMotion> motionOf(std::size_t motion,
                                             const std::vector<EffectSetting>& effects,
                                             std::uint64_t draw) const;

  std::shared_ptr<const Limb> limb_;
  LoadOptions options_;
  mutable Memo<sim::JointLoad> loads_;
  mutable Memo<LimbMotion> motions_;
};

}  // namespace nao::validation
