#pragma once

#include <vector>

#include "core/archive.h"
#include "core/frames.h"

namespace nao::sim {

/// What pushes against a robot's body: ground, obstacle, ball, another robot, or itself.
struct TouchForce {
  int robot = 0;
  int body = 0;
  Vec3 p_W = Vec3::Zero();  // [m]
  Vec3 f_W = Vec3::Zero();  // [N] on this body, mean over the step
};

/// All contacts of the last step, each side that is a robot's once. State: it is what sensors of
/// touch read after a snapshot is restored.
struct ContactReport {
  std::vector<TouchForce> forces;

  void archive(Archive& archive) {
    archive.each(forces, [&archive](TouchForce& force) {
      archive.value(force.robot);
      archive.value(force.body);
      archive.numbers(force.p_W);
      archive.numbers(force.f_W);
    });
  }
};

}  // namespace nao::sim
