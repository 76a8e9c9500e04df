#include "sim/imu.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

constexpr double kGravity = 9.80665;
constexpr double kDegree = M_PI / 180;
constexpr double kRounding = 1e-9;

// The torso alone, moved by hand.
class ImuTest : public testing::TestWithParam<const char*> {
 protected:
  ImuTest() : model_(test::robot(GetParam())), imu_(*model_, kGravity), motion_(1) {}

  SensorFrame sample() {
    SensorFrame frame;
    imu_.sample(motion_, model_->cycle, frame);
    imu_.fuse(model_->cycle, frame);
    return frame;
  }
  double cycle() const { return toSeconds(model_->cycle); }

  // At rest there for 15 s: fifteen times as long as the board takes to trust gravity.
  SensorFrame rest(const Mat3& R_WT) {
    motion_[0] = {};
    motion_[0].R_WB = R_WT;
    SensorFrame frame;
    for (double t = 0; t < 15; t += cycle()) frame = sample();
    return frame;
  }

  std::shared_ptr<const RobotModel> model_;
  Imu imu_;
  std::vector<BodyMotion> motion_;
};

Mat3 rotation(double angle, const Vec3& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

Mat3 randomAttitude(Random& random) {
  const Vec3 axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1));
  return rotation(random.uniform(-M_PI, M_PI), axis);
}

TEST_P(ImuTest, AtRestItFeelsGravityAloneInAnyAttitude) {
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    const Mat3 R_WT = randomAttitude(random);
    motion_[0].R_WB = R_WT;
    sample();
    const SensorFrame frame = sample();
    EXPECT_LT((R_WT * frame.accelerometer - Vec3(0, 0, -kGravity)).norm(), kRounding);
    EXPECT_EQ(frame.gyroscope, Vec3::Zero());
  }
}

TEST_P(ImuTest, FusedAnglesAtRestAreTrueWhateverTheyWereBefore) {
  Random random(5);
  for (int k = 0; k < 20; ++k) {
    const double roll = random.uniform(-M_PI, M_PI);
    const double pitch = random.uniform(-1.5, 1.5);
    const SensorFrame frame = rest(rotation(random.uniform(-M_PI, M_PI), Vec3::UnitZ()) *
                                   rotation(pitch, Vec3::UnitY()) * rotation(roll, Vec3::UnitX()));
    EXPECT_LT(std::abs(wrapAngle(frame.angle_x - roll)), 0.1 * kDegree);
    EXPECT_NEAR(frame.angle_y, pitch, 0.1 * kDegree);
  }
}

// Turning at w about the vertical, the unit at p from it. It reads the mean of w^2 r over a cycle,
// which is w^2 r sin(x)/x with x = w dt/2, and points where r did half a cycle ago.
TEST_P(ImuTest, TurningShowsTheRateAndTheCentripetalTermOfItsPlace) {
  const double w = 8;  // [rad/s] on two axes as on three, within their range of 500 deg/s
  for (const Vec3& p_WT : {Vec3(0, 0, 0), Vec3(0.2, -0.1, 0.3)}) {
    imu_.state() = {};
    SensorFrame frame;
    for (int k = 0; k < 30; ++k) {
      const Mat3 R = rotation(w * k * cycle(), Vec3::UnitZ());
      motion_[0] = {R, R * p_WT, Vec3(0, 0, w), Vec3(0, 0, w).cross(R * p_WT)};
      frame = sample();
    }
    const Vec3 r = p_WT + model_->p_BoImu;
    const double x = w * cycle() / 2;
    const Vec3 outward =
        w * w * std::sin(x) / x * (rotation(-x, Vec3::UnitZ()) * Vec3(r.x(), r.y(), 0));
    EXPECT_LT((frame.accelerometer - outward - Vec3(0, 0, -kGravity)).norm(), kRounding);
    EXPECT_EQ(frame.gyroscope.z(), model_->gyro_axes == 3 ? w : 0);
  }
}

TEST_P(ImuTest, FollowsATiltAsItTurns) {
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
    rest(Mat3::Identity());
    const double w = 0.5;  // [rad/s]
    for (double angle = 0; angle < 1; angle += w * cycle()) {
      const Mat3 R = rotation(angle, axis);
      motion_[0] = {R, Vec3::Zero(), w * axis, Vec3::Zero()};
      const SensorFrame frame = sample();
      EXPECT_NEAR(frame.gyroscope.dot(axis), w, kRounding);
      // It turns for a cycle too long at the start: w dt = 0.3 degrees.
      EXPECT_NEAR(frame.angle_x, axis.x() * angle, w * cycle() + 0.1 * kDegree);
      EXPECT_NEAR(frame.angle_y, axis.y() * angle, w * cycle() + 0.1 * kDegree);
    }
  }
}

TEST_P(ImuTest, OnlyAThirdAxisKnowsTheYaw) {
  const double w = 1;  // [rad/s]
  const int cycles = 100;
  SensorFrame frame;
  for (int k = 0; k < cycles; ++k) {
    motion_[0] = {rotation(w * k * cycle(), Vec3::UnitZ()), Vec3::Zero(), Vec3(0, 0, w),
                  Vec3::Zero()};
    frame = sample();
  }
  // Upright throughout, but for the lever's centripetal term: w^2 r / g = 0.001 of tilt.
  EXPECT_NEAR(frame.angle_z, model_->gyro_axes == 3 ? w * cycles * cycle() : 0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(OfTwoAndThreeAxes, ImuTest,
                         testing::Values("nao_h21_v33", "nao_h25_v40", "nao_h25_v50",
                                         "nao_h25_v60"));

TEST(ImuPlace, IsTheDocumentedOneInEveryNao) {  // NAOqi 2.1.4.13 documentation, inertial_robot
  for (const char* name : {"nao_h21_v33", "nao_h25_v33", "nao_h25_v40", "nao_h25_v50"}) {
    const auto model = test::robot(name);
    EXPECT_EQ(model->imu_body, 0) << name;
    EXPECT_LT((model->p_BoImu - Vec3(-0.008, 0.00606, 0.027)).norm(), 1e-9) << name;
  }
}

}  // namespace
}  // namespace nao::sim
