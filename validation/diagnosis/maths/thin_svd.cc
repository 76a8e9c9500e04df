#include "validation/diagnosis/maths/thin_svd.h"

#include <Eigen/SVD>

namespace nao::validation {

ThinSvd calcSvd(const Eigen::MatrixXd& matrix, Right right) {
  const bool both = right == Right::Wanted;
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(
      matrix, both ? Eigen::ComputeThinU | Eigen::ComputeThinV : Eigen::ComputeThinU);
  return {svd.matrixU(), svd.singularValues(), both ? svd.matrixV() : Eigen::MatrixXd()};
}

}  // namespace nao::validation
