#include "validation/diagnosis/maths/slope_steps.h"

#include <Eigen/Eigenvalues>

#include "core/check.h"
#include "validation/diagnosis/maths/thin_svd.h"

namespace nao::validation {
namespace {

constexpr double kMostChance = 0.8;  // of a slope's squares: what is left must carry the step
constexpr double kRank = 1e-9;       // of the largest singular value

}  // namespace

SlopeSteps::SlopeSteps(const Eigen::MatrixXd& slopes, const Eigen::MatrixXd& chance) {
  NAO_CHECK(slopes.rows() == chance.rows() && slopes.cols() == chance.cols());
  if (slopes.cols() == 0) return;
  const ThinSvd svd = calcSvd(slopes, Right::Wanted);
  const Eigen::VectorXd& size = svd.values;
  Eigen::Index rank = 0;
  while (rank < size.size() && size[rank] > kRank * size[0]) ++rank;
  basis_ = svd.left.leftCols(rank);
  if (rank == 0) {  // numbers that change nothing move nowhere
    numbers_.setZero(slopes.cols(), 0);
    return;
  }
  const Eigen::MatrixXd inverse =
      svd.right.leftCols(rank) * size.head(rank).cwiseInverse().asDiagonal();
  // In these coordinates the slopes' squares are the identity, the chance's a part of it.
  const Eigen::MatrixXd part = chance * inverse;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(part.transpose() * part);
  const Eigen::VectorXd stretch =
      (1 - eigen.eigenvalues().array().min(kMostChance)).inverse().matrix();
  const Eigen::MatrixXd& turn = eigen.eigenvectors();
  numbers_ = inverse * turn * stretch.asDiagonal() * turn.transpose();
}

Eigen::VectorXd SlopeSteps::operator()(const Eigen::VectorXd& white) const {
  return numbers_ * (basis_.transpose() * white);
}

}  // namespace nao::validation
