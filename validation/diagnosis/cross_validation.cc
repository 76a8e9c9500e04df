#include "validation/diagnosis/cross_validation.h"

#include <Eigen/QR>

namespace nao::validation {
namespace {

constexpr double kExcited = 9;  // squared noise SDs: a response of 3 SD in a part acts there

using Mask = Eigen::VectorXd;  // 1: held out, 0: trained on

struct Parts {
  Eigen::VectorXd before;    // residual without the candidate
  Eigen::VectorXd after;     // with it
  Eigen::MatrixXd jacobian;  // of the prediction, per number
  Eigen::Index rest = 0;     // numbers that are not the candidate's
};

// A residual after its numbers were fitted once more to the samples that are not held out.
Eigen::VectorXd refitted(const Eigen::VectorXd& residual, const Eigen::MatrixXd& jacobian,
                         const Mask& held_out) {
  if (jacobian.cols() == 0) return residual;
  const Mask train = 1 - held_out.array();
  const Eigen::MatrixXd part = train.asDiagonal() * jacobian;
  const Eigen::VectorXd move =
      part.colPivHouseholderQr().solve(train.cwiseProduct(residual).eval());
  return residual - jacobian * move;
}

void addFold(CrossValidation& sum, const Parts& parts, const Mask& held_out) {
  const Eigen::VectorXd change = parts.before - parts.after;
  const double held = held_out.cwiseProduct(change).squaredNorm();
  if (held < kExcited || change.squaredNorm() - held < kExcited) return;
  const Eigen::VectorXd before =
      refitted(parts.before, parts.jacobian.leftCols(parts.rest), held_out);
  const Eigen::VectorXd after = refitted(parts.after, parts.jacobian, held_out);
  const double gain =
      (held_out.cwiseProduct(before).squaredNorm() - held_out.cwiseProduct(after).squaredNorm()) /
      2;
  ++sum.folds;
  if (gain > 0) ++sum.better;
  sum.gain += gain;
}

}  // namespace

CrossValidation crossValidate(const JointData& data, const Stage& stage, const ModelFit& fit,
                              std::size_t own) {
  Parts parts;
  parts.before = stage.whitenAll(stage.raw());
  parts.after = stage.whitenAll(fit.raw);
  parts.jacobian.resize(data.size(), fit.jacobian.cols());
  for (Eigen::Index i = 0; i < fit.jacobian.cols(); ++i) {
    parts.jacobian.col(i) = stage.whitenAll(fit.jacobian.col(i));
  }
  parts.rest = fit.jacobian.cols() - static_cast<Eigen::Index>(own);
  // Select motions are held out of every fold but their own.
  Parts of_fit = parts;
  const Eigen::Index unseen = data.size() - data.fitSize();
  of_fit.before.tail(unseen).setZero();
  of_fit.after.tail(unseen).setZero();
  of_fit.jacobian.bottomRows(unseen).setZero();
  CrossValidation sum;
  for (const MotionSpan& span : data.spans()) {
    Mask mask = Mask::Zero(data.size());
    mask.segment(span.offset, span.size()).setOnes();
    if (span.split == Split::Fit) addFold(sum, of_fit, mask);
    const Eigen::VectorXd change = of_fit.before - of_fit.after;
    if (mask.cwiseProduct(change).squaredNorm() >= kExcited) ++sum.motions_excited;
  }
  Mask select = Mask::Zero(data.size());
  select.tail(unseen).setOnes();
  if (unseen > 0) addFold(sum, parts, select);
  for (int parity = 0; parity < 2; ++parity) {
    Mask mask(data.size());
    for (Eigen::Index i = 0; i < data.size(); ++i) {
      mask[i] = data.block()[static_cast<std::size_t>(i)] % 2 == parity ? 1 : 0;
    }
    addFold(sum, of_fit, mask);
  }
  return sum;
}

}  // namespace nao::validation
