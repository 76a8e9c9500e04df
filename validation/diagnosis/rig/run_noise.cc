#include "validation/diagnosis/rig/run_noise.h"

#include <algorithm>

namespace nao::validation {
namespace {

void addJitter(double amplitude, const RunDraw& draw, Eigen::MatrixXd& signals) {
  if (amplitude <= 0) return;
  Random random(draw.seed, "encoder", draw.pair);
  for (Eigen::Index k = 0; k < signals.rows(); ++k) {
    const double part = random.uniform();
    if (part < 0.25) signals(k, 0) -= amplitude;
    if (part >= 0.75) signals(k, 0) += amplitude;
  }
}

}  // namespace

RunDraw drawOf(std::uint64_t stream, std::size_t motion) {
  constexpr std::uint64_t kOther = 2;  // 0 and 2, 1 and 3: halves of a pool mirror themselves, too
  const std::uint64_t first = stream & ~kOther;
  return {first * 0x9e3779b97f4a7c15ULL + motion + 1,
          first == stream ? Random::Pair::First : Random::Pair::Mirrored};
}

double drawLateness(const JointNoise& noise, const RunDraw& draw, double most) {
  const double late = noise.start_sd * Random(draw.seed, "start", draw.pair).normal();
  return std::clamp(late, -most, most);
}

void addEncoderNoise(const JointNoise& noise, const RunDraw& draw, Eigen::MatrixXd& signals) {
  addJitter(noise.jitter, draw, signals);
  if (noise.quantum <= 0) return;
  signals.col(0) = noise.quantum * (signals.col(0) / noise.quantum).array().round();
}

}  // namespace nao::validation
