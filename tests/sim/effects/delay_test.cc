#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "sim/world.h"
#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kOmega = 2 * M_PI;  // [rad/s] 1 Hz

/// A sine fitted to samples by least squares over whole periods.
class Fit {
 public:
  void add(double t, double value) {
    sine_ += value * std::sin(kOmega * t);
    cosine_ += value * std::cos(kOmega * t);
  }
  double lateness() const { return -std::atan2(cosine_, sine_) / kOmega; }  // [s]

 private:
  double sine_ = 0, cosine_ = 0;
};

// How late [s] HeadYaw is reported behind a commanded sine of 1 Hz, commands sent and angles read
// every cycle, as a client would.
double shiftOfHeadYaw(const std::string& robot) {
  const auto model = nao::test::robot(robot);
  const Joint head = *model->findJoint("HeadYaw");
  World world(nao::test::flatWorld(), {{"nao", model, {}}}, WorldOptions(2ms));
  JointCommand command{world.readSensors(0).angle, JointArray<double>(model->jointCount(), 1.0)};
  Fit fit;
  const double cycle = toSeconds(model->cycle);
  for (double t = 0; t < 5 - 1e-9; t += cycle) {
    const double reported = world.readSensors(0).angle[head];
    if (t >= 2 - 1e-9) fit.add(t, reported);
    command.angle[head] = 0.4 * std::sin(kOmega * t);
    world.setCommand(0, command);
    for (Duration done{}; done < model->cycle; done += world.stepSize()) world.step();
  }
  return fit.lateness();
}

TEST(DocumentedDelay, AlignsCommandedAndReportedHeadYawAt36Milliseconds) {
  for (const char* robot :
       {"nao_h21_v33", "nao_h21_v40", "nao_h25_v33", "nao_h25_v40", "nao_h25_v50", "nao_h25_v60"}) {
    const double shift = shiftOfHeadYaw(robot);
    EXPECT_NEAR(shift, 0.036, 0.004) << robot;
    std::printf("  %-12s %.1f ms\n", robot, 1e3 * shift);
  }
}

TEST(DocumentedDelay, OfTheIdealRobotIsThatOfServoAndCycle) {
  const auto model = nao::test::robot("nao_h21_v33_ideal");
  const Actuator& motor = model->actuators[index(*model->findJoint("HeadYaw"))];
  // A servo is a first-order lag of kd / kp; it answers a command that is held for a cycle T with
  // y' = a y + (1 - a) c, a = exp(-T kp / kd), which is T / (1 - a) late. The head's inertia and
  // half a physics step add less than 0.5 ms.
  const double cycle = toSeconds(model->cycle);
  const double expected = cycle / (1 - std::exp(-cycle * motor.kp / motor.kd));
  EXPECT_NEAR(shiftOfHeadYaw("nao_h21_v33_ideal"), expected, 0.0005);
}

}  // namespace
}  // namespace nao::sim::test
