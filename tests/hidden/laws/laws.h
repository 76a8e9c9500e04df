#pragma once

#include <functional>
#include <memory>

#include "sim/effects/catalogue.h"

namespace nao::hidden {

/// The simulator's effects, and the laws of this folder beside them. These are written here and
/// nowhere else, so that what a diagnosis has to find is not what it fits:
///   likenesses  the cause of a catalogue entry by another law (friction.cc, timing.cc, gear.cc,
///               board.cc)
///   strangers   causes that no entry of the catalogue stands for (strangers_*.cc)
const sim::EffectCatalogue& hiddenEffects();

/// A law of the drives without memory, for joint j at a moment.
using DriveLaw = std::function<void(const sim::DriveMoment&, std::size_t j, sim::DriveTerms&)>;
std::unique_ptr<sim::Effect> driveLaw(const sim::EffectSetup& setup, DriveLaw law);

/// What a servo sees of one joint; it follows angle + the error that the law makes of `error`.
struct ServoMoment {
  double error = 0;  // [rad] command less angle
  double angle = 0;  // [rad] its encoder's, of the step before
  double time = 0;   // [s] since the run began
};
using ServoLaw = std::function<double(const ServoMoment&)>;
std::unique_ptr<sim::Effect> servoLaw(const sim::EffectSetup& setup, ServoLaw law);

/// Friction `torque` of either sign of motion without a kink: torque v / sqrt(v^2 + creep^2), as
/// the viscous coefficient that does the same at this speed, so that the step stays implicit.
double smoothFriction(double torque, double rate, double creep);

/// Seconds of rest before a recorded run begins: laws that depend on time count from its end.
inline constexpr double kRestBefore = 0.5;

// One line per law.
sim::EffectType smoothCoulomb();
sim::EffectType viscousWithSquare();
sim::EffectType lorentzStribeck();
sim::EffectType motorLoadFriction();
sim::EffectType smoothAsymmetry();
sim::EffectType softPlay();
sim::EffectType dryCompliance();
sim::EffectType shiftedEncoder();
sim::EffectType denseCore();
sim::EffectType tiedBall();
sim::EffectType messageLatency();
sim::EffectType clockedHold();
sim::EffectType lateReading();
sim::EffectType twoPoleFilter();
sim::EffectType easedRateLimit();
sim::EffectType smoothDeadband();
sim::EffectType resistiveSag();
sim::EffectType ankleHull();
sim::EffectType turnedBoard();
sim::EffectType averagingBoard();

sim::EffectType roughPatch();
sim::EffectType quadraticDrag();
sim::EffectType periodicTorque();
sim::EffectType stickySpot();
sim::EffectType detent();
sim::EffectType torqueStep();
sim::EffectType hardeningSpring();
sim::EffectType speedBand();
sim::EffectType pulsingFriction();
sim::EffectType hose();
sim::EffectType oneSidedGain();
sim::EffectType driftingGain();
sim::EffectType commandHysteresis();
sim::EffectType eccentricEncoder();

}  // namespace nao::hidden
