#pragma once

#include <vector>

#include "validation/diagnosis/causes/chosen.h"

namespace nao::validation {

/// Two places of a model, and the one cause that may stand for both.
struct OneForTwo {
  std::size_t place = 0, gone = 0;
  CauseList model;  // the others, then that cause
};

/// A joint whose encoder is off by as much as the floor slopes is, to itself, one whose stop was
/// moved: for every cause of `found` that has twins, each of these at the same number to either
/// side, within its bounds, and in turn one of the other causes gone.
std::vector<OneForTwo> onesForTwo(const CauseList& found, const std::vector<Cause>& causes);

}  // namespace nao::validation
