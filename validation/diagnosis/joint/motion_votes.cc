#include "validation/diagnosis/joint/motion_votes.h"

#include "validation/diagnosis/ensemble/joint_data.h"

namespace nao::validation {
namespace {

// Of a sum of as many independent votes, by how far they are apart.
Eigen::VectorXd varianceOfSum(const Eigen::MatrixXd& votes) {
  const auto count = static_cast<double>(votes.rows());
  const Eigen::MatrixXd apart = votes.rowwise() - votes.colwise().mean();
  return apart.colwise().squaredNorm().transpose() * (count / (count - 1));
}

}  // namespace

Eigen::MatrixXd votesOf(const JointData& data, const Stage& stage, const ModelSlopes& fit,
                        const SlopeSteps& steps, const Eigen::VectorXd& raw) {
  const Eigen::VectorXd best = steps(stage.whitenFit(raw));
  const Eigen::VectorXd left = stage.whitenFit(raw - fit.jacobian * best);
  std::vector<Eigen::VectorXd> rows;
  for (const MotionSpan& span : data.spans()) {
    if (span.split != Split::Fit) continue;
    Eigen::VectorXd own = Eigen::VectorXd::Zero(left.size());
    own.segment(span.offset, span.size()) = left.segment(span.offset, span.size());
    rows.push_back(steps(own));
  }
  Eigen::MatrixXd votes(static_cast<Eigen::Index>(rows.size()), fit.jacobian.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    votes.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  }
  return votes;
}

Eigen::VectorXd disagreement(const Eigen::MatrixXd& votes,
                             const std::vector<Eigen::MatrixXd>& votes_of_nulls) {
  if (votes.rows() < 2 || votes_of_nulls.empty()) return Eigen::VectorXd::Zero(votes.cols());
  Eigen::VectorXd by_chance = Eigen::VectorXd::Zero(votes.cols());
  for (const Eigen::MatrixXd& null : votes_of_nulls) by_chance += varianceOfSum(null);
  by_chance /= static_cast<double>(votes_of_nulls.size());
  return (varianceOfSum(votes) - by_chance).cwiseMax(0);
}

}  // namespace nao::validation
