#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include <Eigen/Core>

#include "validation/diagnosis/causes/chosen.h"

namespace nao::validation {

/// A model, of a joint, a limb or a whole robot, and what its numbers do to the prediction.
struct ModelSlopes {
  CauseList model;
  Eigen::MatrixXd jacobian;  // of the prediction, all motions, a column per number
  Eigen::MatrixXd chance;    // in it: half of what two halves of the runs differ by, alike
};

/// Where the numbers of the cause at `place` begin among those of all.
Eigen::Index firstNumberOf(const CauseList& model, std::size_t place);

/// The first number of the cause at `place` alone, with its slope: all others stay as they are.
ModelSlopes sizeOf(const ModelSlopes& all, std::size_t place);

/// The place of the one cause whose number is as large as its smallest size of interest; none if
/// there are several or there is none. `smallest`: that size, of a cause in the list of causes.
std::optional<std::size_t> onlyOneOfInterest(
    const CauseList& model, const std::function<double(std::size_t cause)>& smallest);

}  // namespace nao::validation
