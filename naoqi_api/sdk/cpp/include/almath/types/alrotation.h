#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <almath/types/alposition3d.h>
#include <almath/types/alquaternion.h>

namespace AL {
namespace Math {

/// A turn as a 3x3 matrix. a * b: first b, then a.
struct Rotation {
  float r1_c1, r1_c2, r1_c3;
  float r2_c1, r2_c2, r2_c3;
  float r3_c1, r3_c2, r3_c3;

  /// The identity.
  Rotation()
      : r1_c1(1), r1_c2(0), r1_c3(0), r2_c1(0), r2_c2(1), r2_c3(0), r3_c1(0), r3_c2(0), r3_c3(1) {}
  /// Row by row, 9 numbers. @throws std::runtime_error
  explicit Rotation(const std::vector<float>& numbers) {
    if (numbers.size() != 9) {
      throw std::runtime_error("ALMath: expected 9 numbers for a Rotation, found " +
                               std::to_string(numbers.size()));
    }
    for (int i = 0; i < 9; ++i) at(i) = numbers[static_cast<std::size_t>(i)];
  }

  float at(int i) const { return this->*field(i); }
  float& at(int i) { return this->*field(i); }
  float at(int row, int column) const { return at(3 * row + column); }
  float& at(int row, int column) { return at(3 * row + column); }

  Rotation operator*(const Rotation& other) const {
    Rotation product;
    for (int i = 0; i < 9; ++i) {
      product.at(i) = 0;
      for (int k = 0; k < 3; ++k) product.at(i) += at(i / 3, k) * other.at(k, i % 3);
    }
    return product;
  }
  Rotation& operator*=(const Rotation& other) { return *this = *this * other; }
  bool operator==(const Rotation& other) const { return isNear(other, 0); }
  bool operator!=(const Rotation& other) const { return !(*this == other); }
  /// Each number within `epsilon` of the other's.
  bool isNear(const Rotation& other, float epsilon = 0.0001f) const {
    for (int i = 0; i < 9; ++i) {
      if (!(std::fabs(at(i) - other.at(i)) <= epsilon)) return false;
    }
    return true;
  }

  /// Which is the inverse.
  Rotation transpose() const {
    Rotation result;
    for (int i = 0; i < 9; ++i) result.at(i) = at(i % 3, i / 3);
    return result;
  }
  float determinant() const {
    return r1_c1 * (r2_c2 * r3_c3 - r2_c3 * r3_c2) - r1_c2 * (r2_c1 * r3_c3 - r2_c3 * r3_c1) +
           r1_c3 * (r2_c1 * r3_c2 - r2_c2 * r3_c1);
  }
  /// Whether its columns are of length 1, at right angles and right-handed, within `epsilon`.
  bool isRotation(float epsilon = 0.0001f) const {
    return (transpose() * *this).isNear(Rotation(), epsilon) &&
           std::fabs(determinant() - 1) <= epsilon;
  }
  /// Makes it exactly one again: x keeps its direction and y its side of it.
  /// @throws std::runtime_error where x and y have none.
  void normalizeRotation() {
    const Position3D x = Position3D(r1_c1, r2_c1, r3_c1).normalize();
    const Position3D along(r1_c2, r2_c2, r3_c2);
    const Position3D y = (along - x * x.dotProduct(along)).normalize();
    *this = fromAxes(x, y, x.crossProduct(y));
  }

  /// Nine numbers, row by row.
  std::vector<float> toVector() const {
    std::vector<float> all;
    for (int i = 0; i < 9; ++i) all.push_back(at(i));
    return all;
  }
  void toVector(std::vector<float>& all) const { all = toVector(); }
  /// From `to` on, where there is room for them; `to` is moved behind them.
  void writeToVector(std::vector<float>::iterator& to) const {
    const std::vector<float> all = toVector();
    to = std::copy(all.begin(), all.end(), to);
  }

  static Rotation fromRotX(float angle) { return fromAngleDirection(angle, 1, 0, 0); }
  static Rotation fromRotY(float angle) { return fromAngleDirection(angle, 0, 1, 0); }
  static Rotation fromRotZ(float angle) { return fromAngleDirection(angle, 0, 0, 1); }
  /// By exactly half a turn, or a quarter.
  static Rotation fromRotXPi() { return diagonal(1, -1, -1); }
  static Rotation fromRotYPi() { return diagonal(-1, 1, -1); }
  static Rotation fromRotZPi() { return diagonal(-1, -1, 1); }
  static Rotation fromRotZHalfPi() {
    return fromAxes(Position3D(0, 1, 0), Position3D(-1, 0, 0), Position3D(0, 0, 1));
  }
  /// Turned about the fixed axes x, then y, then z [rad].
  static Rotation from3DRotation(float wx, float wy, float wz) {
    return fromRotZ(wz) * fromRotY(wy) * fromRotX(wx);
  }
  /// By `angle` [rad] about (x, y, z), which need not have length 1.
  /// @throws std::runtime_error if it has no length.
  static Rotation fromAngleDirection(float angle, float x, float y, float z) {
    const Position3D axis = Position3D(x, y, z).normalize();
    const float c = std::cos(angle), s = std::sin(angle);
    const Position3D part = axis * (1 - c);
    return fromAxes(axis * part.x + Position3D(c, s * axis.z, -s * axis.y),
                    axis * part.y + Position3D(-s * axis.z, c, s * axis.x),
                    axis * part.z + Position3D(s * axis.y, -s * axis.x, c));
  }
  /// Of w, x, y, z. @throws std::runtime_error for 0
  static Rotation fromQuaternion(float w, float x, float y, float z) {
    const Quaternion q = Quaternion(w, x, y, z).normalize();
    return fromAxes(q * Position3D(1, 0, 0), q * Position3D(0, 1, 0), q * Position3D(0, 0, 1));
  }
  /// Where it takes x, y and z: the columns.
  static Rotation fromAxes(const Position3D& x, const Position3D& y, const Position3D& z) {
    Rotation result;
    for (int row = 0; row < 3; ++row) {
      result.at(row, 0) = x.at(row);
      result.at(row, 1) = y.at(row);
      result.at(row, 2) = z.at(row);
    }
    return result;
  }

  static float Rotation::*field(int i) {
    static float Rotation::*const kFields[] = {
        &Rotation::r1_c1, &Rotation::r1_c2, &Rotation::r1_c3, &Rotation::r2_c1, &Rotation::r2_c2,
        &Rotation::r2_c3, &Rotation::r3_c1, &Rotation::r3_c2, &Rotation::r3_c3};
    return kFields[i];
  }

 private:
  static Rotation diagonal(float x, float y, float z) {
    return fromAxes(Position3D(x, 0, 0), Position3D(0, y, 0), Position3D(0, 0, z));
  }
};

inline Position3D operator*(const Rotation& turn, const Position3D& p) {
  return Position3D(turn.r1_c1 * p.x + turn.r1_c2 * p.y + turn.r1_c3 * p.z,
                    turn.r2_c1 * p.x + turn.r2_c2 * p.y + turn.r2_c3 * p.z,
                    turn.r3_c1 * p.x + turn.r3_c2 * p.y + turn.r3_c3 * p.z);
}

inline Rotation transpose(const Rotation& turn) { return turn.transpose(); }
inline float determinant(const Rotation& turn) { return turn.determinant(); }
inline void normalizeRotation(Rotation& turn) { turn.normalizeRotation(); }
inline Rotation rotationFromRotX(float angle) { return Rotation::fromRotX(angle); }
inline Rotation rotationFromRotY(float angle) { return Rotation::fromRotY(angle); }
inline Rotation rotationFromRotZ(float angle) { return Rotation::fromRotZ(angle); }
inline Rotation rotationFrom3DRotation(float wx, float wy, float wz) {
  return Rotation::from3DRotation(wx, wy, wz);
}
inline Rotation rotationFromAngleDirection(float angle, float x, float y, float z) {
  return Rotation::fromAngleDirection(angle, x, y, z);
}
inline Rotation rotationFromQuaternion(float w, float x, float y, float z) {
  return Rotation::fromQuaternion(w, x, y, z);
}
/// Turns the point (x, y, z) in place.
inline void applyRotation(const Rotation& turn, float& x, float& y, float& z) {
  const Position3D turned = turn * Position3D(x, y, z);
  x = turned.x;
  y = turned.y;
  z = turned.z;
}

}  // namespace Math
}  // namespace AL
