// Gears, encoders, links and supply of the catalogue by other laws.
#include <cmath>

#include "tests/hidden/laws/laws.h"

namespace nao::hidden {
namespace {

constexpr double kFlank = 400;        // [N m/rad] of tooth flanks: 1 N m bends them by 2.5 mrad
constexpr double kFlankDamping = 1;   // [N m s/rad]
constexpr double kDryDamping = 0.05;  // [N m s/rad] a quarter of the catalogue's gear
constexpr double kBallRadius = 0.02;  // [m] a ball of lead of 0.4 kg

// An encoder that reads `angle` too much: the servo holds the joint that much lower, and the board
// reports what it reads.
class ShiftedEncoder final : public sim::Effect {
 public:
  explicit ShiftedEncoder(const sim::EffectSetup& setup)
      : joints_(setup.hinged()), angle_(setup.value("angle")) {}
  void alterCommand(JointCommand& command, SimTime, double) override {
    for (const std::size_t j : joints_) command.angle[j] -= angle_;
  }
  void alterSensors(SensorFrame& frame, Duration) override {
    for (const std::size_t j : joints_) frame.angle[j] += angle_;
  }

 private:
  std::vector<std::size_t> joints_;
  double angle_;  // [rad]
};

}  // namespace

sim::EffectType softPlay() {
  return {"hidden_soft_play",
          "Two bodies with a gap between them and flanks that give way.",
          {{"width", "rad", 0.0175, 0, 0, 0.35, 0}},
          sim::Acts::Once,
          [](const sim::EffectSetup& setup) {
            return sim::changePlan(
                [joints = setup.hinged(), width = setup.value("width")](sim::BodyPlan& plan) {
                  for (const std::size_t j : joints) {
                    sim::Transmission& gear = plan.transmissions[j];
                    gear.play += width;
                    if (width <= 0 || gear.stiffness > 0) continue;
                    gear.stiffness = kFlank;
                    gear.damping = kFlankDamping;
                  }
                });
          }};
}

sim::EffectType dryCompliance() {
  return {"hidden_dry_compliance",
          "A gear that bends, with hardly any damping.",
          {{"compliance", "rad/(N m)", 0.005, 0, 0, 1, 0}},
          sim::Acts::Once,
          [](const sim::EffectSetup& setup) {
            return sim::changePlan([joints = setup.hinged(),
                                    compliance = setup.value("compliance")](sim::BodyPlan& plan) {
              for (const std::size_t j : joints) {
                if (compliance <= 0) continue;
                plan.transmissions[j].stiffness = 1 / compliance;
                plan.transmissions[j].damping = kDryDamping;
              }
            });
          }};
}

sim::EffectType shiftedEncoder() {
  return {"hidden_shifted_encoder",
          "The encoder reads a constant angle too much.",
          {{"angle", "rad", 0.01, 0, -1, 1, 0}},
          sim::Acts::OnCommand | sim::Acts::OnSensors,
          sim::makeEffect<ShiftedEncoder>};
}

sim::EffectType denseCore() {
  return {"hidden_dense_core",
          "A link is heavier at its centre of mass: its own inertia stays.",
          {{"part", "", 0.1, 0, -0.95, 10, 0}},
          sim::Acts::Once,
          [](const sim::EffectSetup& setup) {
            return sim::changePlan(
                [bodies = setup.bodies(), part = setup.value("part")](sim::BodyPlan& plan) {
                  for (const std::size_t b : bodies) plan.model.bodies[b].mass *= 1 + part;
                });
          }};
}

sim::EffectType tiedBall() {
  return {"hidden_tied_ball",
          "A ball of lead at the centre of mass of a link.",
          {{"mass", "kg", 0.2, 0, 0, 50, 0}},
          sim::Acts::Once,
          [](const sim::EffectSetup& setup) {
            return sim::changePlan(
                [bodies = setup.bodies(), mass = setup.value("mass")](sim::BodyPlan& plan) {
                  const double inertia = 0.4 * mass * kBallRadius * kBallRadius;
                  for (const std::size_t b : bodies) {
                    plan.model.bodies[b].mass += mass;
                    plan.model.bodies[b].I_Bcm += inertia * Mat3::Identity();
                  }
                });
          }};
}

sim::EffectType resistiveSag() {
  return {"hidden_resistive_sag",
          "A weak battery whose voltage sinks a little further under load.",
          {{"drop", "", 0.15, 0, -0.5, 0.9, 0}},
          sim::Acts::OnDrive,
          [](const sim::EffectSetup& setup) {
            std::vector<double> stall;
            for (const Actuator& motor : setup.model.actuators) {
              stall.push_back(std::max(1e-6, motor.efficiency * motor.stall_torque));
            }
            return driveLaw(setup, [drop = setup.value("drop"), stall](
                                       const sim::DriveMoment& moment, std::size_t j, auto& terms) {
              const double effort = std::min(1.0, std::abs(moment.motor_torque[j]) / stall[j]);
              const double part = 1 - drop * (0.9 + 0.2 * effort);
              terms.torque_part[j] *= part;
              terms.speed_part[j] *= part;
            });
          }};
}

}  // namespace nao::hidden
