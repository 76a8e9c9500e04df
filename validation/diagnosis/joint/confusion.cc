#include "validation/diagnosis/joint/confusion.h"

#include <algorithm>

namespace nao::validation {
namespace {

std::size_t bestOf(const std::vector<Fitted>& candidates, const Eigen::VectorXd& white) {
  std::size_t best = 0;
  double most = 0;
  for (std::size_t j = 0; j < candidates.size(); ++j) {
    const Explained explained(candidates[j].white, white);
    const double gain = explained.gain(std::max(0.0, explained.bestScale()));
    if (gain > most) most = gain, best = j;
  }
  return best;
}

}  // namespace

Confusion confusionOf(const std::vector<Fitted>& candidates,
                      const std::vector<Eigen::VectorXd>& nulls) {
  Confusion confusion;
  for (const Fitted& one : candidates) {
    confusion.causes.push_back(one.cause);
    std::vector<double>& row = confusion.share.emplace_back(candidates.size(), 0.0);
    const Eigen::VectorXd effect = one.white.mean();
    for (const Eigen::VectorXd& null : nulls) {
      row[bestOf(candidates, null + effect)] += 1 / static_cast<double>(nulls.size());
    }
  }
  return confusion;
}

}  // namespace nao::validation
