#include "validation/diagnosis/maths/moving_mean.h"

#include <algorithm>

namespace nao::validation {

Eigen::VectorXd movingMean(const Eigen::VectorXd& x, Eigen::Index beside) {
  Eigen::VectorXd mean(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Eigen::Index from = std::max<Eigen::Index>(0, i - beside);
    const Eigen::Index to = std::min(x.size(), i + beside + 1);
    mean[i] = x.segment(from, to - from).mean();
  }
  return mean;
}

}  // namespace nao::validation
