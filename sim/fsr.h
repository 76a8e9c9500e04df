#pragma once

#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "sim/ground_contact.h"

namespace nao::sim {

/// What the four force sensors under each foot feel of the ground's forces: a force inside their
/// rectangle is shared among them so that its centre of pressure stays; each ends at 25 N.
std::array<FootForces, 2> calcFootForces(const RobotModel& model,
                                         const std::vector<BodyMotion>& motion,
                                         const std::vector<GroundContact::Force>& forces);

/// Sum and centre of pressure of the four forces; `fsr` is where they are, in the ankle frame.
void addUp(const std::array<Vec3, 4>& fsr, FootForces& foot);

}  // namespace nao::sim
