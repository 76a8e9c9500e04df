#pragma once

#include <memory>

#include "core/robot_model.h"
#include "motion/gait.h"
#include "walk_engine/tuning.h"

namespace nao::walk {

/// A walk for a robot with a Nao's legs: Aldebaran's step rules, a centre of mass planned anew
/// every motion tick by a quadratic program that keeps the zero moment point inside the soles
/// (ZmpQp), and joint angles by inverse kinematics. Closed by the torso's attitude and the forces
/// under the feet: ankles and hips damp its rocking, each foot learns how far its sole is out of
/// level, and a landing moves to where it catches a fall.
///
/// Its first request finds the body in any standing pose: the legs move smoothly into the walking
/// pose where the feet stand, then the weight goes over and the first foot lifts. It ends with the
/// feet side by side and the body at rest in the walking pose.
/// Null if the legs are of another kind.
std::unique_ptr<motion::Gait> makeZmpGait(std::shared_ptr<const RobotModel> model,
                                          const Tuning& tuning = {});

}  // namespace nao::walk
