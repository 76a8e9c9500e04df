#include "sim/fsr.h"

#include <algorithm>
#include <cmath>

namespace nao::sim {
namespace {

constexpr double kRange = 25;      // [N] Aldebaran, FSR page
constexpr double kSilence = 0.05;  // [N] below this a foot reports no centre of pressure

// Where `x` lies between `from` (0) and `to` (1).
double part(double x, double from, double to) {
  return std::clamp((x - from) / (to - from), 0.0, 1.0);
}

void share(const std::array<Vec3, 4>& fsr, const Vec3& p, double force, FootForces& foot) {
  const double front = part(p.x(), (fsr[2].x() + fsr[3].x()) / 2, (fsr[0].x() + fsr[1].x()) / 2);
  const double left_front = part(p.y(), fsr[1].y(), fsr[0].y());
  const double left_rear = part(p.y(), fsr[3].y(), fsr[2].y());
  foot.force[0] += force * front * left_front;
  foot.force[1] += force * front * (1 - left_front);
  foot.force[2] += force * (1 - front) * left_rear;
  foot.force[3] += force * (1 - front) * (1 - left_rear);
}

}  // namespace

void addUp(const std::array<Vec3, 4>& fsr, FootForces& foot) {
  foot.total = foot.cop_x = foot.cop_y = 0;
  Vec3 moment = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    foot.total += foot.force[i];
    moment += foot.force[i] * fsr[i];
  }
  if (foot.total < kSilence) return;
  foot.cop_x = moment.x() / foot.total;
  foot.cop_y = moment.y() / foot.total;
}

std::array<FootForces, 2> calcFootForces(const RobotModel& model,
                                         const std::vector<BodyMotion>& motion,
                                         const std::vector<GroundContact::Force>& forces) {
  std::array<FootForces, 2> feet;
  for (const GroundContact::Force& force : forces) {
    if (force.foot < 0) continue;
    const FootModel& foot = model.feet[static_cast<std::size_t>(force.foot)];
    const Mat3& R_WB = motion[static_cast<std::size_t>(foot.body)].R_WB;
    share(foot.fsr, force.p_B, (R_WB.transpose() * force.f_W).z(),
          feet[static_cast<std::size_t>(force.foot)]);
  }
  for (std::size_t i = 0; i < model.feet.size(); ++i) {
    for (double& force : feet[i].force) force = std::clamp(force, 0.0, kRange);
    addUp(model.feet[i].fsr, feet[i]);
  }
  return feet;
}

}  // namespace nao::sim
