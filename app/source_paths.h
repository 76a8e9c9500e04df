#pragma once

#include <string>

namespace nao::app {

/// `path` as given if it exists or is absolute, else below the source tree the program was built
/// from, so that the shipped robots and worlds are found from any folder.
std::string findSourceFile(const std::string& path);

}  // namespace nao::app
