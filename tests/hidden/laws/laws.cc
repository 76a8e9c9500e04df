#include "tests/hidden/laws/laws.h"

#include <cmath>

namespace nao::hidden {
namespace {

class Drives final : public sim::Effect {
 public:
  Drives(const sim::EffectSetup& setup, DriveLaw law)
      : joints_(setup.hinged()), law_(std::move(law)) {}

  void alterDrive(const sim::DriveMoment& moment, sim::DriveTerms& terms) override {
    for (const std::size_t j : joints_) law_(moment, j, terms);
  }

 private:
  std::vector<std::size_t> joints_;
  DriveLaw law_;
};

class Servos final : public sim::Effect {
 public:
  Servos(const sim::EffectSetup& setup, ServoLaw law)
      : joints_(setup.hinged()), law_(std::move(law)), angle_(joints_.size()) {}

  void alterCommand(JointCommand& command, SimTime now, double) override {
    for (std::size_t i = 0; seen_ != 0 && i < joints_.size(); ++i) {
      double& followed = command.angle[joints_[i]];
      const double time = toSeconds(now) - kRestBefore;
      followed = angle_[i] + law_({followed - angle_[i], angle_[i], time});
    }
  }

  void alterDrive(const sim::DriveMoment& moment, sim::DriveTerms&) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) angle_[i] = moment.angle[joints_[i]];
    seen_ = 1;
  }

  void archive(Archive& archive) override {
    archive.value(seen_);
    archive.list(angle_);
  }

 private:
  std::vector<std::size_t> joints_;
  ServoLaw law_;
  std::uint64_t seen_ = 0;     // 0: no angle is known yet
  std::vector<double> angle_;  // [rad]
};

}  // namespace

std::unique_ptr<sim::Effect> driveLaw(const sim::EffectSetup& setup, DriveLaw law) {
  return std::make_unique<Drives>(setup, std::move(law));
}

std::unique_ptr<sim::Effect> servoLaw(const sim::EffectSetup& setup, ServoLaw law) {
  return std::make_unique<Servos>(setup, std::move(law));
}

double smoothFriction(double torque, double rate, double creep) {
  return torque / std::sqrt(rate * rate + creep * creep);
}

const sim::EffectCatalogue& hiddenEffects() {
  static const sim::EffectCatalogue catalogue = [] {
    sim::EffectCatalogue all = sim::standardEffects();
    for (auto* const law :
         {smoothCoulomb,  viscousWithSquare, lorentzStribeck,   motorLoadFriction, smoothAsymmetry,
          softPlay,       dryCompliance,     shiftedEncoder,    denseCore,         tiedBall,
          messageLatency, clockedHold,       lateReading,       twoPoleFilter,     easedRateLimit,
          smoothDeadband, resistiveSag,      ankleHull,         turnedBoard,       averagingBoard,
          roughPatch,     quadraticDrag,     periodicTorque,    stickySpot,        detent,
          torqueStep,     hardeningSpring,   speedBand,         pulsingFriction,   hose,
          oneSidedGain,   driftingGain,      commandHysteresis, eccentricEncoder}) {
      all.add(law());
    }
    return all;
  }();
  return catalogue;
}

}  // namespace nao::hidden
