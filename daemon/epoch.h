#pragma once

#include <chrono>

namespace nao::daemon {

/// NaoQi's clock at the start of every world, so that runs repeat: 13 March 2011. Programs in
/// simulated time are shown the same.
constexpr std::chrono::seconds kEpoch{1300000000};

}  // namespace nao::daemon
