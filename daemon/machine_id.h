#pragma once

#include <string>

namespace nao::daemon {

/// This machine's uuid as text, always the same: clients compare it to tell whether a service is
/// on their own machine. Derived from the system's, so that nothing needs to be stored.
std::string machineId();

}  // namespace nao::daemon
