#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "validation/diagnosis/joint_search.h"

namespace nao::validation {

/// Runs `work(i)` for all i < count on several threads; every i belongs to one thread from the
/// start, so that results do not depend on their number.
void inParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

/// A cause with one number for all joints.
struct SharedCause {
  std::size_t cause = 0;
  double x = 0;
  double gain = 0;                                     // [nats] of all joints
  int joints = 0;                                      // that gain more than the threshold
  std::vector<std::pair<std::size_t, double>> rivals;  // causes within reach, and their number
};

/// The cause of Scope::Robot that explains, with one number, about as much as each joint's own
/// best cause does for itself; none if no two joints need one.
std::optional<SharedCause> findShared(const std::vector<std::unique_ptr<JointSearch>>& searches,
                                      double critical, int jobs);

}  // namespace nao::validation
