#include "walk_engine/rise.h"

#include <algorithm>
#include <cmath>

namespace nao::walk {
namespace {

constexpr double kMinTime = 0.1;  // [s]; free
constexpr double kSpeed = 0.35;   // of a joint's top speed, on average at most; free

double minimumJerk(double s) { return s * s * s * (10 + s * (6 * s - 15)); }

}  // namespace

void Rise::plan(const RobotModel& model, const JointArray<double>& now,
                const JointArray<double>& walking, double dt) {
  double seconds = kMinTime;
  offset_ = now;
  for (std::size_t i = 0; i < now.size(); ++i) {
    offset_[i] -= walking[i];
    const double speed = kSpeed * model.actuators[i].max_velocity;
    if (speed > 0) seconds = std::max(seconds, std::abs(offset_[i]) / speed);
  }
  done_ = 0;
  cycles_ = static_cast<int>(std::lround(seconds / dt));
}

void Rise::apply(JointArray<double>& angle) {
  if (left() == 0) return;
  ++done_;
  const double rest = 1 - minimumJerk(static_cast<double>(done_) / cycles_);
  for (std::size_t i = 0; i < angle.size(); ++i) angle[i] += rest * offset_[i];
}

void Rise::archive(Archive& archive) {
  archive.value(offset_);
  archive.value(cycles_);
  archive.value(done_);
}

}  // namespace nao::walk
