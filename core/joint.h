#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/check.h"

namespace nao {

/// One motor of a robot: an index into RobotModel::actuators. Names, chains and NaoQi's groups
/// come from the robot's file. A Nao's two HipYawPitch joints are one motor, hence one Joint.
enum class Joint : std::uint8_t {};

constexpr std::size_t index(Joint joint) { return static_cast<std::size_t>(joint); }
constexpr Joint toJoint(std::size_t index) { return static_cast<Joint>(index); }

inline constexpr std::size_t kMaxJoints = 48;

/// One value per joint of a robot, indexed by the joint. Holds at most kMaxJoints without
/// allocating, so that frames and commands stay plain values on the simulation thread.
template <class T>
class JointArray {
 public:
  JointArray() = default;
  explicit JointArray(std::size_t size, T value = {}) : size_(size) {
    NAO_CHECK(size <= kMaxJoints);
    values_.fill(value);
  }

  T& operator[](Joint joint) { return values_[index(joint)]; }
  const T& operator[](Joint joint) const { return values_[index(joint)]; }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }

  std::size_t size() const { return size_; }
  T* begin() { return values_.data(); }
  T* end() { return values_.data() + size_; }
  const T* begin() const { return values_.data(); }
  const T* end() const { return values_.data() + size_; }

 private:
  std::size_t size_ = 0;
  std::array<T, kMaxJoints> values_{};
};

}  // namespace nao
