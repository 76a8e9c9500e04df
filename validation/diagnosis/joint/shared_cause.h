#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/diagnosis/joint/joint_crowd.h"

namespace nao::validation {

/// What explains about as much.
struct SharedRival {
  std::size_t cause = 0;
  double x = 0;
  std::string place;  // a joint, of whose link it is; empty: of all joints
};

/// A cause with one number for all joints.
struct SharedCause {
  std::size_t cause = 0;
  double x = 0;
  double low = 0, high = 0;  // 90 % interval of it; equal: none
  double gain = 0;           // [nats] of all joints
  int joints = 0;            // that gain more than the threshold
  std::vector<SharedRival> rivals;
};

/// The cause of Scope::Robot that explains, with one number, about as much as each joint's own
/// best cause does for itself; none if no two joints need one.
std::optional<SharedCause> findShared(JointCrowd& joints, double critical);

}  // namespace nao::validation
