#include "naoqi_api/services/al_frame_manager.h"

#include <map>
#include <vector>

#include "core/check.h"
#include "motion/timeline/xar.h"
#include "naoqi_api/al_module.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

constexpr std::size_t kMostBehaviors = 256;  // free: what a client may leave behind

class AlFrameManager {
 public:
  AlFrameManager(RobotLink& link, std::function<void(const std::string&)> warn)
      : link_(link), warn_(std::move(warn)) {}
  void declare(rpc::Service& service);

 private:
  struct Behavior {
    std::string path;
    motion::Timeline timeline;
    motion::RequestId request = 0;  // while it runs
    bool played = false;
    std::vector<rpc::Pending<void>> waiting;  // for its end
  };

  std::string newBehavior(const std::string& path, const std::string& xml);
  std::string newBehaviorFromFile(const std::string& file, const std::string& name);
  void playBehavior(const std::string& id);
  rpc::Pending<void> completeBehavior(const std::string& id);
  bool isBehaviorRunning(const std::string& id);
  float getMotionLength(const std::string& id);
  std::string getBehaviorPath(const std::string& id);
  void exitBehavior(const std::string& id);
  void deleteBehavior(const std::string& id);
  void cleanBehaviors();
  std::vector<std::string> behaviors();

  Behavior& find(const std::string& id);
  void ended(const std::string& id, motion::RequestId request, const std::string& failure);

  RobotLink& link_;
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
            rpc::Argument{"xmlFile", "The text of a .xar file."});
  addMethod(service, "newBehaviorFromFile", this, &Self::newBehaviorFromFile,
            "Not simulated: the robot has no files of the client's.",
            rpc::Argument{"xmlFilePath", "A file on the robot."},
            rpc::Argument{"behName", "Name of the behavior."});
  addMethod(service, "playBehavior", this, &Self::playBehavior,
            "Starts a behavior and does not wait.", id);
  addMethod(service, "completeBehavior", this, &Self::completeBehavior,
            "Waits until a behavior has ended; starts it if it never was.", id);
  addMethod(service, "isBehaviorRunning", this, &Self::isBehaviorRunning,
            "Whether a behavior plays.", id);
  addMethod(service, "getMotionLength", this, &Self::getMotionLength,
            "How long the motion of a behavior takes [s].", id);
  addMethod(service, "getBehaviorPath", this, &Self::getBehaviorPath,
            "What newBehavior was told to call it.", id);
  addMethod(service, "exitBehavior", this, &Self::exitBehavior, "Ends a behavior.", id);
  addMethod(service, "deleteBehavior", this, &Self::deleteBehavior,
            "Ends a behavior and forgets it.", id);
  addMethod(service, "cleanBehaviors", this, &Self::cleanBehaviors,
            "Ends all behaviors and forgets them.");
  addMethod(service, "behaviors", this, &Self::behaviors, "The ids of all behaviors.");
}

std::string AlFrameManager::newBehavior(const std::string& path, const std::string& xml) {
  if (behaviors_.size() == kMostBehaviors) {
    throw rpc::CallError("too many behaviors: delete some first");
  }
  Behavior behavior;
  behavior.path = path;
  try {
    behavior.timeline = motion::readXar(xml, path.empty() ? "behavior" : path, link_.model());
  } catch (const InputError& error) {
    throw rpc::CallError(error.what());
  }
  if (warn_) {
    for (const std::string& sentence : behavior.timeline.warnings) warn_(sentence);
  }
  const std::string id = std::to_string(++last_id_);
  behaviors_.emplace(id, std::move(behavior));
  return id;
}

std::string AlFrameManager::newBehaviorFromFile(const std::string& /*file*/,
                                                const std::string& /*name*/) {
  throw rpc::CallError("not simulated: send the text of the file with newBehavior");
}

AlFrameManager::Behavior& AlFrameManager::find(const std::string& id) {
  const auto found = behaviors_.find(id);
  if (found == behaviors_.end()) throw rpc::CallError("unknown behavior: " + id);
  return found->second;
}

void AlFrameManager::playBehavior(const std::string& id) {
  Behavior& behavior = find(id);
  if (behavior.request != 0) return;
  motion::Interpolate request;
  request.curves = behavior.timeline.curves;
  request.smooth = false;
  const motion::RequestId posted = link_.post(std::move(request));
  behavior.request = posted;
  behavior.played = true;
  link_.outcomeOf(posted).whenDone([this, id, posted](const auto& outcome) {
    ended(id, posted, outcome.value ? outcome.value->reason : std::string());
  });
}

void AlFrameManager::ended(const std::string& id, motion::RequestId request,
                           const std::string& failure) {
  const auto found = behaviors_.find(id);
  if (found == behaviors_.end() || found->second.request != request) return;
  found->second.request = 0;
  std::vector<rpc::Pending<void>> waiting;
  waiting.swap(found->second.waiting);
  for (const auto& call : waiting) failure.empty() ? call.resolve() : call.fail(failure);
}

rpc::Pending<void> AlFrameManager::completeBehavior(const std::string& id) {
  if (!find(id).played) playBehavior(id);
  Behavior& behavior = find(id);
  rpc::Pending<void> done;
  if (behavior.request == 0) {
    done.resolve();
    return done;
  }
  done.onCancel([this, request = behavior.request] { link_.kill(request); });
  behavior.waiting.push_back(done);
  return done;
}

bool AlFrameManager::isBehaviorRunning(const std::string& id) { return find(id).request != 0; }

float AlFrameManager::getMotionLength(const std::string& id) {
  return static_cast<float>(find(id).timeline.length);
}

std::string AlFrameManager::getBehaviorPath(const std::string& id) { return find(id).path; }

void AlFrameManager::exitBehavior(const std::string& id) {
  const Behavior& behavior = find(id);
  if (behavior.request != 0) link_.post(motion::Kill{behavior.request});
}

void AlFrameManager::deleteBehavior(const std::string& id) {
  const motion::RequestId request = find(id).request;
  if (request != 0) {
    link_.kill(request);
    ended(id, request, {});
  }
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
                                                 std::function<void(const std::string&)> warn) {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("ALFrameManager", "Plays behaviors made with Choregraphe."));
  const auto manager = std::make_shared<AlFrameManager>(link, std::move(warn));
  manager->declare(*service);
  service->owning(manager);
  return service;
}

}  // namespace nao::services
