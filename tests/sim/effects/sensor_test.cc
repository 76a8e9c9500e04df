#include <gtest/gtest.h>

#include <cmath>

#include "sim/world.h"
#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kCycle = 0.01;
constexpr Duration kStep = 1ms;
constexpr double kCount = 2 * M_PI / 4096;

// What the encoder reports, cycle by cycle, while the joint is at `truth(t)`.
template <class Truth>
std::vector<double> reported(const std::vector<EffectSetting>& effects, int cycles, Truth truth) {
  EffectChain chain = chainOf(*nao::test::pendulum(1, 1), effects, 1, kStep);
  const JointArray<double> none(1, 0.0);
  DriveTerms terms;
  std::vector<double> angles;
  for (SimTime now{}; angles.size() < static_cast<std::size_t>(cycles); now += kStep) {
    const JointArray<double> angle(1, truth(toSeconds(now)));
    if (now.time_since_epoch() % 10ms == Duration{}) {
      SensorFrame frame;
      frame.angle = frame.current = angle;
      chain.alterSensors(frame, 10ms);
      angles.push_back(frame.angle[0]);
    }
    chain.alterDrive({now, toSeconds(kStep), angle, none, none, none, none, none}, terms);
  }
  return angles;
}

double ramp(double t) { return 0.7 * t; }
double rest(double) { return 0.25; }

TEST(EncoderQuantum, ReportsTheNearestWholeCount) {
  for (const double angle : reported({effect("encoder_quantum")}, 100, ramp)) {
    const double counts = angle / kCount;
    EXPECT_NEAR(counts, std::round(counts), 1e-9);
  }
  EXPECT_NEAR(reported({effect("encoder_quantum")}, 1, rest)[0], 0.25, kCount / 2);
}

TEST(EncoderQuantum, CountsMayLieBesideZero) {
  constexpr double kPhase = 0.3 * kCount;
  for (const double angle : reported({effect("encoder_quantum", {{"phase", kPhase}})}, 100, ramp)) {
    const double counts = (angle - kPhase) / kCount;
    EXPECT_NEAR(counts, std::round(counts), 1e-9);
  }
}

TEST(EncoderJitter, IsOneCountAQuarterOfTheTimeEachWay) {
  constexpr int kSamples = 20000;
  int up = 0, down = 0;
  for (const double angle : reported({effect("encoder_jitter")}, kSamples, rest)) {
    const double counts = (angle - 0.25) / kCount;
    ASSERT_NEAR(counts, std::round(counts), 1e-9);
    ASSERT_LE(std::abs(counts), 1 + 1e-9);
    up += counts > 0.5;
    down += counts < -0.5;
  }
  const double sd = std::sqrt(0.25 * 0.75 * kSamples);  // of a count of such events
  EXPECT_NEAR(up, kSamples / 4, 5 * sd);
  EXPECT_NEAR(down, kSamples / 4, 5 * sd);
}

TEST(SensorDelay, ShiftsWhatIsReported) {
  for (const double delay : {0.0, 0.01, 0.025, 0.03}) {
    const auto angles = reported({effect("sensor_delay", {{"delay", delay}})}, 50, ramp);
    for (std::size_t i = 5; i < angles.size(); ++i) {
      ASSERT_NEAR(angles[i], ramp(static_cast<double>(i) * kCycle - delay), 1e-12) << delay;
    }
  }
}

// Between steps angles run straight: off by h^2 q'' / 8 at most, and where the latest step is ahead
// of what is known by q'' h^2.
TEST(SensorDelay, FollowsAnglesThatBend) {
  const auto swing = [](double t) { return 0.3 * std::sin(10 * t); };
  for (const double delay : {0.0004, 0.004, 0.013, 0.0253}) {
    const auto angles = reported({effect("sensor_delay", {{"delay", delay}})}, 50, swing);
    const double bend = 0.3 * 1e2 * std::pow(toSeconds(kStep), 2);
    const double most = delay < toSeconds(kStep) ? bend : bend / 8;
    for (std::size_t i = 6; i < angles.size(); ++i) {
      ASSERT_NEAR(angles[i], swing(static_cast<double>(i) * kCycle - delay), most) << delay;
    }
  }
}

// A joint that starts between two readings: no curve through readings knows when.
TEST(SensorDelay, KnowsWhenAJointStarted) {
  const auto start = [](double t) { return std::max(0.0, t - 0.204); };
  for (const double delay : {0.003, 0.01, 0.017}) {
    const auto angles = reported({effect("sensor_delay", {{"delay", delay}})}, 50, start);
    for (std::size_t i = 6; i < angles.size(); ++i) {
      ASSERT_NEAR(angles[i], start(static_cast<double>(i) * kCycle - delay), 1e-12) << delay;
    }
  }
}

TEST(SensorDelay, LeavesTheServoAlone) {
  const auto swing = [](const std::vector<EffectSetting>& effects) {
    auto model = std::make_shared<RobotModel>(*nao::test::pendulum(0.5, 0.2));
    model->effects = effects;
    World world(nao::test::flatWorld(), {{"dut", model, {}}}, WorldOptions(2ms));
    for (int i = 0; i < 100; ++i) {
      world.setCommand(0, {JointArray<double>(1, 0.5), JointArray<double>(1, 1.0)});
      world.step();
    }
    return world.scene().robots[0].X_WB[1].matrix();
  };
  EXPECT_EQ(swing({effect("sensor_delay", {{"delay", 0.05}})}), swing({}));
}

TEST(DroppedSamples, RepeatsThatPartOfTheFrames) {
  constexpr int kSamples = 20000;
  const auto angles = reported({effect("dropped_samples", {{"probability", 0.1}})}, kSamples, ramp);
  int repeated = 0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const bool same = angles[i] == angles[i - 1];
    repeated += same;
    ASSERT_DOUBLE_EQ(angles[i], same ? angles[i - 1] : ramp(static_cast<double>(i) * kCycle));
  }
  EXPECT_NEAR(repeated, 0.1 * kSamples, 5 * std::sqrt(0.09 * kSamples));
}

TEST(SampleJitter, IsLateByUpToItsSpanAndByHalfOnAverage) {
  constexpr double kSpan = 0.004;
  constexpr int kSamples = 20000;
  const auto angles = reported({effect("sample_jitter", {{"span", kSpan}})}, kSamples, ramp);
  double sum = 0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double late = static_cast<double>(i) * kCycle - angles[i] / 0.7;
    ASSERT_GE(late, -1e-9);
    ASSERT_LE(late, kSpan + 1e-9);
    sum += late;
  }
  EXPECT_NEAR(sum / kSamples, kSpan / 2, 5 * kSpan / std::sqrt(12.0 * kSamples));
}

SensorFrame inertial(EffectChain& chain, const Vec3& acceleration, const Vec3& rate) {
  SensorFrame frame;
  frame.accelerometer = acceleration;
  frame.gyroscope = rate;
  chain.alterImu(frame, 10ms);
  return frame;
}

const Vec3 kDown(0, 0, -9.81);
const Vec3 kTurn(0.1, -0.2, 0.3);

TEST(ImuBias, AddsToEveryReading) {
  EffectChain chain =
      chainOf(*nao::test::pendulum(1, 1),
              {effect("imu_bias", {{"acc_x", 0.2}, {"gyro_x", 0}, {"gyro_z", 0.01}})});
  const SensorFrame frame = inertial(chain, kDown, kTurn);
  EXPECT_LT((frame.accelerometer - kDown - Vec3(0.2, 0, 0)).norm(), 1e-15);
  EXPECT_LT((frame.gyroscope - kTurn - Vec3(0, 0, 0.01)).norm(), 1e-15);
}

TEST(ImuScale, Multiplies) {
  EffectChain chain =
      chainOf(*nao::test::pendulum(1, 1), {effect("imu_scale", {{"acc", 0.02}, {"gyro", -0.1}})});
  const SensorFrame frame = inertial(chain, kDown, kTurn);
  EXPECT_LT((frame.accelerometer - 1.02 * kDown).norm(), 1e-14);
  EXPECT_LT((frame.gyroscope - 0.9 * kTurn).norm(), 1e-15);
}

TEST(ImuMisalignment, SeesTheWorldTurnedTheOtherWay) {
  EffectChain chain =
      chainOf(*nao::test::pendulum(1, 1), {effect("imu_misalignment", {{"x", 0.1}})});
  const SensorFrame frame = inertial(chain, kDown, kTurn);
  const Vec3 expected(0, -9.81 * std::sin(0.1), -9.81 * std::cos(0.1));
  EXPECT_LT((frame.accelerometer - expected).norm(), 1e-12);
  EXPECT_NEAR(frame.gyroscope.norm(), kTurn.norm(), 1e-15);
}

TEST(ImuLowPass, AnswersAStepWithAnExponential) {
  constexpr double kTime = 0.05;
  EffectChain chain =
      chainOf(*nao::test::pendulum(1, 1), {effect("imu_low_pass", {{"time", kTime}})});
  inertial(chain, kDown, Vec3::Zero());
  for (int i = 1; i < 30; ++i) {
    const SensorFrame frame = inertial(chain, kDown, kTurn);
    const double answer = 1 - std::exp(-i * kCycle / kTime);
    ASSERT_LT((frame.gyroscope - answer * kTurn).norm(), 1e-12);
    ASSERT_LT((frame.accelerometer - kDown).norm(), 1e-12);
  }
}

TEST(ImuNoise, HasItsStandardDeviationOnEveryAxis) {
  constexpr int kSamples = 20000;
  EffectChain chain =
      chainOf(*nao::test::pendulum(1, 1), {effect("imu_noise", {{"acc", 0.1}, {"gyro", 0.02}})});
  Vec3 acc = Vec3::Zero(), gyro = Vec3::Zero();
  for (int i = 0; i < kSamples; ++i) {
    const SensorFrame frame = inertial(chain, kDown, kTurn);
    acc += (frame.accelerometer - kDown).cwiseAbs2() / kSamples;
    gyro += (frame.gyroscope - kTurn).cwiseAbs2() / kSamples;
  }
  const double spread = 5 * std::sqrt(2.0 / kSamples);  // of a variance, relative; five of these
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(acc[axis], 0.01, 0.01 * spread);
    EXPECT_NEAR(gyro[axis], 0.0004, 0.0004 * spread);
  }
}

// The board believes its sensors: a wrong accelerometer leans the fused angle by bias / g.
TEST(ImuBias, LeansTheAnglesThatTheBoardFuses) {
  auto model = std::make_shared<RobotModel>(*nao::test::robot("nao_h21_v33_ideal"));
  const auto pitch = [&](const std::vector<EffectSetting>& effects) {
    model->effects = effects;
    World world(nao::test::flatWorld(), {{"nao", model, {}}}, WorldOptions(2ms));
    SensorFrame frame;
    for (int i = 0; i < 1000; ++i) {
      if (i % 5 == 0) frame = world.readSensors(0);
      world.step();
    }
    return frame.angle_y;
  };
  const double ideal = pitch({});
  const double biased = pitch({effect("imu_bias", {{"acc_x", 0.3}, {"gyro_x", 0}})});
  EXPECT_NEAR(biased - ideal, std::atan(0.3 / 9.80665), 1e-3);  // it stands half a degree off level
}

SensorFrame pressed(const std::vector<EffectSetting>& effects) {
  const auto nao = nao::test::robot("nao_h21_v33_ideal");
  EffectChain chain = chainOf(*nao, effects);
  SensorFrame frame;
  frame.angle = frame.current = JointArray<double>(nao->jointCount());
  for (FootForces& foot : frame.feet) foot.force = {4, 6, 0.5, 8};
  chain.alterSensors(frame, 10ms);
  return frame;
}

TEST(FsrGain, ScalesEachForceAndWhatFollowsFromThem) {
  const SensorFrame frame = pressed({effect("fsr_gain", {{"front_left", 0.5}, {"rear_right", 2}})});
  const auto fsr = nao::test::robot("nao_h21_v33_ideal")->feet[1].fsr;
  const FootForces& right = frame.feet[1];
  EXPECT_EQ(right.force, (std::array<double, 4>{2, 6, 0.5, 16}));
  EXPECT_DOUBLE_EQ(right.total, 24.5);
  const Vec3 moment = 2 * fsr[0] + 6 * fsr[1] + 0.5 * fsr[2] + 16 * fsr[3];
  EXPECT_NEAR(right.cop_x, moment.x() / 24.5, 1e-12);
  EXPECT_NEAR(right.cop_y, moment.y() / 24.5, 1e-12);
}

TEST(FsrThreshold, FeelsNothingBelowIt) {
  const SensorFrame frame = pressed({effect("fsr_threshold", {{"force", 5}})});
  EXPECT_EQ(frame.feet[0].force, (std::array<double, 4>{0, 6, 0, 8}));
  EXPECT_DOUBLE_EQ(frame.feet[0].total, 14);
}

}  // namespace
}  // namespace nao::sim::test
