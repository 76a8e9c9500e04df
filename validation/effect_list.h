#pragma once

#include <string>

namespace nao::validation {

/// Every effect of the catalogue with what it does and its parameters: unit, nominal value, the one
/// at which it does nothing, bounds, and the smallest deviation that matters.
std::string listEffectsAsText();
/// The same as one JSON object, by name.
std::string listEffectsAsJson();

}  // namespace nao::validation
