#pragma once

#include <array>

#include "core/archive.h"
#include "core/robot_model.h"
#include "walk_engine/tuning.h"

namespace nao::walk {

/// Keeps the sway from growing. Each step throws the body over the carrying foot and back; thrown
/// too far it leans out over the sole's edge, the other foot lands late and hard, and the next
/// throw is stronger. So after each step on one foot the pressure of the next ones moves inward,
///   inset <- sway_memory inset + sway_gain max(0, lean - usual_lean),
/// which plans a smaller sway. `lean` is the furthest the torso leant out over the carrying foot.
class Sway {
 public:
  explicit Sway(const Tuning& tuning) : tuning_(tuning) {}

  /// One cycle. `roll` [rad]: of the torso, measured less planned; `stands` by Foot.
  void watch(double roll, std::array<bool, 2> stands);

  double inset() const { return inset_; }  // [m]

  void archive(Archive& archive);

 private:
  Tuning tuning_;
  double lean_ = 0;      // [rad] furthest of this step
  bool single_ = false;  // one foot carries
  double inset_ = 0;     // [m]
};

}  // namespace nao::walk
