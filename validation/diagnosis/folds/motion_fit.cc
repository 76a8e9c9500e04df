#include "validation/diagnosis/folds/motion_fit.h"

#include <algorithm>
#include <cmath>

#include "validation/diagnosis/ensemble/ensemble.h"
#include "validation/diagnosis/maths/least_squares.h"

namespace nao::validation {
namespace {

// Finite differences as wide as the size of interest: less matters to nobody.
double stepOf(const FreeNumber& number) {
  const double typical = number.starts.empty() ? 1e-3 : std::abs(number.starts.front());
  return number.smallest > 0 ? number.smallest / 2 : std::max(0.05 * typical, 1e-6);
}

FitSpace spaceOf(const std::vector<Cause>& causes, const CauseList& start, int iterations) {
  FitSpace space;
  space.iterations = iterations;
  for (const Chosen& one : start) {
    for (std::size_t i = 0; i < one.x.size(); ++i) {
      const FreeNumber& number = causes[one.cause].free[i];
      space.start.push_back(one.x[i]);
      space.lower.push_back(number.lower);
      space.upper.push_back(number.upper);
      space.step.push_back(stepOf(number));
    }
  }
  return space;
}

}  // namespace

MotionFit::MotionFit(const JointSimulator& joint, const JointNoise& noise,
                     const std::vector<Cause>& causes, const MotionFitOptions& options)
    : joint_(joint), noise_(noise), causes_(causes), options_(options) {}

Eigen::VectorXd MotionFit::residual(const CauseList& model,
                                    const std::vector<std::size_t>& motions) const {
  const auto settings = settingsOf(causes_, model);
  std::vector<Eigen::VectorXd> parts;
  Eigen::Index size = 0;
  for (const std::size_t m : motions) {
    const JointMotion& motion = joint_.measured()[m];
    Eigen::VectorXd error = Eigen::VectorXd::Zero(motion.repeats.front().rows());
    for (const Eigen::MatrixXd& run : motion.repeats) {
      error += run.col(0) / static_cast<double>(motion.repeats.size());
    }
    for (int r = 0; r < options_.runs; ++r) {
      const JointNoise noise = options_.runs > 1 ? noise_ : JointNoise{};
      error -=
          joint_.run(settings, m, streamOf(StreamUse::Mean, m, r), noise).col(0) / options_.runs;
    }
    used_ += options_.runs;
    size += error.size();
    parts.push_back(std::move(error));
  }
  Eigen::VectorXd all(size);
  Eigen::Index at = 0;
  for (const Eigen::VectorXd& part : parts) {
    all.segment(at, part.size()) = part;
    at += part.size();
  }
  return all;
}

// rho(e) = sqrt(e^2 + s^2) - s; a least-squares solver sees sign(e) sqrt(2 rho).
Eigen::VectorXd MotionFit::softened(const Eigen::VectorXd& residual) const {
  const double s = options_.soft;
  return residual.unaryExpr(
      [s](double e) { return std::copysign(std::sqrt(2 * (std::sqrt(e * e + s * s) - s)), e); });
}

Eigen::VectorXd MotionFit::weights(const Eigen::VectorXd& residual) const {
  const double s = options_.soft;
  return residual.unaryExpr([s](double e) { return 1 / std::sqrt(e * e + s * s); });
}

double MotionFit::cost(const Eigen::VectorXd& residual) const {
  return softened(residual).squaredNorm() / 2 / static_cast<double>(residual.size());
}

MotionFit::Result MotionFit::fit(const CauseList& start,
                                 const std::vector<std::size_t>& motions) const {
  Result result;
  result.model = start;
  if (!start.empty()) {
    const auto softenedAt = [&](const std::vector<double>& x) {
      return softened(residual(withNumbers(start, x), motions));
    };
    FitSpace space = spaceOf(causes_, start, options_.iterations);
    space.slopes = false;
    result.model = withNumbers(start, leastSquares(softenedAt, space).x);
  }
  result.residual = residual(result.model, motions);
  result.cost = cost(result.residual);
  return result;
}

void MotionFit::linearise(Result& result, const std::vector<std::size_t>& motions) const {
  const std::vector<double> x = numbersOf(result.model);
  const FitSpace space = spaceOf(causes_, result.model, 0);
  result.residual = residual(result.model, motions);
  result.cost = cost(result.residual);
  result.jacobian.resize(result.residual.size(), static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::vector<double> beside = x;
    const double step = differenceStep(space, i, x[i]);
    beside[i] += step;
    result.jacobian.col(static_cast<Eigen::Index>(i)) =
        (result.residual - residual(withNumbers(result.model, beside), motions)) / step;
  }
}

}  // namespace nao::validation
