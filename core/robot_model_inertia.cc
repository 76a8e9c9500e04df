#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/check.h"
#include "core/config_node.h"
#include "core/robot_model_parts.h"

// Principal moments a <= b <= c of a solid obey a + b >= c: no mass distribution does otherwise.
// Many published robots break it, mostly by rounding or by a slip of the drawing program.

namespace nao {
namespace {

constexpr double kRounding = 1e-6;  // of c: published tensors have six digits or more

// By how much c is too large, or zero.
double excessOf(const Vec3& moments) {
  return std::max(0.0, moments.z() * (1 - kRounding) - moments.x() - moments.y());
}

}  // namespace

std::string flawOf(const Body& body) {
  if (!(body.mass > 0)) return "a body that moves needs an <inertial> with a mass above 0";
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(body.I_Bcm).eigenvalues();
  if (!(moments.x() > 0)) return "its inertia is not positive definite";
  if (excessOf(moments) > 0) {
    return "its inertia breaks the triangle inequality, no solid has it "
           "(`repair_inertia: true` in body.yaml takes the nearest that one can have)";
  }
  return {};
}

Mat3 nearestSolid(const Mat3& inertia) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia);
  Vec3 moments = solver.eigenvalues();
  if (excessOf(moments) == 0) return inertia;
  const double share = (moments.z() - moments.x() - moments.y()) / 3;  // least squares
  moments += Vec3(share, share, -share);
  return solver.eigenvectors() * moments.asDiagonal() * solver.eigenvectors().transpose();
}

void checkBodies(const UrdfRobot& urdf, const RobotModel& model) {
  for (std::size_t i = model.fixed_base ? 1 : 0; i < model.bodies.size(); ++i) {
    const std::string flaw = flawOf(model.bodies[i]);
    if (flaw.empty()) continue;
    throw InputError(
        complaint(urdf.file, urdf.body_lines[i], "link '" + model.bodies[i].name + "': " + flaw));
  }
}

}  // namespace nao
