// Frictions of the catalogue by other laws: none of them has a budget that sticks exactly.
#include <cmath>

#include "tests/hidden/laws/laws.h"

namespace nao::hidden {
namespace {

// [rad/s] A joint at rest under load creeps at a part of this: a degree in three seconds, free
// choice between stiff and sticky.
constexpr double kCreep = 0.005;
constexpr double kSquare = 0.05;  // [s/rad] part of grease friction that grows with speed again
constexpr double kCounts = 3;     // [rad/s] where it is what its coefficient says: as motions go

}  // namespace

sim::EffectType smoothCoulomb() {
  return {"hidden_smooth_coulomb",
          "Dry friction without a kink: it creeps instead of sticking.",
          {{"torque", "N m", 0.05, 0, 0, 10, 0}},
          sim::Acts::OnDrive,
          [](const sim::EffectSetup& setup) {
            return driveLaw(setup, [torque = setup.value("torque")](const sim::DriveMoment& moment,
                                                                    std::size_t j, auto& terms) {
              terms.viscous[j] += smoothFriction(torque, moment.rate[j], kCreep);
            });
          }};
}

sim::EffectType viscousWithSquare() {
  return {"hidden_viscous_with_square",
          "Grease friction that grows a little faster than speed.",
          {{"coefficient", "N m s/rad", 0.05, 0, 0, 10, 0}},
          sim::Acts::OnDrive,
          [](const sim::EffectSetup& setup) {
            return driveLaw(setup, [c = setup.value("coefficient")](const sim::DriveMoment& moment,
                                                                    std::size_t j, auto& terms) {
              terms.viscous[j] +=
                  c * (1 + kSquare * std::abs(moment.rate[j])) / (1 + kSquare * kCounts);
            });
          }};
}

sim::EffectType lorentzStribeck() {
  return {"hidden_lorentz_stribeck",
          "Friction near standstill that fades with the square of speed.",
          {{"torque", "N m", 0.05, 0, 0, 10, 0}, {"speed", "rad/s", 0.1, 0.1, 1e-3, 10, 0}},
          sim::Acts::OnDrive,
          [](const sim::EffectSetup& setup) {
            return driveLaw(setup, [torque = setup.value("torque"), speed = setup.value("speed")](
                                       const sim::DriveMoment& moment, std::size_t j, auto& terms) {
              const double part = moment.rate[j] / speed;
              const double budget = torque / (1 + part * part);
              terms.resist_forward[j] += budget;
              terms.resist_backward[j] += budget;
            });
          }};
}

sim::EffectType motorLoadFriction() {
  return {"hidden_motor_load_friction",
          "Friction in proportion to what the motor gives, not to what the link takes.",
          {{"share", "", 0.1, 0, 0, 0.9, 0}},
          sim::Acts::OnDrive,
          [](const sim::EffectSetup& setup) {
            return driveLaw(setup, [share = setup.value("share")](const sim::DriveMoment& moment,
                                                                  std::size_t j, auto& terms) {
              const double budget = share * std::abs(moment.motor_torque[j]) / (1 + share);
              terms.resist_forward[j] += budget;
              terms.resist_backward[j] += budget;
            });
          }};
}

sim::EffectType smoothAsymmetry() {
  return {"hidden_smooth_asymmetry",
          "Friction in one direction of motion only, without a kink.",
          {{"torque", "N m", 0.05, 0, -10, 10, 0}},
          sim::Acts::OnDrive,
          [](const sim::EffectSetup& setup) {
            return driveLaw(setup, [torque = setup.value("torque")](const sim::DriveMoment& moment,
                                                                    std::size_t j, auto& terms) {
              if (moment.rate[j] * torque <= 0) return;
              terms.viscous[j] += smoothFriction(std::abs(torque), moment.rate[j], kCreep);
            });
          }};
}

}  // namespace nao::hidden
