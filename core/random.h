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
  explicit Random(std::uint64_t seed, std::string_view name = {});

  double uniform();  // [0, 1)
  double uniform(double low, double high);
  double normal();  // mean 0, standard deviation 1

 private:
  std::uint64_t next();

  std::array<std::uint64_t, 4> state_;
  double spare_ = 0;  // the second number of a normal pair
  std::uint64_t has_spare_ = 0;
};

}  // namespace nao
