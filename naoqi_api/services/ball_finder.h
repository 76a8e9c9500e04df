#pragma once

#include <optional>

#include "camera/image.h"

namespace nao::services {

/// A ball in a picture, in parts of its width and height. What the edge or something else hides is
/// thought to be there.
struct SeenBall {
  double x = 0;         // 0 left to 1 right, of its middle
  double y = 0;         // 0 top to 1 bottom
  double diameter = 0;  // of the width
};

/// The largest red or orange patch of an RGB picture that may be a ball, or what is to be seen of
/// one; nothing if there is none.
std::optional<SeenBall> findRedBall(const camera::Image& image);

}  // namespace nao::services
