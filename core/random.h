#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace nao {

/// A seeded source of random numbers. Two sources made from the same seed and name give the same
/// numbers on every machine; different names give independent streams from one `--seed`.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::string_view name = {});

  double uniform();                 // [0, 1)
  double uniform(double low, double high);
  double normal();                  // mean 0, standard deviation 1

 private:
  std::mt19937_64 engine_;
  bool has_spare_ = false;
  double spare_ = 0;
};

}  // namespace nao
