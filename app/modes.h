#pragma once

#include <map>
#include <string>

#include "runtime/simulation.h"

namespace nao::app {

/// The words for --mode.
inline const std::map<std::string, sim::Mode> kModes{{"implicit", sim::Mode::Implicit},
                                                     {"rk4", sim::Mode::Rk4},
                                                     {"reference", sim::Mode::Reference}};

}  // namespace nao::app
