#include "sim/inertia_course.h"

#include "core/check.h"

namespace nao::sim {

void InertiaCourse::setEvery(int steps) {
  NAO_CHECK(steps > 0);
  every_ = steps;
  since_ = 0;
  known_ = false;
}

void InertiaCourse::take(const TreeMatrix& inertia, const Eigen::VectorXd& bias) {
  if (every_ == 1) return;
  if (!known_) {
    since_ = 0;
    last_bias_ = bias;
    last_inertia_.takeEntries(inertia);
  }
  bias_slope_ = (bias - last_bias_) / every_;
  slope_.takeDifference(inertia, last_inertia_, 1.0 / every_);
  last_bias_ = bias;
  last_inertia_.takeEntries(inertia);
  known_ = true;
  count();
}

void InertiaCourse::goOn(TreeMatrix& inertia, Eigen::VectorXd& bias) {
  bias += bias_slope_;
  inertia.add(slope_);
  count();
}

}  // namespace nao::sim
