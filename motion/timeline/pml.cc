#include "motion/timeline/pml.h"

#include "core/check.h"
#include "motion/timeline/xar_element.h"

namespace nao::motion {

std::filesystem::path behaviorOfPackage(const std::string& text, const std::string& source) {
  tinyxml2::XMLDocument document;
  parseXml(document, text, source);  // mended or not: what counts is the one path in it
  const tinyxml2::XMLElement* root = document.FirstChildElement("Package");
  if (root == nullptr) throw InputError(source + ":1: expected a <Package>");
  const XarElement package(root, &source);
  const XarElement list = package.child("BehaviorDescriptions");
  std::vector<std::filesystem::path> found;
  std::string names;
  for (const XarElement& behavior : list.children("BehaviorDescription")) {
    found.push_back(std::filesystem::path(behavior.text("src")) /
                    behavior.text("xar", "behavior.xar"));
    names += " " + found.back().string();
  }
  if (found.empty()) package.fail("this package has no behavior");
  if (found.size() > 1) package.fail("this package has several behaviors; name one of" + names);
  return found.front();
}

}  // namespace nao::motion
