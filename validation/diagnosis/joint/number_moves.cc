#include "validation/diagnosis/joint/number_moves.h"

#include <cmath>

#include "core/random.h"
#include "validation/diagnosis/joint/by_chance.h"
#include "validation/diagnosis/joint/motion_votes.h"

namespace nao::validation {
namespace {

constexpr int kHarmonics = 3;  // of a sawtooth: 83 % of its variance

}  // namespace

Eigen::MatrixXd reestimated(const Stage& stage, const ModelSlopes& fit) {
  const SlopeSteps steps = stepsOf(fit, stage);
  Eigen::MatrixXd moves(static_cast<Eigen::Index>(stage.nulls().size()), fit.jacobian.cols());
  for (Eigen::Index n = 0; n < moves.rows(); ++n) {
    const Eigen::VectorXd& null = stage.nulls()[static_cast<std::size_t>(n)];
    moves.row(n) = steps(stage.whitenFit(null)).transpose();
  }
  return moves;
}

void addDisagreement(const JointData& data, const Stage& stage, const ModelSlopes& fit,
                     const Eigen::VectorXd& left, Eigen::MatrixXd& moves) {
  const SlopeSteps steps = stepsOf(fit, stage);
  std::vector<Eigen::MatrixXd> by_chance;
  for (const Eigen::VectorXd& null : stage.nulls()) {
    by_chance.push_back(votesOf(data, stage, fit, steps, null));
  }
  const Eigen::VectorXd variance = disagreement(votesOf(data, stage, fit, steps, left), by_chance);
  Random random(1, "disagreement");
  for (Eigen::Index n = 0; n < moves.rows(); ++n) {
    for (Eigen::Index i = 0; i < moves.cols(); ++i) {
      moves(n, i) += std::sqrt(variance[i]) * random.normal();
    }
  }
}

void addRounding(const JointData& data, const Stage& stage, const ModelSlopes& fit,
                 const Eigen::VectorXd& angle, Eigen::MatrixXd& moves) {
  const Eigen::Index size = data.fitSize();
  const Eigen::ArrayXd count = angle.head(size).array() / data.quantum();
  const Eigen::ArrayXd shake = stage.scatter().head(size).array() / data.quantum();
  const Eigen::ArrayXd of_angle =
      data.quantum() * (data.rounding().head(size).array() > 0).cast<double>();
  const SlopeSteps steps = stepsOf(fit, stage);
  for (int k = 1; k <= kHarmonics; ++k) {
    const double turn = 2 * M_PI * k;
    const Eigen::ArrayXd most =
        of_angle * shake.unaryExpr([k](double sd) { return roundingHarmonic(k, sd); });
    const Eigen::VectorXd sine = steps(stage.whitenFit((most * (turn * count).sin()).matrix()));
    const Eigen::VectorXd cosine = steps(stage.whitenFit((most * (turn * count).cos()).matrix()));
    Random random(1, "where between two counts");  // of every harmonic the same
    for (Eigen::Index n = 0; n < moves.rows(); ++n) {
      const double measured = turn * random.uniform(), model = turn * random.uniform();
      moves.row(n) += ((std::cos(measured) - std::cos(model)) * sine +
                       (std::sin(measured) - std::sin(model)) * cosine)
                          .transpose();
    }
  }
}

void addSpread(const std::vector<Cause>& causes, const CauseList& model, Eigen::MatrixXd& moves) {
  Random numbers(1, "undeclared numbers"), laws(1, "laws");
  Eigen::Index column = 0;
  for (const Chosen& one : model) {
    const double most = std::sqrt(3.0) * causes[one.cause].spreadAt(one.x[0]);
    const double law = causes[one.cause].lawErrorAt(one.x[0]);
    for (Eigen::Index n = 0; n < moves.rows(); ++n) {
      if (most > 0) moves(n, column) += numbers.uniform(-most, most);
      moves(n, column) += law * laws.normal();
    }
    column += static_cast<Eigen::Index>(one.x.size());
  }
}

FoundNumber within(FoundNumber number, const Eigen::VectorXd& moves, double high) {
  const std::vector<double> all(moves.data(), moves.data() + moves.size());
  number.low = number.deviation - quantile(all, high);
  number.high = number.deviation - quantile(all, 1 - high);
  return number;
}

bool mayBeSmall(const FoundNumber& size, const Eigen::VectorXd& moves, const Cause& cause,
                double high) {
  const FoundNumber one = within(size, moves, high);
  return mayBeSmall(one.low, one.high, cause.free[0].smallest);
}

}  // namespace nao::validation
