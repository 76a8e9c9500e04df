#include "tests/support/shape_gap.h"

#include <algorithm>

namespace nao::test {
namespace {

constexpr double kTolerance = 1e-4;  // [m]
constexpr int kRounds = 5000;

double radiusOf(const Shape& shape) {
  const bool round = shape.kind == Shape::Kind::Sphere || shape.kind == Shape::Kind::Capsule;
  return round ? shape.size.x() : 0;
}

// The point of the solid, without its radius, that is farthest in direction `d`.
Vec3 farthest(const Shape& shape, const Pose& X_WS, const Vec3& d_W) {
  const Vec3 d = X_WS.linear().transpose() * d_W;
  const double half = (d.z() < 0 ? -0.5 : 0.5) * shape.size.z();
  Vec3 p = Vec3::Zero();
  if (shape.kind == Shape::Kind::Box) {
    p = 0.5 * shape.size.cwiseProduct(d.unaryExpr([](double x) { return x < 0 ? -1.0 : 1.0; }));
  } else if (shape.kind == Shape::Kind::Capsule) {
    p.z() = half;
  } else if (shape.kind == Shape::Kind::Cylinder) {
    const double flat = d.head<2>().norm();
    if (flat > 0) p.head<2>() = shape.size.x() / flat * d.head<2>();
    p.z() = half;
  }
  return X_WS * p;
}

}  // namespace

// Frank and Wolfe's way to the point of the set A - B that is nearest to the origin: walk towards
// the farthest point against the present one; how much is left is known at every step.
double shapeGap(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  const Pose X_WSa = X_WA * a.X_BS;
  const Pose X_WSb = X_WB * b.X_BS;
  const double radii = radiusOf(a) + radiusOf(b);
  Vec3 v = X_WSa.translation() - X_WSb.translation();
  double apart = 0;  // certainly
  for (int i = 0; i < kRounds && v.norm() > kTolerance; ++i) {
    const Vec3 s = farthest(a, X_WSa, -v) - farthest(b, X_WSb, v);
    apart = std::max(apart, v.dot(s) / v.norm());
    if (v.norm() - apart < kTolerance) break;
    const Vec3 way = s - v;
    v += std::clamp(-v.dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
  }
  return apart - radii;
}

std::vector<Pose> bodyPoses(const RobotModel& model, const JointArray<double>& angle) {
  std::vector<Pose> X_RB{Pose::Identity()};
  for (std::size_t i = 1; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    X_RB.push_back(X_RB[static_cast<std::size_t>(body.parent)] * body.X_PB *
                   Eigen::AngleAxisd(angle[model.coordinates[i - 1].joint], body.axis));
  }
  return X_RB;
}

double bodyGap(const RobotModel& model, const std::vector<Pose>& X_RB, int a, int b) {
  double gap = 1;
  const auto i = static_cast<std::size_t>(a);
  const auto j = static_cast<std::size_t>(b);
  for (const Shape& s : model.bodies[i].collisions) {
    for (const Shape& t : model.bodies[j].collisions) {
      gap = std::min(gap, shapeGap(s, X_RB[i], t, X_RB[j]));
    }
  }
  return gap;
}

}  // namespace nao::test
