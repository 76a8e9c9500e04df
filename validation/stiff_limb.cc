#include "validation/stiff_limb.h"

#include <map>

#include <Eigen/Geometry>

namespace nao::validation {
namespace {

// Of a mass at `p` from where it is asked.
Mat3 inertiaOfPoint(double mass, const Vec3& p) {
  return mass * (p.squaredNorm() * Mat3::Identity() - p * p.transpose());
}

// The bodies that hang on `root`, itself too, each where it is in `root`.
std::map<int, Pose> posesIn(const RobotModel& model, std::size_t root,
                            const JointArray<double>& pose) {
  std::map<int, Pose> poses{{static_cast<int>(root), Pose::Identity()}};
  for (std::size_t b = root + 1; b < model.bodies.size(); ++b) {  // parents come first
    const Body& body = model.bodies[b];
    const auto parent = poses.find(body.parent);
    if (parent == poses.end()) continue;
    const double angle = pose[model.coordinates[b - 1].joint];
    poses[static_cast<int>(b)] = parent->second * body.X_PB * Eigen::AngleAxisd(angle, body.axis);
  }
  return poses;
}

}  // namespace

Body stiffened(const RobotModel& model, std::size_t b, const JointArray<double>& pose) {
  Body solid = model.bodies[b];
  solid.visuals.clear();
  solid.collisions.clear();
  solid.mass = 0;
  Vec3 moment = Vec3::Zero();
  Mat3 about_origin = Mat3::Zero();
  for (const auto& [at, X_BP] : posesIn(model, b, pose)) {
    const Body& part = model.bodies[static_cast<std::size_t>(at)];
    const Vec3 centre = X_BP * part.p_BoBcm;
    const Mat3 R = X_BP.linear();
    solid.mass += part.mass;
    moment += part.mass * centre;
    about_origin += R * part.I_Bcm * R.transpose() + inertiaOfPoint(part.mass, centre);
  }
  if (solid.mass > 0) solid.p_BoBcm = moment / solid.mass;
  solid.I_Bcm = about_origin - inertiaOfPoint(solid.mass, solid.p_BoBcm);
  return solid;
}

}  // namespace nao::validation
