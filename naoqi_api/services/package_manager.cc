#include "naoqi_api/services/package_manager.h"

#include <map>
#include <string>
#include <vector>

#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

using Package = std::map<std::string, Value>;

// What stands before the first / of a behavior's name.
std::string packageOf(const std::string& behavior) {
  return behavior.substr(0, behavior.find('/'));
}

class PackageManager {
 public:
  explicit PackageManager(std::shared_ptr<BehaviorRunner> behaviors)
      : behaviors_(std::move(behaviors)) {}

  bool has(const std::string& name) const { return contents().count(name) > 0; }

  Package get(const std::string& name) const {
    const auto all = contents();
    const auto found = all.find(name);
    if (found == all.end()) throw CallError("there is no package " + name);
    return tell(name, found->second);
  }

  std::vector<Package> list() const {
    std::vector<Package> packages;
    for (const auto& [name, behaviors] : contents()) packages.push_back(tell(name, behaviors));
    return packages;
  }

  // Ends and forgets the behaviors; their files stay.
  void remove(const std::string& name) {
    const auto all = contents();
    const auto found = all.find(name);
    if (found == all.end()) throw CallError("there is no package " + name);
    for (const std::string& behavior : found->second) behaviors_->remove(behavior);
  }

 private:
  std::map<std::string, std::vector<std::string>> contents() const {
    std::map<std::string, std::vector<std::string>> found;
    for (const std::string& name : behaviors_->library().names()) {
      found[packageOf(name)].push_back(name);
    }
    return found;
  }

  static Package tell(const std::string& name, const std::vector<std::string>& behaviors) {
    return {{"uuid", name}, {"path", name}, {"behaviors", rpc::toValue(behaviors)}};
  }

  std::shared_ptr<BehaviorRunner> behaviors_;
};

}  // namespace

ServicePointer makePackageManager(const std::shared_ptr<BehaviorRunner>& behaviors) {
  auto service = makeModule("PackageManager", "Packages are folders of behaviors.");
  const auto manager = std::make_shared<PackageManager>(behaviors);
  const Argument package{"package", "Its name."};
  for (const char* name : {"getPackages", "packages", "packages2"}) {
    addFunction(
        *service, name, [manager] { return manager->list(); },
        "{uuid, path, behaviors} of every package.");
  }
  for (const char* name : {"getPackage", "package1", "package2"}) {
    addFunction(
        *service, name, [manager](const std::string& of) { return manager->get(of); },
        "{uuid, path, behaviors} of a package.", package);
  }
  addFunction(
      *service, "hasPackage", [manager](const std::string& of) { return manager->has(of); },
      "Whether there is a package of this name.", package);
  for (const char* name : {"getPackageIcon", "packageIcon"}) {
    addFunction(
        *service, name,
        [manager](const std::string& of) {
          manager->get(of);
          return Value::raw({});
        },
        "Nothing: packages here have no pictures.", package);
  }
  for (const char* name : {"remove", "removePkg"}) {
    addFunction(
        *service, name, [manager](const std::string& of) { manager->remove(of); },
        "Ends and forgets the behaviors of a package until the next start; files stay.", package);
  }
  return service;
}

}  // namespace nao::services
