// Accelerometer and gyroscope read a constant too much: a' = a + b_a, w' = w + b_w, in T, and the
// board fuses its angles from these. Source: data sheets of such sensors; a first-order error
// model.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class ImuBias final : public Effect {
 public:
  explicit ImuBias(const EffectSetup& setup)
      : accelerometer_(setup.value("acc_x"), setup.value("acc_y"), setup.value("acc_z")),
        gyroscope_(setup.value("gyro_x"), setup.value("gyro_y"), setup.value("gyro_z")) {}

  void alterImu(SensorFrame& frame, Duration) override {
    frame.accelerometer += accelerometer_;
    frame.gyroscope += gyroscope_;
  }

 private:
  Vec3 accelerometer_;  // [m/s^2]
  Vec3 gyroscope_;      // [rad/s]
};

}  // namespace

EffectType imuBias() {
  return {"imu_bias",
          "Accelerometer and gyroscope read a constant too much.",
          {{"acc_x", "m/s^2", 0.1, 0, -20, 20, 0.02},
           {"acc_y", "m/s^2", 0, 0, -20, 20, 0.02},
           {"acc_z", "m/s^2", 0, 0, -20, 20, 0.02},
           {"gyro_x", "rad/s", 0.01, 0, -5, 5, 0.002},
           {"gyro_y", "rad/s", 0, 0, -5, 5, 0.002},
           {"gyro_z", "rad/s", 0, 0, -5, 5, 0.002}},
          Acts::OnImu,
          makeEffect<ImuBias>};
}

}  // namespace nao::sim
