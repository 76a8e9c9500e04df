#include "naoqi_api/services/behavior_library.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "core/check.h"
#include "core/files.h"
#include "motion/timeline/manifest.h"
#include "motion/timeline/motion_file.h"

namespace nao::services {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 12;  // free choice: folders in folders; ends a circle of links
constexpr const char* kPrefixes[] = {"User/", "System/", "animations/",
                                     ".lastUploadedChoregrapheBehavior/"};
constexpr const char* kBehavior = "behavior.xar";
constexpr const char* kManifest = "manifest.xml";

std::string joined(const std::string& prefix, const fs::path& name) {
  return prefix.empty() ? name.string() : prefix + "/" + name.string();
}

bool endsWithPart(const std::string& name, const std::string& part) {
  if (name.size() <= part.size() + 1) return false;
  const std::size_t at = name.size() - part.size();
  return name[at - 1] == '/' && name.compare(at, part.size(), part) == 0;
}

std::string withoutPrefix(const std::string& name) {
  for (const std::string prefix : kPrefixes) {
    if (name.rfind(prefix, 0) == 0) return name.substr(prefix.size());
  }
  return name;
}

}  // namespace

void BehaviorLibrary::addFolder(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw InputError(folder.string() + ": expected a folder of behaviors");
  }
  if (fs::exists(folder / kBehavior)) {
    add(fs::canonical(folder).filename().string(), folder);
  } else {
    addTree(folder, "", 0);
  }
}

void BehaviorLibrary::addTree(const fs::path& folder, const std::string& prefix, int depth) {
  if (depth > kDeepest) return;
  std::error_code unreadable;  // what can not be read is not installed
  for (const fs::path& path : listReadable(folder)) {
    if (!fs::is_directory(path, unreadable)) {
      if (motion::isMotionFile(path)) add(joined(prefix, path.stem()), path);
    } else if (fs::exists(path / kBehavior, unreadable)) {
      add(joined(prefix, path.filename()), path);
    } else {
      addTree(path, joined(prefix, path.filename()), depth + 1);
    }
  }
  readManifest(folder, prefix);
}

void BehaviorLibrary::add(const std::string& name, const fs::path& file) {
  behaviors_[name] = InstalledBehavior();
  behaviors_[name].file = file;
}

// What a package says of its behaviors; a manifest that can not be read says nothing.
void BehaviorLibrary::readManifest(const fs::path& folder, const std::string& prefix) {
  std::ifstream in(folder / kManifest, std::ios::binary);
  if (!in) return;
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::vector<motion::BehaviorContent> contents;
  try {
    contents = motion::readManifest(text, (folder / kManifest).string());
  } catch (const InputError&) {
    return;
  }
  for (motion::BehaviorContent& content : contents) {
    const auto found = behaviors_.find(joined(prefix, content.path));
    if (found == behaviors_.end()) continue;
    if (!content.nature.empty()) found->second.nature = content.nature;
    found->second.tags = std::move(content.tags);
  }
}

std::string BehaviorLibrary::resolve(const std::string& name) const {
  const std::string bare = withoutPrefix(name);
  for (const std::string& candidate : {name, bare}) {
    if (behaviors_.count(candidate) > 0) return candidate;
  }
  std::vector<std::string> found;
  for (const auto& [known, behavior] : behaviors_) {
    const bool in_package = known.rfind(bare + "/", 0) == 0;
    if (!bare.empty() && (in_package || endsWithPart(known, bare))) found.push_back(known);
  }
  return found.size() == 1 ? found.front() : std::string();
}

const InstalledBehavior& BehaviorLibrary::at(const std::string& full_name) const {
  const auto found = behaviors_.find(full_name);
  NAO_CHECK(found != behaviors_.end());
  return found->second;
}

std::vector<std::string> BehaviorLibrary::names() const {
  std::vector<std::string> names;
  for (const auto& [name, behavior] : behaviors_) names.push_back(name);
  return names;
}

std::vector<std::string> BehaviorLibrary::tags() const {
  std::set<std::string> tags;
  for (const auto& [name, behavior] : behaviors_) {
    tags.insert(behavior.tags.begin(), behavior.tags.end());
  }
  return {tags.begin(), tags.end()};
}

std::vector<std::string> BehaviorLibrary::namesByTag(const std::string& tag) const {
  std::vector<std::string> names;
  for (const auto& [name, behavior] : behaviors_) {
    const auto& tags = behavior.tags;
    if (std::find(tags.begin(), tags.end(), tag) != tags.end()) names.push_back(name);
  }
  return names;
}

}  // namespace nao::services
