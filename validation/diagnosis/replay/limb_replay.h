#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/robot_io.h"
#include "validation/diagnosis/replay/whole_simulator.h"

namespace nao::validation {

/// Some limbs of a robot that hangs by its torso, alone: what a WholeSimulator predicts of their
/// joints. Nothing passes from limb to limb there but by a motor that both share, so that without
/// the others, without sensors and solids, a run by 0.25 ms takes two thirds of one by 1 ms. Limbs
/// that touch each other are not seen to. One object may be asked by several threads at once.
class LimbReplay {
 public:
  /// Of the limbs that hold these joints. `whole` must outlive it; its robot hangs.
  LimbReplay(const WholeSimulator& whole, const std::vector<Joint>& joints, Pace pace);

  /// As WholeSimulator::simulate(); angles of the limbs' joints alone, other signals none.
  WholeRun simulate(const std::vector<EffectSetting>& causes, std::size_t run, std::uint64_t stream,
                    const NoiseParts& noise) const;

 private:
  std::vector<JointCommand> ordersOf(const WholeRun& measured) const;

  const WholeSimulator& whole_;
  Pace pace_;
  std::vector<std::string> names_;  // of the joints asked for
  std::vector<Joint> kept_;         // by joint of the limbs, what the whole robot calls it
  std::vector<std::vector<JointCommand>> orders_;  // by run
};

}  // namespace nao::validation
