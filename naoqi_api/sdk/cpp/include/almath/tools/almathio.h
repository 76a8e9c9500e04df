#pragma once

#include <ostream>
#include <sstream>
#include <string>

#include <almath/tools/almath.h>

namespace AL {
namespace Math {
namespace detail {

inline std::ostream& writeNumbers(std::ostream& out, const char* name,
                                  const std::vector<float>& numbers) {
  out << name << "(";
  for (std::size_t i = 0; i < numbers.size(); ++i) out << (i == 0 ? "" : ", ") << numbers[i];
  return out << ")";
}

inline std::string spaceSeparated(const std::vector<float>& numbers) {
  std::ostringstream text;
  for (std::size_t i = 0; i < numbers.size(); ++i) text << (i == 0 ? "" : " ") << numbers[i];
  return text.str();
}

}  // namespace detail

// Name(number, number, ...).
inline std::ostream& operator<<(std::ostream& out, const Pose2D& it) {
  return detail::writeNumbers(out, "Pose2D", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const Position2D& it) {
  return detail::writeNumbers(out, "Position2D", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const Position3D& it) {
  return detail::writeNumbers(out, "Position3D", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const Position6D& it) {
  return detail::writeNumbers(out, "Position6D", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const Velocity3D& it) {
  return detail::writeNumbers(out, "Velocity3D", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const Velocity6D& it) {
  return detail::writeNumbers(out, "Velocity6D", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const PositionAndVelocity& it) {
  return detail::writeNumbers(out, "PositionAndVelocity", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const Rotation& it) {
  return detail::writeNumbers(out, "Rotation", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const Rotation3D& it) {
  return detail::writeNumbers(out, "Rotation3D", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const Quaternion& it) {
  return detail::writeNumbers(out, "Quaternion", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const Transform& it) {
  return detail::writeNumbers(out, "Transform", it.toVector());
}
inline std::ostream& operator<<(std::ostream& out, const TransformAndVelocity6D& it) {
  return out << "TransformAndVelocity6D(" << it.T << ", " << it.V << ")";
}

// The numbers of toVector(), a space between each two.
inline std::string toSpaceSeparated(const Position3D& it) {
  return detail::spaceSeparated(it.toVector());
}
inline std::string toSpaceSeparated(const Position6D& it) {
  return detail::spaceSeparated(it.toVector());
}
inline std::string toSpaceSeparated(const Velocity6D& it) {
  return detail::spaceSeparated(it.toVector());
}
inline std::string toSpaceSeparated(const Rotation3D& it) {
  return detail::spaceSeparated(it.toVector());
}
inline std::string toSpaceSeparated(const Quaternion& it) {
  return detail::spaceSeparated(it.toVector());
}
inline std::string toSpaceSeparated(const Transform& it) {
  return detail::spaceSeparated(it.toVector());
}

}  // namespace Math
}  // namespace AL
