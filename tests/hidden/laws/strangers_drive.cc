// Torques and frictions that no entry of the catalogue stands for. `size` is always what grows.
#include <cmath>

#include "tests/hidden/laws/laws.h"

namespace nao::hidden {
namespace {

using sim::DriveMoment;
using sim::DriveTerms;
using sim::EffectSetup;

double timeOf(const DriveMoment& moment) { return toSeconds(moment.time) - kRestBefore; }

void resist(DriveTerms& terms, std::size_t j, double budget) {
  terms.resist_forward[j] += budget;
  terms.resist_backward[j] += budget;
}

sim::EffectType stranger(const char* name, const char* summary, const char* unit,
                         std::vector<sim::Parameter> shape,
                         std::function<DriveLaw(const EffectSetup&, double size)> law) {
  std::vector<sim::Parameter> parameters{{"size", unit, 0.05, 0, -50, 50, 0}};
  parameters.insert(parameters.end(), shape.begin(), shape.end());
  return {name, summary, parameters, sim::Acts::OnDrive,
          [law = std::move(law)](const EffectSetup& setup) {
            return driveLaw(setup, law(setup, setup.value("size")));
          }};
}

}  // namespace

sim::EffectType roughPatch() {
  return stranger("hidden_rough_patch", "Dry friction that waxes and wanes along the way.", "N m",
                  {{"per_radian", "1/rad", 4, 4, 0.1, 100, 0}},
                  [](const EffectSetup& setup, double size) -> DriveLaw {
                    return [size, n = setup.value("per_radian")](const DriveMoment& m,
                                                                 std::size_t j, DriveTerms& terms) {
                      resist(terms, j, size * (1 + std::sin(n * m.angle[j])));
                    };
                  });
}

sim::EffectType quadraticDrag() {
  return stranger("hidden_quadratic_drag", "Drag that grows with the square of speed.",
                  "N m s^2/rad^2", {}, [](const EffectSetup&, double size) -> DriveLaw {
                    return [size](const DriveMoment& m, std::size_t j, DriveTerms& terms) {
                      terms.viscous[j] += size * std::abs(m.rate[j]);
                    };
                  });
}

sim::EffectType periodicTorque() {
  return stranger("hidden_periodic_torque", "A torque that swings by the clock.", "N m",
                  {{"frequency", "Hz", 1.7, 1.7, 0.1, 20, 0}},
                  [](const EffectSetup& setup, double size) -> DriveLaw {
                    return [size, w = 2 * M_PI * setup.value("frequency")](
                               const DriveMoment& m, std::size_t j, DriveTerms& terms) {
                      terms.disturbance[j] += size * std::sin(w * timeOf(m));
                    };
                  });
}

sim::EffectType stickySpot() {
  return stranger("hidden_sticky_spot", "Dry friction around one angle.", "N m",
                  {{"angle", "rad", 0, 0, -3, 3, 0}, {"width", "rad", 0.1, 0.1, 0.01, 1, 0}},
                  [](const EffectSetup& setup, double size) -> DriveLaw {
                    return [size, q = setup.value("angle"), w = setup.value("width")](
                               const DriveMoment& m, std::size_t j, DriveTerms& terms) {
                      const double off = (m.angle[j] - q) / w;
                      resist(terms, j, size * std::exp(-off * off));
                    };
                  });
}

sim::EffectType detent() {
  return stranger("hidden_detent", "A notch that draws the joint to one angle when it is near.",
                  "N m",
                  {{"angle", "rad", 0, 0, -3, 3, 0}, {"width", "rad", 0.12, 0.12, 0.01, 1, 0}},
                  [](const EffectSetup& setup, double size) -> DriveLaw {
                    return [size, q = setup.value("angle"), w = setup.value("width")](
                               const DriveMoment& m, std::size_t j, DriveTerms& terms) {
                      const double off = (m.angle[j] - q) / w;
                      terms.disturbance[j] -= size * off * std::exp(0.5 - off * off / 2);
                    };
                  });
}

sim::EffectType torqueStep() {
  return stranger("hidden_torque_step", "A constant torque that begins in the middle of a run.",
                  "N m", {{"time", "s", 2.5, 2.5, 0, 60, 0}},
                  [](const EffectSetup& setup, double size) -> DriveLaw {
                    return [size, begin = setup.value("time")](const DriveMoment& m, std::size_t j,
                                                               DriveTerms& terms) {
                      if (timeOf(m) >= begin) terms.disturbance[j] += size;
                    };
                  });
}

sim::EffectType hardeningSpring() {
  return stranger("hidden_hardening_spring", "A skin that pulls back with the cube of the way.",
                  "N m/rad^3", {{"angle", "rad", 0, 0, -3, 3, 0}},
                  [](const EffectSetup& setup, double size) -> DriveLaw {
                    return [size, q = setup.value("angle")](const DriveMoment& m, std::size_t j,
                                                            DriveTerms& terms) {
                      const double way = m.angle[j] - q;
                      terms.disturbance[j] -= size * way * way * way;
                    };
                  });
}

sim::EffectType speedBand() {
  return stranger("hidden_speed_band", "A gear that rattles, and brakes, around one speed.", "N m",
                  {{"speed", "rad/s", 1, 1, 0.01, 10, 0}, {"width", "rad/s", 0.3, 0.3, 0.01, 5, 0}},
                  [](const EffectSetup& setup, double size) -> DriveLaw {
                    return [size, v = setup.value("speed"), w = setup.value("width")](
                               const DriveMoment& m, std::size_t j, DriveTerms& terms) {
                      const double off = (std::abs(m.rate[j]) - v) / w;
                      resist(terms, j, size * std::exp(-off * off));
                    };
                  });
}

sim::EffectType pulsingFriction() {
  return stranger("hidden_pulsing_friction", "A brake that drags for half a second in every two.",
                  "N m", {{"period", "s", 2, 2, 0.1, 60, 0}},
                  [](const EffectSetup& setup, double size) -> DriveLaw {
                    return [size, period = setup.value("period")](
                               const DriveMoment& m, std::size_t j, DriveTerms& terms) {
                      const double time = timeOf(m);
                      if (time - period * std::floor(time / period) < period / 4) {
                        resist(terms, j, size);
                      }
                    };
                  });
}

sim::EffectType hose() {
  return stranger("hidden_hose", "A hose that hangs on another joint and pulls as that one bends.",
                  "N m/rad", {{"other", "", 0, 0, 0, 47, 0}},
                  [](const EffectSetup& setup, double size) -> DriveLaw {
                    const auto other = static_cast<std::size_t>(setup.value("other"));
                    return [size, other](const DriveMoment& m, std::size_t j, DriveTerms& terms) {
                      terms.disturbance[j] -= size * m.angle[other];
                    };
                  });
}

}  // namespace nao::hidden
