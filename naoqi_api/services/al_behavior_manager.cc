#include "naoqi_api/services/al_behavior_manager.h"

#include <algorithm>
#include <string>
#include <vector>

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using Names = std::vector<std::string>;

class AlBehaviorManager {
 public:
  explicit AlBehaviorManager(std::shared_ptr<BehaviorRunner> runner) : runner_(std::move(runner)) {}
  void declare(rpc::Service& service);

 private:
  void declareLists(rpc::Service& service);
  void declareRuns(rpc::Service& service);
  void declareDefaults(rpc::Service& service);
  void declareInstallation(rpc::Service& service);

  Names installed() { return runner_->library().names(); }
  Names running() { return runner_->running(); }
  Names loaded() { return runner_->loaded(); }
  Names none() { return {}; }
  Names tags() { return runner_->library().tags(); }
  Names byTag(const std::string& tag) { return runner_->library().namesByTag(tag); }
  Names tagsOf(const std::string& name) {
    return runner_->library().at(runner_->fullName(name)).tags;
  }
  Names defaults() { return defaults_; }
  std::string getBehaviorNature(const std::string& name);
  std::string resolveBehaviorName(const std::string& name) { return runner_->fullName(name); }
  bool isInstalled(const std::string& name) { return !runner_->library().resolve(name).empty(); }
  bool isLoaded(const std::string& name) { return runner_->isLoaded(name); }
  bool isRunning(const std::string& name) { return runner_->isRunning(name); }

  rpc::Pending<void> runBehavior(const std::string& name);
  void startBehavior(const std::string& name) { runner_->load(name).start(); }
  rpc::Pending<void> stopBehavior(const std::string& name);
  rpc::Pending<void> stopAllBehaviors();
  bool preloadBehavior(const std::string& name);

  bool install(const std::string& path);
  bool installAs(const std::string& path, const std::string& name, bool overwrite);
  bool remove(const std::string& name);

  void addDefault(const std::string& name);
  void removeDefault(const std::string& name);
  void playDefaults();

  std::shared_ptr<BehaviorRunner> runner_;
  Names defaults_;
};

const rpc::Argument kName{"behavior", "Name of an installed behavior, for instance hello."};

void AlBehaviorManager::declare(rpc::Service& service) {
  declareLists(service);
  declareRuns(service);
  declareDefaults(service);
  declareInstallation(service);
}

void AlBehaviorManager::declareLists(rpc::Service& service) {
  using Self = AlBehaviorManager;
  for (const char* name : {"getInstalledBehaviors", "getBehaviorNames", "getUserBehaviorNames"}) {
    addMethod(service, name, this, &Self::installed, "The behaviors that are installed.");
  }
  addMethod(service, "getSystemBehaviorNames", this, &Self::none,
            "None: no behavior comes with the simulated robot's system.");
  addMethod(service, "getRunningBehaviors", this, &Self::running, "The behaviors that run.");
  addMethod(service, "getLoadedBehaviors", this, &Self::loaded, "The behaviors that were read.");
  addMethod(service, "getTagList", this, &Self::tags,
            "The tags that the manifests of the installed packages give their behaviors.");
  addMethod(service, "getBehaviorsByTag", this, &Self::byTag, "The behaviors with a tag.",
            rpc::Argument{"tag", "A tag."});
  addMethod(service, "getBehaviorTags", this, &Self::tagsOf, "The tags of a behavior.", kName);
  addMethod(service, "getBehaviorNature", this, &Self::getBehaviorNature,
            "What its package's manifest says, else 'interactive'.", kName);
  addMethod(service, "resolveBehaviorName", this, &Self::resolveBehaviorName,
            "The full name of a behavior.", kName);
  for (const char* name : {"isBehaviorInstalled", "isBehaviorPresent"}) {
    addMethod(service, name, this, &Self::isInstalled, "Whether a behavior is installed.", kName);
  }
  addMethod(service, "isBehaviorLoaded", this, &Self::isLoaded, "Whether a behavior was read.",
            kName);
  addMethod(service, "isBehaviorRunning", this, &Self::isRunning, "Whether a behavior runs.",
            kName);
}

void AlBehaviorManager::declareRuns(rpc::Service& service) {
  using Self = AlBehaviorManager;
  addMethod(service, "runBehavior", this, &Self::runBehavior,
            "Runs a behavior and waits for its end.", kName);
  addMethod(service, "startBehavior", this, &Self::startBehavior,
            "Starts a behavior and does not wait.", kName);
  addMethod(service, "stopBehavior", this, &Self::stopBehavior,
            "Ends a behavior; waits until its motion has ended.", kName);
  addMethod(service, "stopAllBehaviors", this, &Self::stopAllBehaviors,
            "Ends all behaviors; waits until their motions have ended.");
  addMethod(service, "preloadBehavior", this, &Self::preloadBehavior,
            "Reads a behavior, so that it starts at once later.", kName);
}

void AlBehaviorManager::declareDefaults(rpc::Service& service) {
  using Self = AlBehaviorManager;
  addMethod(service, "addDefaultBehavior", this, &Self::addDefault,
            "Makes a behavior one of those that playDefaultProject starts.", kName);
  addMethod(service, "removeDefaultBehavior", this, &Self::removeDefault,
            "Takes a behavior out of those that playDefaultProject starts.", kName);
  addMethod(service, "getDefaultBehaviors", this, &Self::defaults,
            "The behaviors that playDefaultProject starts.");
  addMethod(service, "playDefaultProject", this, &Self::playDefaults,
            "Starts the default behaviors.");
}

void AlBehaviorManager::declareInstallation(rpc::Service& service) {
  using Self = AlBehaviorManager;
  const rpc::Argument path{"localPath", "A file of the robot."};
  addMethod(service, "installBehavior", this, &Self::install,
            "Fails: what is installed is told when the simulator is started.", path);
  addMethod(service, "installBehavior", this, &Self::installAs,
            "Fails: what is installed is told when the simulator is started.",
            rpc::Argument{"absolutePath", "A file."}, path,
            rpc::Argument{"overwrite", "Whether to replace one of that name."});
  addMethod(service, "removeBehavior", this, &Self::remove,
            "Ends and forgets a behavior until the next start; its file stays.", kName);
}

std::string AlBehaviorManager::getBehaviorNature(const std::string& name) {
  return runner_->library().at(runner_->fullName(name)).nature;
}

rpc::Pending<void> AlBehaviorManager::runBehavior(const std::string& name) {
  Performance& playback = runner_->load(name);
  playback.start();
  return playback.untilEnd();
}

rpc::Pending<void> AlBehaviorManager::stopBehavior(const std::string& name) {
  return runner_->load(name).stop();
}

rpc::Pending<void> AlBehaviorManager::stopAllBehaviors() {
  const auto running = runner_->running();
  const auto left = std::make_shared<std::size_t>(running.size());
  rpc::Pending<void> stopped;
  if (running.empty()) stopped.resolve();
  for (const std::string& name : running) {
    stopBehavior(name).whenDone([left, stopped](const auto& /*outcome*/) {
      if (--*left == 0) stopped.resolve();
    });
  }
  return stopped;
}

bool AlBehaviorManager::preloadBehavior(const std::string& name) {
  if (runner_->library().resolve(name).empty()) return false;
  runner_->load(name);
  return true;
}

bool AlBehaviorManager::install(const std::string& path) {
  throw rpc::CallError("\"" + path.substr(0, 200) +
                       "\" can not be installed over the wire: start the simulator with "
                       "--behaviors FOLDER, or send the text with ALFrameManager.newBehavior");
}

bool AlBehaviorManager::installAs(const std::string& path, const std::string& /*name*/,
                                  bool /*overwrite*/) {
  return install(path);
}

bool AlBehaviorManager::remove(const std::string& name) {
  const std::string full_name = runner_->library().resolve(name);
  if (!runner_->remove(name)) return false;
  defaults_.erase(std::remove(defaults_.begin(), defaults_.end(), full_name), defaults_.end());
  return true;
}

void AlBehaviorManager::addDefault(const std::string& name) {
  const std::string full_name = runner_->fullName(name);
  if (std::find(defaults_.begin(), defaults_.end(), full_name) == defaults_.end()) {
    defaults_.push_back(full_name);
  }
}

void AlBehaviorManager::removeDefault(const std::string& name) {
  const std::string full_name = runner_->fullName(name);
  defaults_.erase(std::remove(defaults_.begin(), defaults_.end(), full_name), defaults_.end());
}

void AlBehaviorManager::playDefaults() {
  for (const std::string& name : defaults_) startBehavior(name);
}

}  // namespace

std::shared_ptr<rpc::Service> makeAlBehaviorManager(std::shared_ptr<BehaviorRunner> runner) {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("ALBehaviorManager", "Runs the behaviors that are installed."));
  const auto manager = std::make_shared<AlBehaviorManager>(std::move(runner));
  manager->declare(*service);
  service->owning(manager);
  return service;
}

}  // namespace nao::services
