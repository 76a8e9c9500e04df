#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace nao::services {

/// The behaviors that are installed on a robot: motion files below some folders of the host, by
/// name. A folder with a behavior.xar is one behavior named after its path below the installed
/// folder ("dances/macarena"), any other motion file one named after its path without ending
/// ("kick"). Folders that are added later win. Read once; what comes into the folders later is not
/// seen.
class BehaviorLibrary {
 public:
  /// @throws InputError if `folder` is no folder.
  void addFolder(const std::filesystem::path& folder);

  /// The full name of what a client calls a behavior: the name itself; without a prefix "User/",
  /// "System/", "animations/" or ".lastUploadedChoregrapheBehavior/"; with a package or the folders
  /// before it left out, if only one behavior ends so. Empty if there is none.
  std::string resolve(const std::string& name) const;

  /// The file or folder of a behavior by its full name.
  const std::filesystem::path& fileOf(const std::string& full_name) const;

  std::vector<std::string> names() const;  // in order of the alphabet

 private:
  void addTree(const std::filesystem::path& folder, const std::string& prefix, int depth);

  std::map<std::string, std::filesystem::path> behaviors_;
};

}  // namespace nao::services
