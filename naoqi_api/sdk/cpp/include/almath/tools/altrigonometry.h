#pragma once

#include <cmath>

namespace AL {
namespace Math {

const float PI = 3.14159265358979f;
const float _2_PI_ = 2.0f * PI;
const float PI_2 = PI / 2.0f;
const float PI_4 = PI / 4.0f;
const float TO_RAD = PI / 180.0f;  // of degrees
const float TO_DEG = 180.0f / PI;  // of radians

/// The same direction within [-pi, pi].
inline float modulo2PI(float angle) { return std::remainder(angle, _2_PI_); }
inline void modulo2PIInPlace(float& angle) { angle = modulo2PI(angle); }

}  // namespace Math
}  // namespace AL
