#pragma once

#include <set>
#include <string>
#include <vector>

#include "validation/diagnosis/folds/motion_fit.h"

namespace nao::validation {

/// What is held out together: runs of one servo gain where a set has several, else of one motion.
struct Fold {
  std::string name;
  std::vector<std::size_t> motions;  // of JointSimulator::measured()
};
/// The folds of the motions that are not test; `gains`: of the servo, by motion, relative to the
/// model's; empty: all alike. @throws InputError if there are fewer than two.
std::vector<Fold> foldsOf(const JointSimulator& joint, const std::vector<double>& gains);

/// The error of each fold by a model that was fitted to all others [rad].
struct FoldErrors {
  std::vector<double> held_out;
  double mean() const;
};

/// The same causes with one set of numbers per fold, fitted to the other folds, and one for all.
struct FoldModel {
  std::vector<CauseList> of_fold;
  CauseList of_all;
  FoldErrors errors;
};

/// A further cause, and where its fits begin.
struct FoldCandidate {
  std::size_t cause = 0;
  std::vector<std::vector<double>> starts;
};

/// A model with one cause more.
struct FoldTried {
  std::size_t cause = 0, place = 0;  // place: in the list of candidates
  double cost = 0;                   // of all folds
  FoldModel model;
};

/// Fits of models to a joint's folds, each left out in turn. Any thread may ask; `jobs` threads
/// work, the result is the same. `joint` is kept by reference.
class FoldFits {
 public:
  FoldFits(const JointSimulator& joint, const std::vector<Cause>& causes, std::vector<Fold> folds,
           const MotionFitOptions& options, int jobs);

  const std::vector<Fold>& folds() const { return folds_; }
  const std::vector<Cause>& causes() const { return causes_; }  // bounded at the joint
  const std::vector<std::size_t>& all() const { return all_; }  // motions of all folds
  const MotionFit& fit() const { return fit_; }

  /// Without any cause.
  FoldModel empty() const;
  /// The causes that promise most by one look each, best first, each with its best starts.
  std::vector<FoldCandidate> screened(const FoldModel& model, int most) const;
  /// The model with each of these: the few that fit all folds best, by their held-out error.
  std::vector<FoldTried> tryAll(const FoldModel& model,
                                const std::vector<FoldCandidate>& candidates) const;
  /// The model without each of its causes in turn.
  std::vector<FoldModel> withoutEach(const FoldModel& model) const;

 private:
  struct Looked {
    std::vector<double> x;
    double gain = 0;  // of the weighted squares
  };
  std::vector<std::size_t> motionsWithout(std::size_t fold) const;
  void measure(FoldModel& model) const;
  MotionFit::Result bestOf(const CauseList& model, const FoldCandidate& candidate,
                           const std::vector<std::size_t>& motions) const;
  Looked lookAt(const MotionFit::Result& at, std::size_t cause, std::vector<double> x) const;

  std::vector<Fold> folds_;
  std::vector<Cause> causes_;
  JointNoise noise_;
  std::vector<std::size_t> all_;
  int jobs_;
  MotionFit fit_;
};

}  // namespace nao::validation
