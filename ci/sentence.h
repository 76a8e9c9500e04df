#pragma once

#include <string>

#include "core/sim_time.h"

namespace nao::ci {

/// Numbers as a report's sentences give them.
std::string shown(double number);        // "0.512": four digits
std::string shown(Duration time);        // "1.25 s"
std::string shownDegrees(double angle);  // [rad] "12.3 degrees"

}  // namespace nao::ci
