#pragma once

#include <atomic>
#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/joint/stage.h"

namespace nao::validation {

/// How the numbers of a model are fitted to motions without asking what noise there is.
struct MotionFitOptions {
  int runs = 1;  // simulated per motion; 1: without noise
  /// [rad] Errors well above count by their size, errors below by their square: a fit to the mean
  /// absolute error, which a few seconds of a model that is wrong do not rule.
  double soft = 0.01;
  int iterations = 12;
};

/// One joint's motions and models of causes that are fitted to some of them, all numbers at once.
/// For sets of one run per motion, and for numbers that a user wants fitted. Any thread may ask.
class MotionFit {
 public:
  /// All are kept by reference.
  MotionFit(const JointSimulator& joint, const JointNoise& noise, const std::vector<Cause>& causes,
            const MotionFitOptions& options);

  /// Measured less predicted angle of these motions, one after another [rad].
  Eigen::VectorXd residual(const CauseList& model, const std::vector<std::size_t>& motions) const;
  /// The cost that fits minimise: mean over the samples, in rad.
  double cost(const Eigen::VectorXd& residual) const;
  double meanError(const CauseList& model, const std::vector<std::size_t>& motions) const {
    return residual(model, motions).cwiseAbs().mean();
  }

  struct Result {
    CauseList model;
    double cost = 0;
    Eigen::VectorXd residual;
    Eigen::MatrixXd jacobian;  // of the prediction, a column per number; by linearise() alone
  };
  /// From `start` on. Numbers stay within the bounds of their causes.
  Result fit(const CauseList& start, const std::vector<std::size_t>& motions) const;

  /// Residual, cost and jacobian at a model.
  void linearise(Result& result, const std::vector<std::size_t>& motions) const;

  /// `soft`ened: whose squares sum to twice the cost.
  Eigen::VectorXd softened(const Eigen::VectorXd& residual) const;
  /// The weight of a sample in a fit at this residual.
  Eigen::VectorXd weights(const Eigen::VectorXd& residual) const;

  /// Runs simulated so far.
  long used() const { return used_; }

  const JointSimulator& joint() const { return joint_; }
  const std::vector<Cause>& causes() const { return causes_; }

 private:
  const JointSimulator& joint_;
  const JointNoise& noise_;
  const std::vector<Cause>& causes_;
  MotionFitOptions options_;
  mutable std::atomic<long> used_{0};
};

}  // namespace nao::validation
