#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace nao::services {

/// What is known of an installed behavior.
struct InstalledBehavior {
  std::filesystem::path file;          // or folder
  std::string nature = "interactive";  // of those whose package tells no other
  std::vector<std::string> tags;       // from the package's manifest.xml
};

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

  /// A behavior by its full name.
  const InstalledBehavior& at(const std::string& full_name) const;

  std::vector<std::string> names() const;  // in order of the alphabet
  std::vector<std::string> tags() const;   // of all of them, in order of the alphabet
  std::vector<std::string> namesByTag(const std::string& tag) const;

  /// Forgets a behavior by its full name; its file stays.
  void remove(const std::string& full_name) { behaviors_.erase(full_name); }

 private:
  void add(const std::string& name, const std::filesystem::path& file);
  void addTree(const std::filesystem::path& folder, const std::string& prefix, int depth);
  void readManifest(const std::filesystem::path& folder, const std::string& prefix);

  std::map<std::string, InstalledBehavior> behaviors_;
};

}  // namespace nao::services
