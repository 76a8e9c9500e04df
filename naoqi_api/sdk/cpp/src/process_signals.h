#pragma once

#include <string>
#include <vector>

namespace nao::client {

/// Calls what a local module has connected to the end of a cycle, then what it has connected to
/// the beginning of the next. Returns the texts of the exceptions that came out.
std::vector<std::string> runCycle();

}  // namespace nao::client
