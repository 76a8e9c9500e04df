#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace AL {
namespace Math {
namespace detail {

/// What positions and velocities have in common: kCount floats, added and scaled one by one. D says
/// with field(i) which they are, in the order of toVector().
template <class D, int kCount>
struct VectorSpace {
  float at(int i) const { return static_cast<const D&>(*this).*D::field(i); }
  float& at(int i) { return static_cast<D&>(*this).*D::field(i); }

  D operator+(const D& other) const { return D(own()) += other; }
  D operator-(const D& other) const { return D(own()) -= other; }
  D operator+() const { return own(); }
  D operator-() const { return own() * -1.0f; }
  D operator*(float factor) const { return D(own()) *= factor; }
  D operator/(float divisor) const { return D(own()) /= divisor; }
  D& operator+=(const D& other) {
    for (int i = 0; i < kCount; ++i) at(i) += other.at(i);
    return own();
  }
  D& operator-=(const D& other) {
    for (int i = 0; i < kCount; ++i) at(i) -= other.at(i);
    return own();
  }
  D& operator*=(float factor) {
    for (int i = 0; i < kCount; ++i) at(i) *= factor;
    return own();
  }
  /// @throws std::runtime_error for 0
  D& operator/=(float divisor) {
    if (divisor == 0) throw std::runtime_error("ALMath: division by zero");
    return own() *= 1.0f / divisor;
  }
  bool operator==(const D& other) const { return isNear(other, 0); }
  bool operator!=(const D& other) const { return !(*this == other); }

  /// Each number within `epsilon` of the other's.
  bool isNear(const D& other, float epsilon = 0.0001f) const {
    for (int i = 0; i < kCount; ++i) {
      if (!(std::fabs(at(i) - other.at(i)) <= epsilon)) return false;
    }
    return true;
  }
  float norm() const {
    float sum = 0;
    for (int i = 0; i < kCount; ++i) sum += at(i) * at(i);
    return std::sqrt(sum);
  }
  std::vector<float> toVector() const {
    std::vector<float> all;
    for (int i = 0; i < kCount; ++i) all.push_back(at(i));
    return all;
  }
  void toVector(std::vector<float>& all) const { all = toVector(); }
  /// From `to` on, where there is room for them; `to` is moved behind them.
  void writeToVector(std::vector<float>::iterator& to) const {
    for (int i = 0; i < kCount; ++i) *to++ = at(i);
  }

 protected:
  /// @throws std::runtime_error unless there are as many numbers as fields.
  void read(const std::vector<float>& numbers) {
    if (numbers.size() != static_cast<std::size_t>(kCount)) {
      throw std::runtime_error("ALMath: expected " + std::to_string(kCount) + " numbers, found " +
                               std::to_string(numbers.size()));
    }
    for (int i = 0; i < kCount; ++i) at(i) = numbers[static_cast<std::size_t>(i)];
  }

 private:
  const D& own() const { return static_cast<const D&>(*this); }
  D& own() { return static_cast<D&>(*this); }
};

template <class D, int kCount>
D operator*(float factor, const VectorSpace<D, kCount>& vector) {
  return vector * factor;
}

}  // namespace detail
}  // namespace Math
}  // namespace AL
