// The inertial unit is mounted turned by the rotation vector (x, y, z), from T to its own axes:
// a' = R^T a, w' = R^T w. Source: geometry.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class ImuMisalignment final : public Effect {
 public:
  explicit ImuMisalignment(const EffectSetup& setup) {
    const Vec3 turn(setup.value("x"), setup.value("y"), setup.value("z"));
    if (turn.norm() <= 0) return;
    R_ = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix().transpose();
  }

  void alterImu(SensorFrame& frame, Duration) override {
    frame.accelerometer = R_ * frame.accelerometer;
    frame.gyroscope = R_ * frame.gyroscope;
  }

 private:
  Mat3 R_ = Mat3::Identity();  // from T to the unit's axes
};

}  // namespace

EffectType imuMisalignment() {
  return {"imu_misalignment",
          "The inertial unit sits turned in the chest.",
          {{"x", "rad", 0.02, 0, -3.2, 3.2, 0.0035},
           {"y", "rad", 0, 0, -3.2, 3.2, 0.0035},
           {"z", "rad", 0, 0, -3.2, 3.2, 0.0035}},
          Acts::OnImu,
          makeEffect<ImuMisalignment>};
}

}  // namespace nao::sim
