#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace nao::validation {

/// What an Ensemble simulated, in the order it was asked: a search that is taken up again asks the
/// same and gets it from here. One thread.
class EnsembleTape {
 public:
  /// A new one.
  EnsembleTape() = default;
  /// One that was kept as bytes().
  explicit EnsembleTape(const std::string& bytes);

  /// The next result, as it was or else as `simulate` gives it; adds its runs to `used`, as
  /// `simulate` does.
  Eigen::VectorXd next(long& used, const std::function<Eigen::VectorXd()>& simulate);

  std::string bytes() const;

 private:
  struct Result {
    long runs = 0;  // it took
    Eigen::VectorXd values;
  };
  std::vector<Result> results_;
  std::size_t played_ = 0;
};

}  // namespace nao::validation
