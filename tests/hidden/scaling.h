#pragma once

#include <functional>

#include "tests/hidden/hidden_case.h"

namespace nao::hidden {

struct Scaled {
  double deviation = 0;  // without its sign
  double size = 0;       // [SD of the measured mean] that it comes to
};

/// The deviation at which an effect is as large as wished, within the hideout's bounds, by trying;
/// what it ends at where that cannot be.
Scaled scaleTo(const Wish& wish, const std::function<double(double deviation)>& sizeOf);

}  // namespace nao::hidden
