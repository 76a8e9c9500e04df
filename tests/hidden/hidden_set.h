#pragma once

#include <memory>

#include "core/robot_model.h"
#include "tests/hidden/hidden_case.h"
#include "validation/log/robot_log.h"

namespace nao::hidden {

/// A set with something hidden in it, and what.
struct HiddenSet {
  validation::LogSet set;
  Truth truth;
};

/// Records the set of a case from the whole robot, hung up, at 0.25 ms. The nominal robot is
/// `model`; undeclared differences in every joint, noise of the set's own level and the hidden
/// effects are drawn from the case's seed. Effects are scaled until what they change in the mean,
/// over the samples where they act, is as many SDs of the measured mean as wished; where that
/// cannot be, the truth says why and the set is empty.
HiddenSet makeHiddenSet(const HiddenCase& hidden, std::shared_ptr<const RobotModel> model);

/// The same; where the effects cannot be made as wished at the first joint, at the next of the
/// case's other places.
HiddenSet makeHiddenSetSomewhere(const HiddenCase& hidden,
                                 const std::shared_ptr<const RobotModel>& model);

/// The set of a case whose robot stands on its feet, which makeHiddenSet() leaves to it: recorded
/// at 0.25 ms from the whole robot with its own motion side.
HiddenSet makeFloorSet(const HiddenCase& hidden, const std::shared_ptr<const RobotModel>& model);

/// What makeHiddenSet() would hide, without recording the set.
Truth chooseHidden(const HiddenCase& hidden, std::shared_ptr<const RobotModel> model);

/// Robots that a maker calls the same: mass +-2 %, inertia +-5 %, friction +-10 %, gains +-2 % and
/// zeros +-0.1 degree in every joint.
void addUndeclaredDifferences(RobotModel& model, std::uint64_t seed);

/// Does to the data what `spoil` says, at its first joint, or first two.
void spoilData(validation::LogSet& set, Spoil spoil);

}  // namespace nao::hidden
