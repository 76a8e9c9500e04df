#include "motion/timeline/manifest.h"

#include "core/check.h"
#include "motion/timeline/xar_element.h"

namespace nao::motion {

std::vector<BehaviorContent> readManifest(const std::string& text, const std::string& source) {
  tinyxml2::XMLDocument document;
  parseXml(document, text, source);
  const tinyxml2::XMLElement* root = document.FirstChildElement("package");
  if (root == nullptr)
    throw InputError(source + ":1: expected a <package>, the root of a manifest");
  std::vector<BehaviorContent> found;
  const XarElement contents = XarElement(root, &source).child("contents");
  for (const XarElement& element : contents.children("behaviorContent")) {
    BehaviorContent behavior;
    behavior.path = element.text("path");
    behavior.nature = element.text("nature");
    for (const XarElement& tag : element.child("tags").children("tag")) {
      if (!tag.ownText().empty()) behavior.tags.push_back(tag.ownText());
    }
    found.push_back(std::move(behavior));
  }
  return found;
}

}  // namespace nao::motion
