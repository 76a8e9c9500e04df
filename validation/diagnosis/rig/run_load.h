#pragma once

#include <optional>

#include "core/robot_model.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// A run's known weight as an effect of the model; nothing if it hangs on a fixed torso, where
/// nothing feels it. @throws InputError if the model has no such link, or for a weight on a torso
/// that is free, which no effect describes.
std::optional<EffectSetting> effectOf(const LogLoad& load, const RobotModel& model);

}  // namespace nao::validation
