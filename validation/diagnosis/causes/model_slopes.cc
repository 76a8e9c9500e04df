#include "validation/diagnosis/causes/model_slopes.h"

#include <cmath>

namespace nao::validation {

Eigen::Index firstNumberOf(const CauseList& model, std::size_t place) {
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < place; ++i) first += static_cast<Eigen::Index>(model[i].x.size());
  return first;
}

ModelSlopes sizeOf(const ModelSlopes& all, std::size_t place) {
  const Eigen::Index column = firstNumberOf(all.model, place);
  const Chosen& one = all.model[place];
  return {{{one.cause, {one.x[0]}}}, all.jacobian.col(column), all.chance.col(column)};
}

std::optional<std::size_t> onlyOneOfInterest(
    const CauseList& model, const std::function<double(std::size_t cause)>& smallest) {
  std::optional<std::size_t> only;
  for (std::size_t i = 0; i < model.size(); ++i) {
    if (std::abs(model[i].x[0]) < smallest(model[i].cause)) continue;
    if (only) return std::nullopt;
    only = i;
  }
  return only;
}

}  // namespace nao::validation
