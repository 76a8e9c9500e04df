#include "validation/diagnosis/ensemble/joint_data.h"

#include <algorithm>
#include <cmath>

#include "validation/diagnosis/ensemble/ensemble.h"

namespace nao::validation {
namespace {

constexpr int kSimulatedRepeats = 12;  // that stand in for repeats which were not measured
// Counts: what equal robots differ by beside what a diagnosis knows of. Free choice.
constexpr double kBesides = 0.05;

// [counts] RMS error of the mean of many readings of an angle that shakes by `sd` counts, over
// where between two counts it lies, by its first harmonic.
double roundingOf(double sd) { return roundingHarmonic(1, sd) / std::sqrt(2.0); }

std::vector<Eigen::MatrixXd> simulatedRepeats(const JointSimulator& joint, std::size_t motion,
                                              const JointNoise& noise) {
  std::vector<Eigen::MatrixXd> runs;
  for (int r = 0; r < kSimulatedRepeats; ++r) {
    runs.push_back(joint.run({}, motion, streamOf(StreamUse::Spread, motion, r), noise));
  }
  return runs;
}

}  // namespace

double roundingHarmonic(int harmonic, double sd) {
  const double turn = 2 * M_PI * harmonic;
  const double of_angle = std::max(0.0, sd * sd - 1.0 / 12);  // rounding itself shakes too
  return std::exp(-turn * turn * of_angle / 2) / (M_PI * harmonic);
}

JointData::JointData(const JointSimulator& joint, const JointNoise& noise) : joint_(joint) {
  addMotions(Split::Fit, noise);
  fit_size_ = mean_.size();
  addMotions(Split::Select, noise);
}

void JointData::addMotions(Split split, const JointNoise& noise) {
  quantum_ = std::max(noise.quantum, joint_.present("encoder_quantum", "quantum"));
  for (std::size_t m = 0; m < joint_.measured().size(); ++m) {
    const JointMotion& motion = joint_.measured()[m];
    if (motion.split != split || motion.repeats.empty()) continue;
    const bool alone = motion.repeats.size() < 2;
    has_repeats_ = has_repeats_ && !alone;
    addMotion(
        m, motion,
        alone ? statisticsOf(motion, simulatedRepeats(joint_, m, noise)) : statisticsOf(motion),
        noise.start_sd);
  }
}

void JointData::addMotion(std::size_t motion, const JointMotion& measured,
                          const RepeatStatistics& found, double start_sd) {
  const MotionSpan span{
      motion,      measured.split, mean_.size(), found.mean.rows(), found.mean.cols(),
      measured.dt, found.repeats};
  mean_.conservativeResize(span.offset + span.size());
  sd_.conservativeResize(span.offset + span.size());
  rounding_.conservativeResize(span.offset + span.size());
  const auto second = std::max<Eigen::Index>(1, std::lround(1 / measured.dt));
  const Eigen::VectorXd apart = start_sd * rateOf(found.mean.col(0), measured.dt);
  for (Eigen::Index s = 0; s < span.signals; ++s) {
    const Eigen::Index at = span.offset + s * span.rows;
    mean_.segment(at, span.rows) = found.mean.col(s);
    const double part = found.inflation[s] / found.repeats;
    for (Eigen::Index i = 0; i < span.rows; ++i) {
      const double sd = found.sd(i, s);
      const double rounding =
          s == 0 && quantum_ > 0
              ? quantum_ * std::hypot(kBesides, roundingOf(std::hypot(sd, apart[i]) / quantum_))
              : 0;
      rounding_[at + i] = rounding;
      sd_[at + i] = std::sqrt(sd * sd * part + rounding * rounding);
      block_.push_back(blocks_ + static_cast<int>(i / second));
    }
  }
  blocks_ += static_cast<int>((span.rows + second - 1) / second);
  spans_.push_back(span);
}

Eigen::VectorXd JointData::stack(const std::vector<Eigen::MatrixXd>& runs) const {
  const MotionSpan& last = spans_[runs.size() - 1];
  Eigen::VectorXd all(last.offset + last.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    all.segment(spans_[i].offset, spans_[i].size()) = runs[i].reshaped();
  }
  return all;
}

std::vector<Eigen::VectorXd> JointData::splits() const {
  std::vector<Eigen::VectorXd> found;
  int count = 1000;
  for (const MotionSpan& span : spans_) count = std::min(count, splitCount(span.repeats));
  for (int split = 0; split < count; ++split) {
    std::vector<Eigen::MatrixXd> differences;
    for (const MotionSpan& span : spans_) {
      differences.push_back(halfDifference(joint_.measured()[span.motion], split));
    }
    found.push_back(stack(differences));
  }
  return found;
}

}  // namespace nao::validation
