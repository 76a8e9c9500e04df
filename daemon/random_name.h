#pragma once

#include <string>

namespace nao::daemon {

/// 32 hexadecimal digits that nobody can guess.
std::string makeRandomName();

}  // namespace nao::daemon
