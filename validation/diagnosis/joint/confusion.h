#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/maths/halves.h"

namespace nao::validation {

/// A candidate as it was fitted: what it changes of the prediction, whitened.
struct Fitted {
  std::string cause;
  Halves white;
};

/// Makes data with each candidate in turn, by every one of `nulls` (whitened residuals of a right
/// model) once, and counts which candidate explains them best, each at its best size.
Confusion confusionOf(const std::vector<Fitted>& candidates,
                      const std::vector<Eigen::VectorXd>& nulls);

}  // namespace nao::validation
