#pragma once

#include <string>

#include "runtime/recording.h"

namespace nao::validation {

/// Changes what a run begins with, by one of
///   ROBOT.effects.EFFECT.PARAMETER=NUMBER   the effect is added if the robot has none of it
///   ROBOT.effects.EFFECT=NUMBER             of an effect with one parameter
///   ROBOT.effects.EFFECT=off
///   world.friction=NUMBER                   of the ground
///   seed=NUMBER
/// ROBOT is a robot's name, or `robot` for all. @throws InputError that says what there is.
void changeStart(const std::string& setting, runtime::RunStart& start);

}  // namespace nao::validation
