#include "motion/fall_detector.h"

#include <cmath>

namespace nao::motion {
namespace {

// Free choices: a Nao bows to about 0.6 rad without falling, and one that lies on its back, belly
// or side reads 1.3 rad or more.
constexpr double kFallingTilt = 0.8;  // [rad]
constexpr double kLyingTilt = 1.1;    // [rad]
constexpr double kUprightTilt = 0.5;  // [rad]
constexpr double kLyingTime = 0.3;    // [s]

}  // namespace

void FallDetector::update(const SensorFrame& measured, double dt) {
  const double tilt = std::acos(std::cos(measured.angle_x) * std::cos(measured.angle_y));
  lying_ = tilt > kLyingTilt ? lying_ + dt : 0;
  if (tilt < kUprightTilt) fallen_ = false;
  if (lying_ >= kLyingTime) fallen_ = true;
  falling_ = tilt > kFallingTilt && !fallen_;
}

void FallDetector::archive(Archive& archive) {
  archive.value(falling_);
  archive.value(fallen_);
  archive.value(lying_);
}

}  // namespace nao::motion
