#pragma once

#include "core/archive.h"
#include "core/robot_io.h"
#include "core/robot_model.h"

namespace nao::sim {

/// The battery: charge falls by the integral of the current, which is that of all motors and of
/// the head's computer and boards. Its voltage is linear in the charge, less what its inner
/// resistance takes.
class Battery {
 public:
  explicit Battery(const BatteryModel& model) : model_(model) {}

  void reset() { charge_ = 1; }
  void setCharge(double charge) { charge_ = charge; }  // 0 to 1

  /// Takes what the motors of `frame` draw for `dt` [s], and reports.
  void sample(double dt, SensorFrame& frame);

  void archive(Archive& archive) { archive.value(charge_); }

 private:
  const BatteryModel& model_;
  double charge_ = 1;
};

}  // namespace nao::sim
