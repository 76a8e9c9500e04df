#pragma once

#include "core/frames.h"
#include "walk_engine/tuning.h"

namespace nao::walk {

/// Where the swinging sole is, flat: from `from` to `to`, both on the floor, `progress` in [0, 1],
/// `height` [m] at the middle. At rest at both ends; it comes down a little after it has arrived. z
/// is the height over the floor.
Pose calcSwing(const Pose2& from, const Pose2& to, double progress, double height,
               const Tuning& tuning);

/// How far along its way the swinging sole is, 0 to 1. A cosine: of the smooth ways the one with
/// the smallest peak of acceleration, which throws the body about least.
double calcSwingPart(double progress, const Tuning& tuning);

/// A flat pose on the floor.
Pose onFloor(const Pose2& place);

}  // namespace nao::walk
