#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace nao::validation {

/// A cause of a model, as its sensitivities show it.
struct LinearCause {
  Eigen::MatrixXd white;    // change of the whitened prediction, a column per number
  Eigen::VectorXd numbers;  // of the model
  bool linear = true;       // so that `white` tells what the model is without it
};

/// A model without two or more of its causes.
struct SmallerModel {
  std::vector<std::size_t> kept;  // places in the model, at least one
  Eigen::VectorXd numbers;        // of those, fitted anew, one after the other
  double cost = 0;                // [nats] over the whole model
};

/// Which causes of a model may do no more than cancel each other: each alone is missed if it goes,
/// all together are not. Whatever costs at most `most` nats by the sensitivities, fewest causes
/// first, then cheapest. `left`: the whitened residual at the model's numbers.
std::vector<SmallerModel> smallerModels(const std::vector<LinearCause>& model,
                                        const Eigen::VectorXd& left, double most);

/// Pairs of a model's causes that undo each other but for a small part, places in order. What the
/// model is without both slopes at such sizes do not tell.
std::vector<std::pair<std::size_t, std::size_t>> undoneByEachOther(
    const std::vector<LinearCause>& model);

}  // namespace nao::validation
