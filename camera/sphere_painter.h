#pragma once

#include "camera/raster.h"
#include "camera/view.h"
#include "core/texture.h"

namespace nao::camera {

/// A sphere in the camera frame.
struct SphereInView {
  Vec3 p_C = Vec3::Zero();  // [m] its centre
  double radius = 0;        // [m]
  Pixel color = 0;
  Thing thing = kGround;
  bool is_flat = false;              // no light falls on it
  bool has_hard_rim = false;         // each pixel is painted as a whole or not at all
  bool has_patches = false;          // a soccer ball's: twelve black ones
  const Texture* texture = nullptr;  // in place of the colour, laid on as a globe's map
  Mat3 R_CS = Mat3::Identity();      // how patches and texture are turned
};

/// Paints a sphere by its exact outline, shaded pixel by pixel, its rim by the part of the pixel
/// it covers. Paint spheres from far to near, after all else, as the rims mix with what is there.
/// A sphere around the camera is left out.
/// @param lamp_C towards the light, unit length, in the camera frame
void paintSphere(const SphereInView& sphere, const Pinhole& lens, const Vec3& lamp_C,
                 const LinearForm& ground_inverse_depth, Raster& raster);

}  // namespace nao::camera
