#pragma once

#include <string>
#include <vector>

namespace nao::motion {

/// What the manifest.xml of a package (NaoQi 2.x) tells of one of its behaviors:
///
///   <package><contents><behaviorContent path="wave"><nature>interactive</nature>
///   <tags><tag lang="en_US">hello</tag></tags></behaviorContent></contents></package>
struct BehaviorContent {
  std::string path;    // of its folder below the package
  std::string nature;  // "interactive", "solitary", "no nature" ...; empty if not told
  std::vector<std::string> tags;
};

/// @throws InputError with source and line if the text is no such manifest.
std::vector<BehaviorContent> readManifest(const std::string& text, const std::string& source);

}  // namespace nao::motion
