#pragma once

#include <vector>

#include <almath/types/alvectorspace.h>

namespace AL {
namespace Math {

/// A place [m] and heading [rad] in the plane. a * b: b as seen from a.
struct Pose2D : detail::VectorSpace<Pose2D, 3> {
  float x;
  float y;
  float theta;

  Pose2D() : x(0), y(0), theta(0) {}
  explicit Pose2D(float all) : x(all), y(all), theta(all) {}
  Pose2D(float its_x, float its_y, float its_theta) : x(its_x), y(its_y), theta(its_theta) {}
  /// @throws std::runtime_error unless there are 3 numbers.
  explicit Pose2D(const std::vector<float>& numbers) { read(numbers); }

  static Pose2D fromPolarCoordinates(float radius, float angle) {
    return Pose2D(radius * std::cos(angle), radius * std::sin(angle), angle);
  }
  using detail::VectorSpace<Pose2D, 3>::operator*;
  using detail::VectorSpace<Pose2D, 3>::operator*=;
  Pose2D operator*(const Pose2D& other) const {
    const float c = std::cos(theta);
    const float s = std::sin(theta);
    return Pose2D(x + c * other.x - s * other.y, y + s * other.x + c * other.y,
                  theta + other.theta);
  }
  Pose2D& operator*=(const Pose2D& other) { return *this = *this * other; }
  /// a.diff(b) is b as seen from a.
  Pose2D diff(const Pose2D& other) const { return inverse() * other; }
  Pose2D inverse() const {
    const float c = std::cos(theta);
    const float s = std::sin(theta);
    return Pose2D(-c * x - s * y, s * x - c * y, -theta);
  }
  float distanceSquared(const Pose2D& other) const {
    return (x - other.x) * (x - other.x) + (y - other.y) * (y - other.y);
  }
  float distance(const Pose2D& other) const { return std::sqrt(distanceSquared(other)); }
  /// Where the place lies from the origin [rad].
  float getAngle() const { return std::atan2(y, x); }
  /// The place's distance from the origin [m]; theta counts for nothing.
  float norm() const { return std::sqrt(x * x + y * y); }
  /// All three numbers divided by norm(). @throws std::runtime_error at the origin.
  Pose2D normalize() const { return *this / norm(); }

  static float Pose2D::*field(int i) {
    static float Pose2D::*const kFields[] = {&Pose2D::x, &Pose2D::y, &Pose2D::theta};
    return kFields[i];
  }
};

inline Pose2D pose2DInverse(const Pose2D& pose) { return pose.inverse(); }
inline void pose2DInverse(const Pose2D& pose, Pose2D& inverse) { inverse = pose.inverse(); }
inline void pose2dInvertInPlace(Pose2D& pose) { pose = pose.inverse(); }
inline Pose2D pinv(const Pose2D& pose) { return pose.inverse(); }
/// `b` as seen from `a`.
inline Pose2D pose2dDiff(const Pose2D& a, const Pose2D& b) { return a.diff(b); }
inline float distance(const Pose2D& a, const Pose2D& b) { return a.distance(b); }
inline float distanceSquared(const Pose2D& a, const Pose2D& b) { return a.distanceSquared(b); }

}  // namespace Math
}  // namespace AL
