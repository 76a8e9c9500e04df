#pragma once

#include <string_view>

#include "sim/effects/catalogue.h"

namespace nao::sim {

/// What the catalogue says of a number that the program itself names; aborts if there is none.
const Parameter& parameterOf(const EffectCatalogue& catalogue, std::string_view effect,
                             std::string_view parameter);

}  // namespace nao::sim
