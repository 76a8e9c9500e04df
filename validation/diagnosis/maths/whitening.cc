#include "validation/diagnosis/maths/whitening.h"

#include "validation/diagnosis/maths/thin_svd.h"

namespace nao::validation {

Whitening::Whitening(const Eigen::VectorXd& sd, const Eigen::MatrixXd& directions)
    : scale_(sd.cwiseInverse()) {
  if (directions.cols() == 0) return;
  // C = I + U U^T = I + B S^2 B^T, hence C^(-1/2) = I - B (1 - (1 + S^2)^(-1/2)) B^T.
  const Eigen::MatrixXd scaled_directions = scale_.asDiagonal() * directions;
  const ThinSvd svd = calcSvd(scaled_directions);
  basis_ = svd.left;
  shrink_ = 1 - (1 + svd.values.array().square()).rsqrt();
}

Eigen::VectorXd Whitening::scaled(const Eigen::VectorXd& residual) const {
  return scale_.cwiseProduct(residual);
}

Eigen::VectorXd Whitening::operator()(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd white = scaled(residual);
  if (basis_.cols() > 0) {
    const Eigen::VectorXd along = shrink_.cwiseProduct(basis_.transpose() * white);
    white -= basis_ * along;
  }
  return white;
}

}  // namespace nao::validation
