// White noise on every reading of accelerometer and gyroscope: N(0, acc), N(0, gyro) per axis and
// cycle. Source: thermal noise of such sensors; nominal sizes are estimates for MEMS of 2008.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class ImuNoise final : public Effect {
 public:
  explicit ImuNoise(const EffectSetup& setup)
      : accelerometer_(setup.value("acc")),
        gyroscope_(setup.value("gyro")),
        random_(setup.random) {}

  void alterImu(SensorFrame& frame, Duration) override {
    for (int i = 0; i < 3; ++i) frame.accelerometer[i] += accelerometer_ * random_.normal();
    for (int i = 0; i < 3; ++i) frame.gyroscope[i] += gyroscope_ * random_.normal();
  }

  void archive(Archive& archive) override { archive.value(random_); }

 private:
  double accelerometer_;  // [m/s^2]
  double gyroscope_;      // [rad/s]
  Random random_;
};

}  // namespace

EffectType imuNoise() {
  return {"imu_noise",
          "White noise on accelerometer and gyroscope.",
          {{"acc", "m/s^2", 0.05, 0, 0, 10, 0.01}, {"gyro", "rad/s", 0.005, 0, 0, 2, 0.001}},
          Acts::OnImu,
          makeEffect<ImuNoise>};
}

}  // namespace nao::sim
