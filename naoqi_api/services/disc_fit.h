#pragma once

#include <optional>
#include <vector>

#include "core/frames.h"

namespace nao::services {

/// A circle in a picture [pixels]; x to the right, y down.
struct Disc {
  double x = 0;
  double y = 0;
  double radius = 0;

  /// How far outside of it a place is; negative inside.
  double outside(double to_x, double to_y) const;
};

/// A place on the border of a patch, between a pixel of it and one that is not.
struct BorderPoint {
  double x = 0;
  double y = 0;
};

/// What a patch tells of the disc that it is part of.
struct PatchShape {
  std::vector<BorderPoint> border;  // without what the picture's edge cuts; in any order
  int count = 0;                    // of its pixels
  int width = 0;                    // of the picture
  int height = 0;
};

/// The disc of which a patch shows all, or as much as something in front of it, the picture's edge
/// or shadow leave: more of its border lies on this circle than on any other that the patch lies
/// in and fills to a good part. Nothing if there is none. Two thirds of a disc may be hidden.
std::optional<Disc> fitDisc(PatchShape patch);

}  // namespace nao::services
