#pragma once

#include "camera/raster.h"
#include "camera/view.h"
#include "core/world_model.h"

namespace nao::camera {

/// The plane z = 0 through a pinhole. Straight edges on the ground are straight edges on the
/// picture, so all of it is linear or quadratic over the picture.
struct GroundForms {
  LinearForm fall;    // how fast the ray through a pixel falls; positive below the horizon
  LinearForm x;       // x of the ground point times fall [m]
  LinearForm y;       // y of the ground point times fall [m]
  double height = 0;  // of the camera [m], at least 1 mm

  explicit GroundForms(const View& view);

  /// 1 / depth of the ground [1/m]; negative above the horizon.
  LinearForm inverseDepth() const { return (1 / height) * fall; }
};

class CarpetGrain;

/// Paints sky, floor, carpet and the marks on it, each edge by the part of the pixel it covers:
/// far lines fade instead of flickering. Covers every pixel; leaves the depths alone.
void paintGround(const WorldModel& world, const GroundForms& ground, const CarpetGrain& grain,
                 Raster& raster);

/// The same as labels (camera/ground_truth.h): sky, ground or mark.
void paintGroundLabels(const WorldModel& world, const GroundForms& ground, Raster& raster);

}  // namespace nao::camera
