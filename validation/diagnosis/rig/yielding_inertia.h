#pragma once

#include <Eigen/Core>

namespace nao::validation {

/// The part of a joint's inertia that neighbours never take away: its own link is not free. Free
/// choice.
inline constexpr double kLeastOfInertia = 0.2;

/// Neighbours give way to a joint's jolts, most of all inside the play of their gears: then what
/// they ask for, `torque` [N m], is in part proportional to the joint's own acceleration. A rig is
/// steadier if it knows that part as an inertia than as a torque at a given time, as its own jolts
/// come a little earlier or later. Moves it, window by window, from torque to inertia [kg m^2]; at
/// the acceleration [rad/s^2] of the run their sum stays what it was. Values are `dt` [s] apart.
void moveYieldToInertia(double dt, const Eigen::VectorXd& acceleration,
                        Eigen::Ref<Eigen::VectorXd> torque, Eigen::Ref<Eigen::VectorXd> inertia);

}  // namespace nao::validation
