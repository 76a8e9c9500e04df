#pragma once

#include "core/frames.h"

namespace nao::sim {

/// A force on a robot's body.
struct ExternalForce {
  int body = 0;
  Vec3 p_W = Vec3::Zero();  // [m] where it acts
  Vec3 f_W = Vec3::Zero();  // [N]
};

}  // namespace nao::sim
