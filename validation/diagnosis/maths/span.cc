#include "validation/diagnosis/maths/span.h"

#include <Eigen/QR>

namespace nao::validation {

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  if (columns.cols() == 0) return columns;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
}

Eigen::VectorXd without(const Eigen::MatrixXd& basis, const Eigen::VectorXd& x) {
  if (basis.cols() == 0) return x;
  return x - basis * (basis.transpose() * x);
}

}  // namespace nao::validation
