#include "validation/diagnosis/joint/cross_validation.h"

#include <Eigen/QR>

namespace nao::validation {
namespace {

constexpr double kExcited = 9;  // squared noise SDs: a response of 3 SD in a part acts there

using Mask = Eigen::VectorXd;  // 1: held out, 0: trained on

struct Parts {
  Eigen::VectorXd before;    // residual without the candidate
  Halves after;              // with it
  Eigen::MatrixXd jacobian;  // of the prediction, per number
  Eigen::Index rest = 0;     // numbers that are not the candidate's
};

// What numbers still explain of a residual when they are fitted once more to the samples that are
// not held out.
Eigen::VectorXd movedBy(const Eigen::VectorXd& residual, const Eigen::MatrixXd& jacobian,
                        const Mask& held_out) {
  if (jacobian.cols() == 0) return Eigen::VectorXd::Zero(residual.size());
  const Mask train = 1 - held_out.array();
  const Eigen::MatrixXd part = train.asDiagonal() * jacobian;
  const Eigen::VectorXd move =
      part.colPivHouseholderQr().solve(train.cwiseProduct(residual).eval());
  return jacobian * move;
}

Halves changeOf(const Parts& parts) {
  return {parts.before - parts.after.first, parts.before - parts.after.second};
}

// Squares of a part, without what chance adds.
double squareOf(const Halves& halves, const Mask& part) {
  return part.cwiseProduct(halves.first).dot(halves.second);
}

void addFold(CrossValidation& sum, const Parts& parts, const Mask& held_out) {
  const Halves change = changeOf(parts);
  const double held = squareOf(change, held_out);
  if (held < kExcited || change.first.dot(change.second) - held < kExcited) return;
  const Eigen::VectorXd before =
      parts.before - movedBy(parts.before, parts.jacobian.leftCols(parts.rest), held_out);
  const Eigen::VectorXd move = movedBy(parts.after.mean(), parts.jacobian, held_out);
  const Halves after{parts.after.first - move, parts.after.second - move};
  const double gain = (held_out.cwiseProduct(before).squaredNorm() - squareOf(after, held_out)) / 2;
  ++sum.folds;
  if (gain > 0) ++sum.better;
  sum.gain += gain;
}

}  // namespace

CrossValidation crossValidate(const JointData& data, const Stage& stage, const ModelFit& fit,
                              std::size_t own) {
  Parts parts;
  parts.before = stage.whitenAll(stage.raw());
  const auto left = [&](const Eigen::VectorXd& half) {
    return stage.whitenAll(stage.raw() - half);
  };
  parts.after = fit.change.through(left);
  parts.jacobian.resize(data.size(), fit.jacobian.cols());
  for (Eigen::Index i = 0; i < fit.jacobian.cols(); ++i) {
    parts.jacobian.col(i) = stage.whitenAll(fit.jacobian.col(i));
  }
  parts.rest = fit.jacobian.cols() - static_cast<Eigen::Index>(own);
  // Select motions are held out of every fold but their own.
  Parts of_fit = parts;
  const Eigen::Index unseen = data.size() - data.fitSize();
  of_fit.before.tail(unseen).setZero();
  of_fit.after.first.tail(unseen).setZero();
  of_fit.after.second.tail(unseen).setZero();
  of_fit.jacobian.bottomRows(unseen).setZero();
  CrossValidation sum;
  for (const MotionSpan& span : data.spans()) {
    Mask mask = Mask::Zero(data.size());
    mask.segment(span.offset, span.size()).setOnes();
    if (span.split == Split::Fit) addFold(sum, of_fit, mask);
    if (squareOf(changeOf(of_fit), mask) >= kExcited) ++sum.motions_excited;
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
