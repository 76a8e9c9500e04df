#pragma once

#include <cmath>
#include <vector>

#include <usarnaoqi_sdk/export.h>

namespace AL {
namespace Math {

const float PI = 3.14159265358979f;
const float _2_PI_ = 2.0f * PI;
const float PI_2 = PI / 2.0f;
const float PI_4 = PI / 4.0f;
const float TO_RAD = PI / 180.0f;  // of degrees
const float TO_DEG = 180.0f / PI;  // of radians

/// The same direction, from -pi (left out) to pi.
inline float modulo2PI(float angle) {
  const float within = std::remainder(angle, _2_PI_);
  return within <= -PI ? PI : within;
}
inline void modulo2PIInPlace(float& angle) { angle = modulo2PI(angle); }

/// The direction of the sum of the angles' unit vectors, each as long as its weight.
/// @throws std::runtime_error where they cancel out, or for lists of different lengths.
USARNAOQI_SDK_API float weightedMeanAngle(const std::vector<float>& angles,
                                          const std::vector<float>& weights);
/// The same with weights that are all equal.
USARNAOQI_SDK_API float meanAngle(const std::vector<float>& angles);

}  // namespace Math
}  // namespace AL
