#pragma once

#include <string>
#include <vector>

namespace nao::app {

/// Becomes `program`, which stands beside this one, with these arguments. Returns never.
/// @throws InputError if it is not built: hidden effects live in the tests alone. `what` says what
/// was asked for.
[[noreturn]] void handOver(const std::string& program, const std::vector<std::string>& arguments,
                           const std::string& what);

}  // namespace nao::app
