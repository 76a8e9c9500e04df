#pragma once

#include <stdexcept>
#include <string>

namespace nao {

/// Thrown when something outside the code is wrong: a robot file, a parameter, a command line.
/// One sentence that names the place (file and line, or option) and what was expected.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] void abortCheck(const char* condition, const char* file, int line);

}  // namespace nao

/// Aborts unless `condition`: a mistake in this program, always armed, never caught.
#define NAO_CHECK(condition) \
  ((condition) ? void() : ::nao::abortCheck(#condition, __FILE__, __LINE__))
