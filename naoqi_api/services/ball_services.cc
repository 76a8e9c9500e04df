#include "naoqi_api/services/ball_services.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/ball_watch.h"
#include "naoqi_api/services/extractor.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/settings.h"

namespace nao::services {
namespace {

using rpc::Answer;
using rpc::Argument;
using rpc::CallError;
using rpc::Value;
using ServicePointer = std::shared_ptr<rpc::Service>;
using Watch = std::shared_ptr<BallWatch>;

ServicePointer makeModule(const std::string& name, const std::string& meaning) {
  return std::make_shared<rpc::Service>(rpc::alModule(name, meaning));
}

std::vector<float> asFloats(const Vec3& place) {
  return {static_cast<float>(place.x()), static_cast<float>(place.y()),
          static_cast<float>(place.z())};
}

ServicePointer makeDetection(const ServiceContext& context, const Watch& watch) {
  auto service = makeModule("ALRedBallDetection", "A red ball in the top camera's pictures.");
  const auto extractor = std::make_shared<Extractor>(context.store(), "ALRedBallDetection",
                                                     Extractor::Outputs{{"redBallDetected"}, {}});
  extractor->declare(*service);
  extractor->onWorking([watch](bool works) { watch->want("ALRedBallDetection", works); });
  service->owning(extractor);
  return service;
}

ServicePointer makeRedBallTracker(const Watch& watch) {
  auto service = makeModule("ALRedBallTracker", "Turns the head to a red ball.");
  addFunction(
      *service, "startTracker",
      [watch] {
        watch->want("ALRedBallTracker", true);
        watch->follow(true);
      },
      "The head follows the ball from now on.");
  addFunction(
      *service, "stopTracker",
      [watch] {
        watch->want("ALRedBallTracker", false);
        watch->follow(false);
      },
      "The head stays where it is.");
  addFunction(
      *service, "getPosition", [watch] { return asFloats(watch->position()); },
      "Where the ball was seen last, in the torso's frame [m]; zeros before.");
  addFunction(
      *service, "isNewData", [watch] { return watch->takeNews(); },
      "Whether the ball was seen since this was asked last.");
  addFunction(
      *service, "isActive", [watch] { return watch->isWanted("ALRedBallTracker"); },
      "Whether the tracker runs.");
  addFunction(
      *service, "setWholeBodyOn", [](bool) {}, "Is kept: the head alone follows.",
      Argument{"wholeBodyOn", "Ignored."})
      .answering(Answer::Simplified);
  return service;
}

/// What ALTracker was told.
struct Tracker {
  std::map<std::string, Value> targets;  // and their parameters
  std::string active;                    // that is tracked
};

void declareTargets(rpc::Service& service, const std::shared_ptr<Tracker>& tracker,
                    const Watch& watch) {
  constexpr std::size_t kMost = 64;
  const Argument target{"target", "RedBall; others are kept and never seen."};
  const auto add = [tracker, watch](const std::string& name, const Value& parameters) {
    if (tracker->targets.size() >= kMost) throw CallError("too many targets");
    tracker->targets[name] = parameters;
    const auto diameter = parameters.findNumber();
    if (name == "RedBall" && diameter && *diameter > 0) watch->setDiameter(*diameter);
  };
  const auto stop = [tracker, watch] {
    tracker->active.clear();
    watch->want("ALTracker", false);
    watch->follow(false);
  };
  const auto remove = [tracker, stop](const std::string& name) {
    tracker->targets.erase(name);
    if (tracker->active == name) stop();
  };
  const auto remove_all = [tracker, stop] {
    tracker->targets.clear();
    stop();
  };
  for (const char* name : {"registerTarget", "addTarget"}) {
    addFunction(service, name, add, "Makes a target known.", target,
                Argument{"params", "Of RedBall: its diameter [m]."});
  }
  for (const char* name : {"unregisterTarget", "removeTarget"}) {
    addFunction(service, name, remove, "Forgets a target.", target);
  }
  for (const char* name : {"unregisterAllTargets", "removeAllTargets"}) {
    addFunction(service, name, remove_all, "Forgets all targets.");
  }
  addFunction(
      service, "track",
      [tracker, watch](const std::string& name) {
        if (tracker->targets.count(name) == 0) throw CallError("unknown target: " + name);
        tracker->active = name;
        const bool is_ball = name == "RedBall";
        watch->want("ALTracker", is_ball);
        watch->follow(is_ball);
      },
      "The head follows a target from now on.", target);
  addFunction(service, "stopTracker", stop, "The head stays where it is.");
  const auto names = [tracker] {
    std::vector<std::string> list;
    for (const auto& [name, parameters] : tracker->targets) list.push_back(name);
    return list;
  };
  addFunction(service, "getRegisteredTargets", names, "The targets that are known.");
  addFunction(service, "getManagedTargets", names, "The targets that are known.");
  for (const char* name : {"getSupportedTargets", "getTargetNames"}) {
    addFunction(
        service, name,
        [] {
          return std::vector<std::string>{"RedBall",   "Face",   "LandMark",
                                          "LandMarks", "People", "Sound"};
        },
        "The kinds of targets; only RedBall is ever seen.");
  }
  addFunction(
      service, "getActiveTarget", [tracker] { return tracker->active; }, "What is tracked.");
}

void declareSight(rpc::Service& service, const std::shared_ptr<Tracker>& tracker,
                  const Watch& watch) {
  addFunction(
      service, "isActive", [tracker] { return !tracker->active.empty(); },
      "Whether something is tracked.");
  addFunction(
      service, "isTargetLost",
      [tracker, watch] { return !(tracker->active == "RedBall" && watch->sees()); },
      "Whether what is tracked is not seen.");
  addFunction(
      service, "isNewTargetDetected", [watch] { return watch->takeNews(); },
      "Whether the target was seen since this was asked last.");
  const auto place = [tracker, watch]() -> std::vector<float> {
    if (tracker->active != "RedBall" || !watch->sees()) return {};
    return asFloats(watch->position());
  };
  addFunction(service, "getTargetPosition", place,
              "Where the target is, in the torso's frame [m]; nothing if it is not seen.");
  addFunction(
      service, "getTargetPosition",
      [place](int frame) {
        if (frame != 0) throw CallError("not simulated: expected frame 0, the torso's");
        return place();
      },
      "Where the target is [m]; nothing if it is not seen.", Argument{"frame", "0: torso."});
  addFunction(
      service, "getAvailableModes",
      [] {
        return std::vector<std::string>{"Head", "BodyRotation", "WholeBody", "Move"};
      },
      "The modes; the head alone ever follows.");
}

void declareSwitches(rpc::Service& service) {
  const auto search = std::make_shared<bool>(false);
  addFunction(
      service, "toggleSearch", [search](bool on) { *search = on; }, "Is kept.",
      Argument{"search", "True: look for lost targets."})
      .answering(Answer::Simplified);
  addFunction(
      service, "isSearchEnabled", [search] { return *search; }, "What was kept.")
      .answering(Answer::Simplified);
  addFunction(
      service, "initialize", [] {}, "Has no effect.")
      .answering(Answer::Simplified);
}

ServicePointer makeTracker(const ServiceContext& context, const Watch& watch) {
  auto service = makeModule("ALTracker", "Turns the head to a red ball.");
  for (const char* event : {"ALTracker/ActiveTargetChanged", "ALTracker/TargetDetected",
                            "ALTracker/TargetLost", "ALTracker/TargetReached"}) {
    context.store().declareEvent(event, "ALTracker");
  }
  const auto tracker = std::make_shared<Tracker>();
  declareTargets(*service, tracker, watch);
  declareSight(*service, tracker, watch);
  declareSwitches(*service);
  addSettings(*service, documentedService("ALTracker"),
              {{"Mode", "Head"}, {"Effector", "None"}, {"MaximumDistanceDetection", 3.0F}});
  return service;
}

}  // namespace

std::vector<ServicePointer> makeBallServices(const ServiceContext& context,
                                             const std::shared_ptr<camera::ImageFeed>& images) {
  const auto watch = std::make_shared<BallWatch>(context, images);
  return {makeDetection(context, watch), makeRedBallTracker(watch), makeTracker(context, watch)};
}

}  // namespace nao::services
