// Accelerometer and gyroscope read a constant part too much: a' = (1 + acc) a, w' = (1 + gyro) w.
// Naos: 1 % and 5 % (NAOqi 2.1.4.13 documentation, inertial unit).
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class ImuScale final : public Effect {
 public:
  explicit ImuScale(const EffectSetup& setup)
      : accelerometer_(1 + setup.value("acc")), gyroscope_(1 + setup.value("gyro")) {}

  void alterImu(SensorFrame& frame, Duration) override {
    frame.accelerometer *= accelerometer_;
    frame.gyroscope *= gyroscope_;
  }

 private:
  double accelerometer_, gyroscope_;
};

}  // namespace

EffectType imuScale() {
  return {"imu_scale",
          "Accelerometer and gyroscope exaggerate or understate.",
          {{"acc", "", 0.01, 0, -1, 5, 0.005}, {"gyro", "", 0.05, 0, -1, 5, 0.005}},
          Acts::OnImu,
          makeEffect<ImuScale>};
}

}  // namespace nao::sim
