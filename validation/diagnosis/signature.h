#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/stage.h"

namespace nao::validation {

/// One thing that a remainder goes with.
struct SignatureTerm {
  std::string feature;   // "v|v|", "sin and cos of 18 q" ...
  double explained = 0;  // of the remainder's torque on motions left out, with the terms before it
};

/// What is left of a joint's misfit, as a torque, written as a short sum of features of its motion:
/// the shape of a law that the catalogue does not know. Terms are chosen one by one, each for what
/// it explains of motions that it was not fitted to; none: nothing is systematic, or the set has
/// but one fit motion.
struct Signature {
  std::vector<SignatureTerm> terms;
  std::string text() const;
};

/// `stage` at the fitted model. The residual becomes a torque by the joint's own response to known
/// torques, which the stage's looks at friction show; the prediction it is taken from is already
/// what simulated noise leaves, so that a null has no signature.
Signature signatureOf(const JointData& data, const Stage& stage, const std::vector<Cause>& causes);

}  // namespace nao::validation
