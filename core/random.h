#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace nao {

/// A seeded source of random numbers. Two sources made from the same seed and name give the same
/// numbers on every machine; different names give independent streams from one `--seed`. A plain
/// value of 48 bytes (xoshiro256++, Blackman and Vigna 2021), so that a snapshot holds it.
class Random {
 public:
  /// The other of an antithetic pair draws what mirrors the first: -x for a normal x, and a uniform
  /// number as far from the upper end of its range as the first is from the lower one.
  enum class Pair : std::uint64_t { First, Mirrored };

  explicit Random(std::uint64_t seed, std::string_view name = {}, Pair pair = Pair::First);

  double uniform();  // [0, 1)
  double uniform(double low, double high);
  double normal();  // mean 0, standard deviation 1

 private:
  std::uint64_t next();

  double plainUniform();

  std::array<std::uint64_t, 4> state_;
  double spare_ = 0;  // the second number of a normal pair
  bool has_spare_ = false;
  bool mirrored_ = false;
  std::array<std::uint8_t, 6> unused_{};  // no padding: a snapshot compares bytes
};

}  // namespace nao
