#pragma once

#include <optional>

#include "validation/diagnosis/joint/joint_crowd.h"

namespace nao::validation {

/// What is wrong with one joint's link, as that joint and all that carry it feel it.
struct SharedLink {
  std::size_t joint = 0, cause = 0;
  std::vector<double> x;  // of the cause's numbers
  double gain = 0;        // [nats] of all joints
};

/// The link whose weight best explains what is off at its joint and at those that carry it, if no
/// other joint is off by more than chance: to these it is what another gravity would be.
std::optional<SharedLink> findLink(JointCrowd& joints, double critical);

}  // namespace nao::validation
