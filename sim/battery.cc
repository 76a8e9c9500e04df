#include "sim/battery.h"

#include <algorithm>

namespace nao::sim {
namespace {

// [A] Computer, boards and cameras. Estimate: 48.6 Wh last 90 minutes at little motion (NAOqi
// 2.1.4.13 documentation, battery), which is 1.5 A, motors that hold included.
constexpr double kBaseCurrent = 1.0;
constexpr double kEmpty = 18.0;           // [V] six cells at 3.0 V, without load
constexpr double kFull = 25.2;            // [V] documented
constexpr double kInnerResistance = 0.2;  // [Ohm] estimate for six cells and leads
constexpr double kSecondsPerHour = 3600;

}  // namespace

void Battery::sample(double dt, SensorFrame& frame) {
  double current = kBaseCurrent;
  for (const double motor : frame.current) current += motor;
  charge_ = std::max(0.0, charge_ - current * dt / (model_.capacity_ah * kSecondsPerHour));
  frame.battery.charge = charge_;
  frame.battery.current = -current;
  frame.battery.voltage = kEmpty + charge_ * (kFull - kEmpty) - kInnerResistance * current;
}

}  // namespace nao::sim
