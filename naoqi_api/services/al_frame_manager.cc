#include "naoqi_api/services/al_frame_manager.h"

#include <cmath>
#include <map>
#include <vector>

#include "core/check.h"
#include "motion/timeline/motion_file.h"
#include "motion/timeline/xar.h"
#include "naoqi_api/al_module.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/playback.h"

namespace nao::services {
namespace {

constexpr std::size_t kMostBehaviors = 256;  // free: what a client may leave behind

class AlFrameManager {
 public:
  AlFrameManager(RobotLink& link, std::shared_ptr<const BehaviorLibrary> library,
                 std::function<void(const std::string&)> warn)
      : link_(link), library_(std::move(library)), warn_(std::move(warn)) {}
  void declare(rpc::Service& service);

 private:
  struct Behavior {
    std::string path;
    std::shared_ptr<Playback> playback;
  };

  std::string newBehavior(const std::string& path, const std::string& xml);
  std::string newBehaviorFromFile(const std::string& file, const std::string& name);
  std::string add(const std::string& path, motion::Timeline timeline);
  void playBehavior(const std::string& id);
  rpc::Pending<void> completeBehavior(const std::string& id);
  bool isBehaviorRunning(const std::string& id);
  float getMotionLength(const std::string& id);
  int getTimelineFps(const std::string& id);
  std::string getBehaviorPath(const std::string& id);
  void exitBehavior(const std::string& id);
  void deleteBehavior(const std::string& id);
  void cleanBehaviors();
  std::vector<std::string> behaviors();

  Behavior& find(const std::string& id);

  RobotLink& link_;
  std::shared_ptr<const BehaviorLibrary> library_;
  std::function<void(const std::string&)> warn_;
  std::map<std::string, Behavior> behaviors_;
  int last_id_ = 0;
};

void AlFrameManager::declare(rpc::Service& service) {
  using Self = AlFrameManager;
  const rpc::Argument id{"id", "What newBehavior returned."};
  addMethod(service, "newBehavior", this, &Self::newBehavior,
            "Reads a behavior and returns its id.",
            rpc::Argument{"path", "What to call it in messages."},
            rpc::Argument{"xmlFile",
                          "The text of a .xar file, or of a motion file of another\n"
                          "kind, which `path` then ends in."});
  addMethod(service, "newBehaviorFromFile", this, &Self::newBehaviorFromFile,
            "Reads an installed behavior and returns its id.",
            rpc::Argument{"xmlFilePath", "Name of an installed behavior."},
            rpc::Argument{"behName", "What to call it in messages."});
  for (const char* name : {"playBehavior", "playTimeline"}) {
    addMethod(service, name, this, &Self::playBehavior, "Starts a behavior and does not wait.", id);
  }
  addMethod(service, "completeBehavior", this, &Self::completeBehavior,
            "Waits until a behavior has ended; starts it if it never was.", id);
  addMethod(service, "isBehaviorRunning", this, &Self::isBehaviorRunning,
            "Whether a behavior plays.", id);
  addMethod(service, "getMotionLength", this, &Self::getMotionLength,
            "How long the motion of a behavior takes [s].", id);
  addMethod(service, "getTimelineFps", this, &Self::getTimelineFps,
            "The frames per second of a behavior's first timeline.", id);
  addMethod(service, "getBehaviorPath", this, &Self::getBehaviorPath,
            "What newBehavior was told to call it.", id);
  for (const char* name : {"exitBehavior", "stopTimeline"}) {
    addMethod(service, name, this, &Self::exitBehavior, "Ends a behavior.", id);
  }
  addMethod(service, "deleteBehavior", this, &Self::deleteBehavior,
            "Ends a behavior and forgets it.", id);
  addMethod(service, "cleanBehaviors", this, &Self::cleanBehaviors,
            "Ends all behaviors and forgets them.");
  addMethod(service, "behaviors", this, &Self::behaviors, "The ids of all behaviors.");
}

// XML is a behavior unless it says that it is an animation; the rest tells by its ending.
motion::Timeline readText(const std::string& text, const std::string& name,
                          const RobotModel& model) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const bool xml = begin != std::string::npos && text[begin] == '<';
  const bool animation = xml && text.find("<Animation") != std::string::npos;
  if (xml && !animation) return motion::readXar(text, name, model);
  return motion::readMotion(text, name, model);
}

std::string AlFrameManager::newBehavior(const std::string& path, const std::string& xml) {
  try {
    return add(path, readText(xml, path.empty() ? "behavior" : path, link_.model()));
  } catch (const InputError& error) {
    throw rpc::CallError(error.what());
  }
}

std::string AlFrameManager::newBehaviorFromFile(const std::string& file, const std::string& name) {
  const std::string installed = library_ ? library_->resolve(file) : std::string();
  if (installed.empty()) {
    throw rpc::CallError("no installed behavior is called " + file.substr(0, 200) +
                         ": send the text of the file with newBehavior");
  }
  try {
    return add(name.empty() ? installed : name,
               motion::loadMotion(library_->at(installed).file, link_.model()));
  } catch (const InputError& error) {
    throw rpc::CallError(error.what());
  }
}

std::string AlFrameManager::add(const std::string& path, motion::Timeline timeline) {
  if (behaviors_.size() == kMostBehaviors) {
    throw rpc::CallError("too many behaviors: delete some first");
  }
  if (warn_) {
    for (const std::string& sentence : timeline.broken) warn_(sentence);
    for (const std::string& sentence : timeline.warnings) warn_(sentence);
    for (const motion::KeyFault& fault : timeline.key_faults) warn_(fault.sentence);
  }
  const std::string id = std::to_string(++last_id_);
  behaviors_[id] = {path, std::make_shared<Playback>(link_, std::move(timeline))};
  return id;
}

AlFrameManager::Behavior& AlFrameManager::find(const std::string& id) {
  const auto found = behaviors_.find(id);
  if (found == behaviors_.end()) throw rpc::CallError("unknown behavior: " + id);
  return found->second;
}

void AlFrameManager::playBehavior(const std::string& id) { find(id).playback->start(); }

rpc::Pending<void> AlFrameManager::completeBehavior(const std::string& id) {
  Playback& playback = *find(id).playback;
  if (!playback.wasStarted()) playback.start();
  return playback.untilEnd();
}

bool AlFrameManager::isBehaviorRunning(const std::string& id) {
  return find(id).playback->isRunning();
}

float AlFrameManager::getMotionLength(const std::string& id) {
  return static_cast<float>(find(id).playback->timeline().length);
}

int AlFrameManager::getTimelineFps(const std::string& id) {
  const auto& clocks = find(id).playback->timeline().clocks;
  if (clocks.empty()) throw rpc::CallError("this behavior does not count frames");
  return static_cast<int>(std::lround(clocks.front().fps));
}

std::string AlFrameManager::getBehaviorPath(const std::string& id) { return find(id).path; }

void AlFrameManager::exitBehavior(const std::string& id) { find(id).playback->stop(); }

void AlFrameManager::deleteBehavior(const std::string& id) {
  find(id).playback->drop();
  behaviors_.erase(id);
}

void AlFrameManager::cleanBehaviors() {
  for (const std::string& id : behaviors()) deleteBehavior(id);
}

std::vector<std::string> AlFrameManager::behaviors() {
  std::vector<std::string> ids;
  for (const auto& [id, behavior] : behaviors_) ids.push_back(id);
  return ids;
}

}  // namespace

std::shared_ptr<rpc::Service> makeAlFrameManager(RobotLink& link,
                                                 std::function<void(const std::string&)> warn,
                                                 std::shared_ptr<const BehaviorLibrary> library) {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("ALFrameManager", "Plays behaviors made with Choregraphe."));
  const auto manager = std::make_shared<AlFrameManager>(link, std::move(library), std::move(warn));
  manager->declare(*service);
  service->owning(manager);
  return service;
}

}  // namespace nao::services
