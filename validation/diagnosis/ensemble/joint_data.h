#pragma once

#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/ensemble/joint_simulator.h"
#include "validation/diagnosis/ensemble/repeats.h"

namespace nao::validation {

/// Where one motion stands in the stacked vectors of a joint: signal by signal, row by row.
struct MotionSpan {
  std::size_t motion = 0;  // of JointSimulator::measured()
  Split split = Split::Fit;
  Eigen::Index offset = 0, rows = 0, signals = 0;
  double dt = 0;  // [s]
  int repeats = 0;
  Eigen::Index size() const { return rows * signals; }
};

/// [counts] Amplitude of a harmonic, 1 or more, of what rounding to counts errs by over where
/// between two counts an angle lies: a sawtooth, smeared where readings shake by `sd` counts.
double roundingHarmonic(int harmonic, double sd);

/// What a diagnosis may see of a joint's measurements as one vector: its fit motions, then its
/// select motions. Test motions are left out, nobody here opens them.
class JointData {
 public:
  /// `noise` serves motions that were measured once: their spread is simulated.
  JointData(const JointSimulator& joint, const JointNoise& noise);

  const std::vector<MotionSpan>& spans() const { return spans_; }
  Eigen::Index size() const { return mean_.size(); }
  Eigen::Index fitSize() const { return fit_size_; }     // the samples of fit motions come first
  const Eigen::VectorXd& mean() const { return mean_; }  // of the repeats
  /// SD of the mean of the repeats at every sample, as if the samples were independent.
  const Eigen::VectorXd& sd() const { return sd_; }
  /// The part of it that all repeats share: a model that is off by a tenth of an encoder's count
  /// still predicts every tenth sample a count wrong [rad]; 0 for currents.
  const Eigen::VectorXd& rounding() const { return rounding_; }
  double quantum() const { return quantum_; }  // [rad] of the encoder, 0: none
  bool hasRepeats() const { return has_repeats_; }

  /// The runs of every motion, or of the first ones, one matrix per span, as a stacked vector.
  Eigen::VectorXd stack(const std::vector<Eigen::MatrixXd>& runs) const;
  /// The noise of the mean that repeats show without any model.
  std::vector<Eigen::VectorXd> splits() const;
  /// Of each sample: the number of its block of one second; blocks do not cross motions.
  const std::vector<int>& block() const { return block_; }
  int blocks() const { return blocks_; }

 private:
  void addMotions(Split split, const JointNoise& noise);
  // `start_sd`: [s] by which repeats begin apart, which shakes what encoders round.
  void addMotion(std::size_t motion, const JointMotion& measured, const RepeatStatistics& found,
                 double start_sd);

  const JointSimulator& joint_;
  std::vector<MotionSpan> spans_;
  double quantum_ = 0;  // [rad]
  Eigen::VectorXd mean_, sd_, rounding_;
  Eigen::Index fit_size_ = 0;
  std::vector<int> block_;
  int blocks_ = 0;
  bool has_repeats_ = true;
};

}  // namespace nao::validation
