#pragma once

#include <map>
#include <string>

namespace nao::services {

/// NAOqi 1.x' names ("Belly", "Back" ...) for the families of postures.
const std::map<std::string, std::string>& poseNames();

/// That of one family; "Unknown" for what 1.x had no name for.
std::string poseOf(const std::string& family);

}  // namespace nao::services
