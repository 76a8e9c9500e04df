#include <almath/tools/altransformhelpers.h>

#include <algorithm>
#include <array>
#include <cmath>

// Rigid motions as screws: Murray, Li, Sastry, "A Mathematical Introduction to Robotic
// Manipulation" (1994), chapter 2. In double, as the shares of small angles cancel.

namespace AL::Math {
namespace {

using Vector = std::array<double, 3>;

constexpr double kSmallAngle = 1e-4;  // [rad] below, series of two terms are exact to a double

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double lengthOf(const Vector& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

// v + by_one * (turn x v) + by_two * (turn x (turn x v)).
Vector blend(const Vector& v, const Vector& turn, double by_one, double by_two) {
  const Vector once = cross(turn, v);
  const Vector twice = cross(turn, once);
  Vector sum{};
  for (std::size_t i = 0; i < 3; ++i) sum[i] = v[i] + by_one * once[i] + by_two * twice[i];
  return sum;
}

// A turn's axis times its angle [rad], from its quaternion, which is taken of the largest of the
// four squares: right up to pi.
Vector rotationVector(const Rotation& r) {
  const double trace[] = {r.r1_c1, r.r2_c2, r.r3_c3};
  const Vector odd = {r.r3_c2 - r.r2_c3, r.r1_c3 - r.r3_c1, r.r2_c1 - r.r1_c2};
  double w = 1 + trace[0] + trace[1] + trace[2];
  Vector q = odd;
  const std::size_t i = std::max_element(trace, trace + 3) - trace;
  if (const double square = 1 + 2 * trace[i] - trace[0] - trace[1] - trace[2]; square > w) {
    const Vector even = {r.r3_c2 + r.r2_c3, r.r1_c3 + r.r3_c1, r.r2_c1 + r.r1_c2};
    w = odd[i];
    q[i] = square;
    q[(i + 1) % 3] = even[(i + 2) % 3];
    q[(i + 2) % 3] = even[(i + 1) % 3];
  }
  const double sine = lengthOf(q);
  if (sine == 0) return {};
  const double angle = 2 * std::atan2(sine, std::abs(w));
  const double factor = (w < 0 ? -angle : angle) / sine;
  return {q[0] * factor, q[1] * factor, q[2] * factor};
}

template <class SixNumbers>
SixNumbers sixNumbers(const Vector& move, const Vector& turn) {
  SixNumbers all;
  for (std::size_t i = 0; i < 3; ++i) {
    all.at(static_cast<int>(i)) = static_cast<float>(move[i]);
    all.at(static_cast<int>(i) + 3) = static_cast<float>(turn[i]);
  }
  return all;
}

}  // namespace

Velocity6D transformLogarithm(const Transform& t) {
  const Vector turn = rotationVector(rotationFromTransform(t));
  const double angle = lengthOf(turn);
  const double share =
      angle < kSmallAngle ? 1.0 / 12 : (1 - angle / 2 / std::tan(angle / 2)) / (angle * angle);
  const Vector move = blend({t.r1_c4, t.r2_c4, t.r3_c4}, turn, -0.5, share);
  return sixNumbers<Velocity6D>(move, turn);
}

Transform velocityExponential(const Velocity6D& v) {
  const Vector turn = {v.wxd, v.wyd, v.wzd};
  const double angle = lengthOf(turn);
  const bool is_small = angle < kSmallAngle;
  const double by_one =
      is_small ? 0.5 - angle * angle / 24 : (1 - std::cos(angle)) / (angle * angle);
  const double by_two = is_small ? 1.0 / 6 - angle * angle / 120
                                 : (angle - std::sin(angle)) / (angle * angle * angle);
  const Vector move = blend({v.xd, v.yd, v.zd}, turn, by_one, by_two);
  const double kNone = 1e-12;  // [rad] nothing in a float
  const Rotation turned =
      angle < kNone ? Rotation()
                    : Rotation::fromAngleDirection(static_cast<float>(angle), v.wxd, v.wyd, v.wzd);
  return transformFromRotationPosition3D(turned, static_cast<float>(move[0]),
                                         static_cast<float>(move[1]), static_cast<float>(move[2]));
}

Transform transformMean(const Transform& a, const Transform& b, const float& share) {
  return a * velocityExponential(transformLogarithm(a.diff(b)) * share);
}

Position6D position6DFromTransformDiff(const Transform& b, const Transform& c) {
  const Rotation turn = rotationFromTransform(c) * rotationFromTransform(b).transpose();
  return sixNumbers<Position6D>({c.r1_c4 - b.r1_c4, c.r2_c4 - b.r2_c4, c.r3_c4 - b.r3_c4},
                                rotationVector(turn));
}

float meanAngle(const std::vector<float>& angles) {
  return weightedMeanAngle(angles, std::vector<float>(angles.size(), 1));
}

float weightedMeanAngle(const std::vector<float>& angles, const std::vector<float>& weights) {
  if (angles.size() != weights.size()) {
    throw std::runtime_error("ALMath: expected as many weights as angles");
  }
  double x = 0, y = 0, all = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    x += weights[i] * std::cos(static_cast<double>(angles[i]));
    y += weights[i] * std::sin(static_cast<double>(angles[i]));
    all += std::abs(weights[i]);
  }
  const double kRounding = 1e-6;  // of angles that are floats
  if (!(std::hypot(x, y) > kRounding * all)) {
    throw std::runtime_error("ALMath: these angles have no mean");
  }
  return static_cast<float>(std::atan2(y, x));
}

}  // namespace AL::Math
