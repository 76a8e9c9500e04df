#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/robot_model.h"

namespace nao::validation {

/// A name that two lists of effects in one motion share only if they are the same.
std::string keyOf(std::size_t motion, const std::vector<EffectSetting>& effects);

}  // namespace nao::validation
