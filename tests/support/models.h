#pragma once

#include <memory>

#include "core/robot_model.h"
#include "core/world_model.h"

namespace nao::test {

/// A fixed base with one hinge about y at the origin; a rod of `mass` at `length` along +x.
std::shared_ptr<RobotModel> pendulum(double mass, double length);

/// A free box without joints: `mass`, edges `size`, touching the ground with its lower corners.
std::shared_ptr<RobotModel> block(double mass, const Vec3& size);

/// robots/<name> of this source tree.
std::shared_ptr<const RobotModel> robot(const std::string& name);

/// A flat world with standard gravity and one ball far away.
std::shared_ptr<WorldModel> flatWorld();

}  // namespace nao::test
