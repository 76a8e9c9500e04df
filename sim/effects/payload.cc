// A point mass rides on a body at (x, y, z), in the body's axes: mass, centre of mass and inertia
// by Steiner. Which: the bodies directly on the named joints; the root if none is named.
#include "sim/effects/effect.h"

namespace nao::sim {

namespace {

// The inertia of the point mass `m` at `r` about the origin.
Mat3 pointInertia(double m, const Vec3& r) {
  return m * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
}

void load(Body& body, double mass, const Vec3& p_B) {
  const double total = body.mass + mass;
  if (mass <= 0 || total <= 0) return;
  const Vec3 com = (body.mass * body.p_BoBcm + mass * p_B) / total;
  body.I_Bcm += pointInertia(body.mass, body.p_BoBcm - com) + pointInertia(mass, p_B - com);
  body.p_BoBcm = com;
  body.mass = total;
}

}  // namespace

EffectType payload() {
  return {"payload",
          "A load is tied to a body.",
          {{"mass", "kg", 0.2, 0, 0, 50, 0.02},
           {"x", "m", 0, 0, -2, 2, 0.005},
           {"y", "m", 0, 0, -2, 2, 0.005},
           {"z", "m", 0, 0, -2, 2, 0.005}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan(
                [bodies = setup.named ? setup.bodies() : std::vector<std::size_t>{0},
                 mass = setup.value("mass"),
                 p_B = Vec3(setup.value("x"), setup.value("y"), setup.value("z"))](BodyPlan& plan) {
                  for (const std::size_t b : bodies) load(plan.model.bodies[b], mass, p_B);
                });
          }};
}

}  // namespace nao::sim
