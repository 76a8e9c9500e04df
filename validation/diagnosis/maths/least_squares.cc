#include "validation/diagnosis/maths/least_squares.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

namespace nao::validation {
namespace {

using Residual = std::function<Eigen::VectorXd(const std::vector<double>&)>;

// Remembers the last place asked for, as Ceres asks for value and derivatives apart.
class Differences {
 public:
  Differences(const Residual& residual, const FitSpace& space)
      : residual_(residual), space_(space) {}

  const Eigen::VectorXd& at(const std::vector<double>& x) {
    if (x != x_) {
      value_ = residual_(x);
      x_ = x;
      ++evaluations_;
      has_jacobian_ = false;
    }
    return value_;
  }

  const Eigen::MatrixXd& jacobianAt(const std::vector<double>& x) {
    at(x);
    if (has_jacobian_) return jacobian_;
    jacobian_.resize(value_.size(), static_cast<Eigen::Index>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) {
      std::vector<double> beside = x;
      beside[i] += differenceStep(space_, i, x[i]);
      jacobian_.col(static_cast<Eigen::Index>(i)) =
          (residual_(beside) - value_) / (beside[i] - x[i]);
      ++evaluations_;
    }
    has_jacobian_ = true;
    return jacobian_;
  }

  int evaluations() const { return evaluations_; }

 private:
  const Residual& residual_;
  const FitSpace& space_;
  std::vector<double> x_;
  Eigen::VectorXd value_;
  Eigen::MatrixXd jacobian_;
  bool has_jacobian_ = false;
  int evaluations_ = 0;
};

class Cost final : public ceres::CostFunction {
 public:
  Cost(Differences& differences, int residuals, int numbers) : differences_(differences) {
    set_num_residuals(residuals);
    mutable_parameter_block_sizes()->push_back(numbers);
  }

  bool Evaluate(double const* const* x, double* residuals, double** jacobians) const override {
    const int n = parameter_block_sizes()[0];
    const std::vector<double> at(x[0], x[0] + n);
    const Eigen::VectorXd& value = differences_.at(at);
    std::copy(value.data(), value.data() + value.size(), residuals);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      if (n == 1) {  // Eigen has no row-major column
        const Eigen::MatrixXd& jacobian = differences_.jacobianAt(at);
        std::copy(jacobian.data(), jacobian.data() + jacobian.size(), jacobians[0]);
      } else {
        Eigen::Map<RowMajor>(jacobians[0], num_residuals(), n) = differences_.jacobianAt(at);
      }
    }
    return true;
  }

 private:
  Differences& differences_;
};

ceres::Solver::Options optionsOf(const FitSpace& space) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = space.iterations;
  options.function_tolerance = 1e-4;   // of the cost: far below a nat that matters
  options.parameter_tolerance = 1e-3;  // the intervals are wider
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

double differenceStep(const FitSpace& space, std::size_t i, double x) {
  const double step = std::max(space.step[i], space.part * std::abs(x));
  return x + step <= space.upper[i] ? step : -step;
}

namespace {

FitPoint evaluated(Eigen::VectorXd residual) {
  FitPoint point;
  point.residual = std::move(residual);
  point.cost = point.residual.squaredNorm() / 2;
  point.evaluations = 1;
  return point;
}

// All numbers free.
FitPoint solve(const Residual& residual, const FitSpace& space) {
  Differences differences(residual, space);
  std::vector<double> x = space.start;
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = std::clamp(x[i], space.lower[i], space.upper[i]);
  const auto rows = static_cast<int>(differences.at(x).size());
  ceres::Problem problem;
  problem.AddResidualBlock(new Cost(differences, rows, static_cast<int>(x.size())), nullptr,
                           x.data());
  for (std::size_t i = 0; i < x.size(); ++i) {
    problem.SetParameterLowerBound(x.data(), static_cast<int>(i), space.lower[i]);
    problem.SetParameterUpperBound(x.data(), static_cast<int>(i), space.upper[i]);
  }
  ceres::Solver::Summary summary;
  ceres::Solve(optionsOf(space), &problem, &summary);
  FitPoint found;
  found.x = x;
  found.residual = differences.at(x);
  if (space.slopes) found.jacobian = differences.jacobianAt(x);
  found.cost = found.residual.squaredNorm() / 2;
  found.evaluations = differences.evaluations();
  return found;
}

}  // namespace

FitPoint leastSquares(const Residual& residual, const FitSpace& space) {
  std::vector<std::size_t> free;
  FitSpace varied;  // Ceres takes no number whose bounds meet, and not none
  varied.part = space.part;
  varied.iterations = space.iterations;
  varied.slopes = space.slopes;
  for (std::size_t i = 0; i < space.start.size(); ++i) {
    if (space.isFixed(i)) continue;
    free.push_back(i);
    varied.start.push_back(space.start[i]);
    varied.lower.push_back(space.lower[i]);
    varied.upper.push_back(space.upper[i]);
    varied.step.push_back(space.step[i]);
  }
  if (!free.empty() && free.size() == space.start.size()) return solve(residual, space);
  const auto whole = [&](const std::vector<double>& x) {
    std::vector<double> all = space.start;
    for (std::size_t i = 0; i < free.size(); ++i) all[free[i]] = x[i];
    return all;
  };
  FitPoint found = free.empty() ? evaluated(residual(space.start))
                                : solve([&](const auto& x) { return residual(whole(x)); }, varied);
  found.x = whole(found.x);
  if (!space.slopes) return found;
  const Eigen::MatrixXd slopes = found.jacobian;
  found.jacobian =
      Eigen::MatrixXd::Zero(found.residual.size(), static_cast<Eigen::Index>(space.start.size()));
  for (std::size_t i = 0; i < free.size(); ++i) {
    found.jacobian.col(static_cast<Eigen::Index>(free[i])) =
        slopes.col(static_cast<Eigen::Index>(i));
  }
  return found;
}

}  // namespace nao::validation
