#include "validation/diagnosis/run_noise.h"

#include <algorithm>

#include "core/random.h"

namespace nao::validation {
namespace {

void addJitter(double amplitude, std::uint64_t seed, Eigen::MatrixXd& signals) {
  if (amplitude <= 0) return;
  Random random(seed, "encoder");
  for (Eigen::Index k = 0; k < signals.rows(); ++k) {
    const double draw = random.uniform();
    if (draw < 0.25) signals(k, 0) -= amplitude;
    if (draw >= 0.75) signals(k, 0) += amplitude;
  }
}

}  // namespace

std::uint64_t seedOf(std::uint64_t stream, std::size_t motion) {
  return stream * 0x9e3779b97f4a7c15ULL + motion + 1;
}

double drawLateness(const JointNoise& noise, std::uint64_t stream, std::size_t motion,
                    double most) {
  constexpr std::uint64_t kOther = 2;  // 0 and 2, 1 and 3: halves of a pool begin in time, too
  const double late = noise.start_sd * Random(seedOf(stream & ~kOther, motion), "start").normal();
  return std::clamp((stream & kOther) == 0 ? late : -late, -most, most);
}

void addEncoderNoise(const JointNoise& noise, std::uint64_t seed, Eigen::MatrixXd& signals) {
  addJitter(noise.jitter, seed, signals);
  if (noise.quantum <= 0) return;
  signals.col(0) = noise.quantum * (signals.col(0) / noise.quantum).array().round();
}

}  // namespace nao::validation
