#pragma once

#include <string>
#include <vector>

namespace nao::client {

/// Takes what a module has written through its pointers to ALMemory, and brings them up to date; at
/// the beginning of a cycle. Returns the texts of the errors, and nothing is done without pointers.
std::vector<std::string> refreshMemoryPointers();

}  // namespace nao::client
