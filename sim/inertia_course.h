#pragma once

#include <Eigen/Core>

#include "sim/tree_matrix.h"

namespace nao::sim {

/// Mass matrix and bias of a tree from step to step: calculated every so many steps, in between
/// they go on as they changed. Beside what motors do they change slowly: an error by the square of
/// the time in between, and half of a limb's cost.
class InertiaCourse {
 public:
  explicit InertiaCourse(const TreeMatrix& of_tree) : last_inertia_(of_tree), slope_(of_tree) {}

  /// 1: they are calculated in every step.
  void setEvery(int steps);
  int every() const { return every_; }

  /// The tree was moved by hand: nothing is known of a course.
  void reset() { known_ = false; }
  bool isKnown() const { return known_; }
  /// Whether this step has to calculate them.
  bool isDue() const { return since_ == 0 || !known_; }

  /// They were calculated for this step.
  void take(const TreeMatrix& inertia, const Eigen::VectorXd& bias);
  /// One step on from what they were in the last one.
  void goOn(TreeMatrix& inertia, Eigen::VectorXd& bias);

 private:
  void count() { since_ = (since_ + 1) % every_; }

  int every_ = 1;                    // [steps]
  int since_ = 0;                    // steps that they were calculated
  bool known_ = false;               // that they were calculated at all
  TreeMatrix last_inertia_, slope_;  // slopes are per step
  Eigen::VectorXd last_bias_, bias_slope_;
};

}  // namespace nao::sim
