#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "validation/diagnosis/joint/stage.h"

namespace nao::validation {

/// One thing that a remainder goes with.
struct SignatureTerm {
  std::string feature;   // "v|v|", "sin and cos of 18 q" ...
  double explained = 0;  // of the remainder's torque on motions left out, with the terms before it
};

/// torque * sin(periods * q + phase).
struct Ripple {
  double torque = 0;  // [N m]
  int periods = 0;    // in 2 pi of the joint
  double phase = 0;   // [rad]
};

/// A joint's misfit beside a model, as a torque, written as a short sum of features of its motion:
/// the shape of a law that the catalogue does not know. Terms are chosen one by one, each for what
/// it explains of motions that it was not fitted to; none: nothing is systematic, or the set has
/// but one fit motion.
struct Signature {
  std::vector<SignatureTerm> terms;
  std::optional<Ripple> ripple;  // the first term, if it is one, beside the others
  std::string text() const;
};

/// The rows of a motion, its angle and rate by column, that no stop can hold: where a joint rests
/// near an end of its range [rad], lower and upper, its stop takes any torque, and what a model
/// lacks there tells nothing.
std::vector<Eigen::Index> rowsOffStops(const Eigen::MatrixXd& motion,
                                       std::pair<double, double> range);

/// What `stage` leaves, whose model are `causes`: the torque that the model lacks to move as it was
/// measured, less what it lacks to move as it is predicted. What null sets lack by chance is no
/// remainder.
Signature signatureOf(const JointSimulator& joint, const JointData& data, const Stage& stage,
                      const std::vector<EffectSetting>& causes);

/// The same beside all that a stage's runs have in them: its model, and what is given.
Signature lackedAt(const JointSimulator& joint, const Ensemble& ensemble,
                   const std::vector<Cause>& causes, const Stage& stage);

}  // namespace nao::validation
