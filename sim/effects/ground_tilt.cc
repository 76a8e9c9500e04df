// The ground is a slope for this robot: its normal is turned by x about the world's x axis, then by
// y about its y axis; the plane still goes through the world's origin. A robot with a fixed base is
// turned with it, about its root's origin. Of interest from 0.3 degree: zeros of 0.1 degree in hip,
// knee and ankle make a level ground look tilted by as much.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType groundTilt() {
  return {"ground_tilt",
          "The ground is not level.",
          {{"x", "rad", 0.02, 0, -0.6, 0.6, 0.0052}, {"y", "rad", 0, 0, -0.6, 0.6, 0.0052}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan([x = setup.value("x"), y = setup.value("y")](BodyPlan& plan) {
              const Eigen::AngleAxisd about_x(x, Vec3::UnitX());
              const Eigen::AngleAxisd about_y(y, Vec3::UnitY());
              plan.ground_normal = about_y * (about_x * plan.ground_normal);
              if (!plan.model.fixed_base) return;
              Pose& X_WB = plan.model.bodies[0].X_PB;
              X_WB.linear() = (about_y * about_x).toRotationMatrix() * X_WB.linear();
            });
          }};
}

}  // namespace nao::sim
