#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <almath/types/alposition3d.h>
#include <almath/types/alposition6d.h>
#include <almath/types/alrotation.h>

namespace AL {
namespace Math {

/// A turn and a shift in space: the upper three rows of a 4x4 matrix. a * b: first b, then a.
struct Transform {
  float r1_c1, r1_c2, r1_c3, r1_c4;
  float r2_c1, r2_c2, r2_c3, r2_c4;
  float r3_c1, r3_c2, r3_c3, r3_c4;

  /// The identity.
  Transform()
      : r1_c1(1),
        r1_c2(0),
        r1_c3(0),
        r1_c4(0),
        r2_c1(0),
        r2_c2(1),
        r2_c3(0),
        r2_c4(0),
        r3_c1(0),
        r3_c2(0),
        r3_c3(1),
        r3_c4(0) {}
  /// A shift alone.
  Transform(float x, float y, float z) : Transform() {
    r1_c4 = x;
    r2_c4 = y;
    r3_c4 = z;
  }
  /// Row by row, 12 numbers, or 16 with the last row. @throws std::runtime_error
  explicit Transform(const std::vector<float>& numbers) {
    if (numbers.size() != 12 && numbers.size() != 16) {
      throw std::runtime_error("ALMath: expected 12 or 16 numbers for a Transform, found " +
                               std::to_string(numbers.size()));
    }
    for (int i = 0; i < 12; ++i) at(i) = numbers[static_cast<std::size_t>(i)];
  }

  float at(int i) const { return this->*field(i); }
  float& at(int i) { return this->*field(i); }
  float at(int row, int column) const { return at(4 * row + column); }
  float& at(int row, int column) { return at(4 * row + column); }

  Transform operator*(const Transform& other) const {
    Transform product;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        float sum = column == 3 ? at(row, 3) : 0;
        for (int k = 0; k < 3; ++k) sum += at(row, k) * other.at(k, column);
        product.at(row, column) = sum;
      }
    }
    return product;
  }
  Transform& operator*=(const Transform& other) { return *this = *this * other; }
  Position3D operator*(const Position3D& p) const {
    return Position3D(r1_c1 * p.x + r1_c2 * p.y + r1_c3 * p.z + r1_c4,
                      r2_c1 * p.x + r2_c2 * p.y + r2_c3 * p.z + r2_c4,
                      r3_c1 * p.x + r3_c2 * p.y + r3_c3 * p.z + r3_c4);
  }
  bool operator==(const Transform& other) const { return isNear(other, 0); }
  bool operator!=(const Transform& other) const { return !(*this == other); }
  bool isNear(const Transform& other, float epsilon = 0.0001f) const {
    for (int i = 0; i < 12; ++i) {
      if (!(std::fabs(at(i) - other.at(i)) <= epsilon)) return false;
    }
    return true;
  }

  Transform inverse() const {
    Transform result;
    for (int row = 0; row < 3; ++row) {
      float shift = 0;
      for (int column = 0; column < 3; ++column) {
        result.at(row, column) = at(column, row);
        shift -= at(column, row) * at(column, 3);
      }
      result.at(row, 3) = shift;
    }
    return result;
  }
  /// What brings this to the other: this.diff(other) is inverse() * other.
  Transform diff(const Transform& other) const { return inverse() * other; }
  /// Of the shift [m].
  float norm() const { return Position3D(r1_c4, r2_c4, r3_c4).norm(); }
  /// Of the turn.
  float determinant() const { return rotation().determinant(); }
  /// Whether its turn is one, within `epsilon`.
  bool isTransform(float epsilon = 0.0001f) const { return rotation().isRotation(epsilon); }
  /// Makes its turn exactly one again: see Rotation::normalizeRotation().
  void normalizeTransform() {
    Rotation turn = rotation();
    turn.normalizeRotation();
    for (int i = 0; i < 9; ++i) at(i / 3, i % 3) = turn.at(i);
  }
  /// Between the origins [m^2].
  float distanceSquared(const Transform& other) const {
    return Position3D(r1_c4, r2_c4, r3_c4)
        .distanceSquared(Position3D(other.r1_c4, other.r2_c4, other.r3_c4));
  }
  float distance(const Transform& other) const { return std::sqrt(distanceSquared(other)); }

  /// Sixteen numbers, row by row, the last row 0 0 0 1: as ALMotion takes and returns them.
  std::vector<float> toVector() const {
    std::vector<float> all;
    for (int i = 0; i < 12; ++i) all.push_back(at(i));
    const float last[] = {0, 0, 0, 1};
    all.insert(all.end(), last, last + 4);
    return all;
  }
  void toVector(std::vector<float>& all) const { all = toVector(); }
  /// From `to` on, where there is room for them; `to` is moved behind them.
  void writeToVector(std::vector<float>::iterator& to) const {
    const std::vector<float> all = toVector();
    to = std::copy(all.begin(), all.end(), to);
  }

  static Transform fromRotX(float angle) { return turn(1, 2, angle); }
  static Transform fromRotY(float angle) { return turn(2, 0, angle); }
  static Transform fromRotZ(float angle) { return turn(0, 1, angle); }
  /// Turned about the fixed axes x, then y, then z.
  static Transform from3DRotation(float wx, float wy, float wz) {
    return fromRotZ(wz) * fromRotY(wy) * fromRotX(wx);
  }
  static Transform fromPosition(float x, float y, float z) { return Transform(x, y, z); }
  static Transform fromPosition(float x, float y, float z, float wx, float wy, float wz) {
    return Transform(x, y, z) * from3DRotation(wx, wy, wz);
  }

  static float Transform::*field(int i) {
    static float Transform::*const kFields[] = {
        &Transform::r1_c1, &Transform::r1_c2, &Transform::r1_c3, &Transform::r1_c4,
        &Transform::r2_c1, &Transform::r2_c2, &Transform::r2_c3, &Transform::r2_c4,
        &Transform::r3_c1, &Transform::r3_c2, &Transform::r3_c3, &Transform::r3_c4};
    return kFields[i];
  }

 private:
  Rotation rotation() const {
    Rotation turn;
    for (int i = 0; i < 9; ++i) turn.at(i) = at(i / 3, i % 3);
    return turn;
  }
  // From axis `a` towards axis `b`.
  static Transform turn(int a, int b, float angle) {
    Transform result;
    result.at(a, a) = result.at(b, b) = std::cos(angle);
    result.at(b, a) = std::sin(angle);
    result.at(a, b) = -std::sin(angle);
    return result;
  }
};

inline Transform transformFromRotX(float angle) { return Transform::fromRotX(angle); }
inline Transform transformFromRotY(float angle) { return Transform::fromRotY(angle); }
inline Transform transformFromRotZ(float angle) { return Transform::fromRotZ(angle); }
inline Transform transformFrom3DRotation(float wx, float wy, float wz) {
  return Transform::from3DRotation(wx, wy, wz);
}
inline Transform transformFromPosition(float x, float y, float z) { return Transform(x, y, z); }
inline Transform transformFromPosition(float x, float y, float z, float wx, float wy, float wz) {
  return Transform::fromPosition(x, y, z, wx, wy, wz);
}

inline Transform transformInverse(const Transform& transform) { return transform.inverse(); }
inline void transformInverse(const Transform& transform, Transform& inverse) {
  inverse = transform.inverse();
}
inline void transformInvertInPlace(Transform& transform) { transform = transform.inverse(); }
inline Transform pinv(const Transform& transform) { return transform.inverse(); }
/// `second` becomes first * second.
inline void transformPreMultiply(const Transform& first, Transform& second) {
  second = first * second;
}
inline void normalizeTransform(Transform& transform) { transform.normalizeTransform(); }
inline float norm(const Transform& transform) { return transform.norm(); }
inline float determinant(const Transform& transform) { return transform.determinant(); }
/// Of the turn of a transform's 12 or 16 numbers. @throws std::runtime_error
inline float determinant(const std::vector<float>& numbers) {
  return Transform(numbers).determinant();
}
inline std::vector<float> transformToFloatVector(const Transform& transform) {
  return transform.toVector();
}
inline void transformToFloatVector(const Transform& transform, std::vector<float>& all) {
  all = transform.toVector();
}
inline float distance(const Transform& a, const Transform& b) { return a.distance(b); }
inline float distanceSquared(const Transform& a, const Transform& b) {
  return a.distanceSquared(b);
}
inline float transformDistance(const Transform& a, const Transform& b) { return a.distance(b); }
inline float transformDistanceSquared(const Transform& a, const Transform& b) {
  return a.distanceSquared(b);
}
inline Transform transformDiff(const Transform& a, const Transform& b) { return a.diff(b); }

}  // namespace Math
}  // namespace AL
