#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/jobs/kept_work.h"

namespace nao::validation {

/// Simulated runs of a set: by measured run, as many as asked for.
using WholePool = std::vector<std::vector<Eigen::VectorXd>>;

/// What a diagnosis of the limb or robot level simulated, so that one that was cut off need not do
/// it again. Any thread.
class KeptRuns {
 public:
  /// Keeps nothing.
  KeptRuns() = default;
  explicit KeptRuns(KeptWork kept) : kept_(std::move(kept)) {}

  /// The runs that `what` names in full, as they were kept or as `simulate` gives them now.
  WholePool remember(const std::string& what, const std::function<WholePool()>& simulate) const;

 private:
  KeptWork kept_;
};

}  // namespace nao::validation
