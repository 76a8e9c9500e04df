// Accelerometer and gyroscope are smoothed: time y' = x - y, exact for a reading held over a cycle.
// Source: the analog filters of such sensors, a first-order low pass.
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class ImuLowPass final : public Effect {
 public:
  explicit ImuLowPass(const EffectSetup& setup) : time_(setup.value("time")) {}

  void alterImu(SensorFrame& frame, Duration cycle) override {
    if (time_ <= 0) return;
    const double gain = begun_ ? 1 - std::exp(-toSeconds(cycle) / time_) : 1;
    begun_ = true;
    accelerometer_ += gain * (frame.accelerometer - accelerometer_);
    gyroscope_ += gain * (frame.gyroscope - gyroscope_);
    frame.accelerometer = accelerometer_;
    frame.gyroscope = gyroscope_;
  }

  void archive(Archive& archive) override {
    archive.value(begun_);
    archive.numbers(accelerometer_);
    archive.numbers(gyroscope_);
  }

 private:
  double time_;  // [s]
  bool begun_ = false;
  Vec3 accelerometer_ = Vec3::Zero();  // [m/s^2] smoothed
  Vec3 gyroscope_ = Vec3::Zero();      // [rad/s]
};

}  // namespace

EffectType imuLowPass() {
  return {"imu_low_pass",
          "Accelerometer and gyroscope are smoothed, and late by that.",
          {{"time", "s", 0.02, 0, 0, 5, 0.002}},
          Acts::OnImu,
          makeEffect<ImuLowPass>};
}

}  // namespace nao::sim
