#pragma once

#include <filesystem>
#include <string>

namespace nao::motion {

/// Where the behavior of a package stands, seen from the package's .pml file.
/// @throws InputError with source and line if the text is no package or has not exactly one
/// behavior.
std::filesystem::path behaviorOfPackage(const std::string& text, const std::string& source);

}  // namespace nao::motion
