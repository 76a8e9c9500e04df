#include "naoqi_api/services/al_tracker.h"

#include <algorithm>
#include <map>

#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/settings.h"
#include "naoqi_api/services/target_follower.h"

namespace nao::services {
namespace {

using rpc::Answer;
using rpc::Argument;
using rpc::CallError;
using rpc::Value;
using Names = std::vector<std::string>;
using Follower = std::shared_ptr<TargetFollower>;

const Names kModes = {"Head", "BodyRotation", "WholeBody", "Move"};
const Names kTargets = {"RedBall", "Face", "LandMark", "LandMarks", "People", "Sound"};
const Names kEffectors = {"None", "Arms", "LArm", "RArm"};

std::vector<float> asFloats(const Vec3& place) {
  return {static_cast<float>(place.x()), static_cast<float>(place.y()),
          static_cast<float>(place.z())};
}

Vec3 readPlace(const std::vector<float>& numbers) {
  if (numbers.size() != 3) throw CallError("expected a place of 3 numbers");
  return {finite(numbers[0]), finite(numbers[1]), finite(numbers[2])};
}

const std::string& oneOf(const Names& known, const std::string& name) {
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return *found;
  std::string list;
  for (const std::string& one : known) list += (list.empty() ? "" : ", ") + one;
  throw CallError("unknown name: " + name + ", expected one of " + list);
}

void declareTargets(rpc::Service& service, const Follower& follower,
                    const std::shared_ptr<BallWatch>& watch) {
  constexpr std::size_t kMost = 64;
  const Argument target{"target", "RedBall; others are kept and never seen."};
  const auto add = [follower, watch](const std::string& name, const Value& parameters) {
    if (follower->targets.size() >= kMost) throw CallError("too many targets");
    follower->targets[name] = parameters;
    const auto diameter = parameters.findNumber();
    if (name == "RedBall" && diameter && *diameter > 0) watch->setDiameter(*diameter);
  };
  const auto remove = [follower](const std::string& name) {
    follower->targets.erase(name);
    if (follower->active() == name) follower->stop();
  };
  const auto remove_some = [remove](const Names& names) {
    for (const std::string& name : names) remove(name);
  };
  const auto remove_all = [follower] {
    follower->stop();
    follower->targets.clear();
  };
  const auto names = [follower] {
    Names list;
    for (const auto& [name, parameters] : follower->targets) list.push_back(name);
    return list;
  };
  // Each under its name and the one it had before.
  for (const char* name : {"registerTarget", "addTarget"}) {
    addFunction(service, name, add, "Makes a target known.", target,
                Argument{"params", "Of RedBall: its diameter [m]."});
  }
  for (const char* name : {"unregisterTarget", "removeTarget"}) {
    addFunction(service, name, remove, "Forgets a target.", target);
  }
  for (const char* name : {"unregisterTargets", "removeTargets"}) {
    addFunction(service, name, remove_some, "Forgets targets.", Argument{"targets", "Names."});
  }
  for (const char* name : {"unregisterAllTargets", "removeAllTargets"}) {
    addFunction(service, name, remove_all, "Forgets all targets.");
  }
  for (const char* name : {"getRegisteredTargets", "getManagedTargets"}) {
    addFunction(service, name, names, "The targets that are known.");
  }
  for (const char* name : {"getSupportedTargets", "getTargetNames"}) {
    addFunction(
        service, name, [] { return kTargets; }, "The kinds of targets; only RedBall is ever seen.");
  }
}

void declareTracking(rpc::Service& service, const Follower& follower) {
  addFunction(
      service, "track", [follower](const std::string& name) { follower->track(name); },
      "Follows a target from now on, as mode and effector say.",
      Argument{"target", "One that is registered."});
  addFunction(
      service, "trackEvent", [follower](const std::string& event) { follower->trackEvent(event); },
      "Follows the places that an event of ALMemory tells from now on, as mode and effector say.",
      Argument{"pEventName", "Its value begins with x, y, z in the robot's frame [m]."})
      .answering(Answer::Simplified);
  addFunction(
      service, "stopTracker", [follower] { follower->stop(); }, "The robot stays where it is.");
  addFunction(
      service, "getActiveTarget", [follower] { return follower->active(); }, "What is tracked.");
  addFunction(
      service, "isActive", [follower] { return !follower->active().empty(); },
      "Whether something is tracked.");
  addFunction(
      service, "toggleSearch", [follower](bool on) { follower->searches = on; },
      "Whether the head looks about while the target is not seen.",
      Argument{"search", "True: it does."});
  addFunction(
      service, "isSearchEnabled", [follower] { return follower->searches; },
      "Whether the head looks about while the target is not seen.");
  addFunction(
      service, "initialize",
      [follower] {
        follower->stop();
        follower->mode = "Head";
        follower->effector = "None";
        follower->searches = false;
      },
      "Ends tracking and takes the defaults.");
}

void declareSight(rpc::Service& service, const Follower& follower,
                  const std::shared_ptr<BallWatch>& watch) {
  addFunction(
      service, "isTargetLost", [follower] { return !follower->sees(); },
      "Whether what is tracked is not seen.");
  addFunction(
      service, "isNewTargetDetected", [watch] { return watch->takeNews(); },
      "Whether the target was seen since this was asked last.");
  const auto place = [follower](int frame) {
    const auto seen = follower->targetIn(frame);
    return seen ? asFloats(*seen) : std::vector<float>();
  };
  const char* const meaning = "Where the target is [m]; nothing if it is not seen.";
  addFunction(
      service, "getTargetPosition", [place] { return place(0); }, meaning);
  addFunction(service, "getTargetPosition", place, meaning,
              Argument{"frame", "0: torso, 1: world (odometry), 2: robot."});
}

void declareHow(rpc::Service& service, const Follower& follower) {
  addFunction(
      service, "getAvailableModes", [] { return kModes; },
      "Head, BodyRotation, WholeBody and Move.");
  addFunction(
      service, "setMode",
      [follower](const std::string& mode) { follower->mode = oneOf(kModes, mode); },
      "What follows besides the head: nothing, a turn on the spot, all joints, or steps.",
      Argument{"mode", "Head, BodyRotation, WholeBody or Move."});
  addFunction(
      service, "getMode", [follower] { return follower->mode; }, "The mode; Head at first.");
  for (const char* name : {"setEffector", "addEffector"}) {
    addFunction(
        service, name,
        [follower](const std::string& arm) { follower->effector = oneOf(kEffectors, arm); },
        "Which arm points at the target.", Argument{"effector", "None, Arms, LArm or RArm."});
  }
  addFunction(
      service, "removeEffector", [follower](const std::string&) { follower->effector = "None"; },
      "No arm points any more.", Argument{"effector", "Changes nothing."});
  addFunction(
      service, "getEffector", [follower] { return follower->effector; },
      "Which arm points at the target.");
  addFunction(
      service, "setRelativePosition",
      [follower](const Value& numbers) {
        const auto read = numbers.to<std::vector<float>>();
        if (read.size() != 6) throw CallError("expected 6 numbers, got " + numbers.print());
        for (const float number : read) finite(number);
        follower->relative = read;
      },
      "Where the robot is to stand in mode Move.",
      Argument{"target", "[x, y, turn] as seen from the target, and how far off each may be."});
  addFunction(
      service, "getRelativePosition", [follower] { return rpc::toValue(follower->relative); },
      "Where the robot is to stand in mode Move.");
  addFunction(
      service, "setMaximumDistanceDetection",
      [follower](float distance) { follower->farthest = finite(distance); },
      "How far off a target may be [m].", Argument{"distance", "[m]"});
  addFunction(
      service, "getMaximumDistanceDetection",
      [follower] { return static_cast<float>(follower->farthest); },
      "How far off a target may be [m].");
}

// The one watch looks as often as a picture comes.
void declarePeriods(rpc::Service& service, const Follower& follower) {
  constexpr int kPeriod_ms = 100;
  const Argument target{"pTarget", "Name of a target."};
  const auto periods = std::make_shared<std::map<std::string, int>>();
  const auto known = [](const std::string& name) { return oneOf(kTargets, name); };
  addFunction(
      service, "setExtractorPeriod",
      [periods, known](const std::string& name, int period) {
        (*periods)[known(name)] = std::max(period, 1);
      },
      "Is kept; the ball is looked for ten times a second.", target, Argument{"pPeriod", "[ms]"})
      .answering(Answer::Simplified);
  addFunction(
      service, "getExtractorPeriod",
      [periods, known](const std::string& name) {
        const auto kept = periods->find(known(name));
        return kept == periods->end() ? kPeriod_ms : kept->second;
      },
      "What was kept; 100 before [ms].", target)
      .answering(Answer::Simplified);
  addFunction(
      service, "getRobotPosition", [follower] { return follower->robotPosition(); },
      "Where the robot is by its odometry: x, y [m], theta [rad].");
}

void declarePointing(rpc::Service& service, const Follower& follower) {
  const Argument place{"position", "x, y, z [m]."};
  const Argument frame{"frame", "0: torso, 1: world (odometry), 2: robot."};
  const Argument fraction{"fractionMaxSpeed", "Part of the maximum speed, up to 1."};
  const Argument whole{"useWholeBody", "Changes nothing: the head alone turns."};
  const auto look = [follower](const std::vector<float>& at, int of, float part, bool) {
    follower->lookAt(readPlace(at), of, readFraction(part));
  };
  const char* const looks = "Starts turning the head to a place and does not wait.";
  addFunction(service, "lookAt", look, looks, place, frame, fraction, whole);
  addFunction(
      service, "lookAt",
      [look](const std::vector<float>& at, float part, bool body) { look(at, 2, part, body); },
      looks, Argument{"position", "x, y, z [m] in the robot's frame."}, fraction, whole);
  const Argument arm{"effector", "LArm, RArm or Arms."};
  const auto point = [follower](const std::string& which, const std::vector<float>& at, int of,
                                float part) {
    follower->pointAt(which, readPlace(at), of, readFraction(part));
  };
  const char* const points = "Starts pointing an arm at a place and does not wait.";
  addFunction(service, "pointAt", point, points, arm, place, frame, fraction);
  addFunction(
      service, "pointAt",
      [point](const std::string& which, const std::vector<float>& at, float part) {
        point(which, at, 2, part);
      },
      points, arm, Argument{"position", "x, y, z [m] in the robot's frame."}, fraction);
}

}  // namespace

ServicePointer makeAlTracker(const ServiceContext& context,
                             const std::shared_ptr<BallWatch>& watch) {
  auto service = makeModule("ALTracker", "Follows a red ball with head, arms and steps.");
  for (const char* event : {"ALTracker/ActiveTargetChanged", "ALTracker/TargetDetected",
                            "ALTracker/TargetLost", "ALTracker/TargetReached"}) {
    context.store().declareEvent(event, "ALTracker");
  }
  const auto follower = std::make_shared<TargetFollower>(context, watch);
  declareTargets(*service, follower, watch);
  declareTracking(*service, follower);
  declareSight(*service, follower, watch);
  declareHow(*service, follower);
  declarePointing(*service, follower);
  declarePeriods(*service, follower);
  addSettings(*service, documentedService("ALTracker"), {});
  return service;
}

}  // namespace nao::services
