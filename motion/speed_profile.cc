#include "motion/speed_profile.h"

#include <algorithm>

namespace nao::motion {
namespace {

// Integral of the smoothstep 3x^2 - 2x^3 from 0 to x; 1/2 at x = 1.
double smoothstepIntegral(double x) { return x * x * x * (1 - x / 2); }

}  // namespace

SpeedProfile::SpeedProfile(double way_time, double ramp)
    : way_time_(std::max(way_time, 0.0)), ramp_(std::clamp(ramp, 0.0, way_time_)) {}

double SpeedProfile::at(double time) const {
  if (time >= duration()) return 1;
  if (time <= 0) return 0;
  const double left = duration() - time;
  if (time < ramp_) return ramp_ * smoothstepIntegral(time / ramp_) / way_time_;
  if (left < ramp_) return 1 - ramp_ * smoothstepIntegral(left / ramp_) / way_time_;
  return (time - ramp_ / 2) / way_time_;
}

}  // namespace nao::motion
