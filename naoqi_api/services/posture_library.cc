#include "naoqi_api/services/posture_library.h"

#include <algorithm>
#include <cmath>

#include "motion/posture_graph.h"
#include "motion/postures.h"
#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Answer;
using rpc::Argument;
using rpc::CallError;
using rpc::Value;

const Argument kId{"id", "Number of a posture."};
const Argument kName{"name", "Name of a posture."};
const Argument kFraction{"maxSpeedFraction", "Part of the maximum speed, up to 1."};
const Argument kIgnored{"value", "Ignored."};

}  // namespace

PostureLibrary::PostureLibrary(RobotLink& link, std::filesystem::path data_dir)
    : link_(link), kinematics_(link.sharedModel()), data_dir_(std::move(data_dir)) {
  int id = 0;
  for (const Posture& posture : link.model().postures) {
    entries_[id++] = {posture.name, posture.family, posture.angle, false};
  }
}

const PostureLibrary::Entry& PostureLibrary::at(int id) const {
  const auto found = entries_.find(id);
  if (found == entries_.end()) throw CallError("no posture has the number " + std::to_string(id));
  return found->second;
}

int PostureLibrary::idOf(const std::string& name) const {
  for (const auto& [id, entry] : entries_) {
    if (entry.name == name) return id;
  }
  return -1;
}

bool PostureLibrary::holds(const std::string& name) const {
  const int id = idOf(name);
  return id >= 0 && entries_.at(id).saved;
}

std::vector<std::string> PostureLibrary::savedNames() const {
  std::vector<std::string> names;
  for (const auto& [id, entry] : entries_) {
    if (entry.saved && !entry.name.empty()) names.push_back(entry.name);
  }
  return names;
}

void PostureLibrary::declare(rpc::Service& service) {
  declareNames(service);
  declareSaving(service);
  declareDistances(service);
  declareGoing(service);
  declareKept(service);
  declareFiles(service);
}

void PostureLibrary::declareNames(rpc::Service& service) {
  addFunction(
      service, "_getIdFromName", [this](const std::string& name) { return idOf(name); },
      "The number of a posture; -1 if there is none of that name.", kName)
      .at(154);
  addFunction(
      service, "_getLibrarySize", [this] { return static_cast<int>(entries_.size()); },
      "How many postures there are.")
      .at(141);
  addFunction(
      service, "_getPostureIdList",
      [this] {
        std::vector<int> ids;
        for (const auto& [id, entry] : entries_) ids.push_back(id);
        return ids;
      },
      "The numbers of the postures.")
      .at(149);
  const auto current = [this] {
    const Posture* posture = motion::findCurrentPosture(link_.model(), *link_.sensors());
    const std::string name = posture == nullptr ? "Unknown" : posture->name;
    return Value::list({idOf(name), name});
  };
  const char* const meaning = "[number, name] of the posture the robot is in, or [-1, Unknown].";
  addFunction(service, "_getPosture", current, meaning).at(123);
  addFunction(service, "_getPostureNoZ", current, meaning).at(153);
  addFunction(
      service, "_getPostureZ", [current](float) { return current(); }, meaning, kIgnored)
      .at(152)
      .answering(Answer::Simplified);
}

bool PostureLibrary::save(int id, const std::string& name) {
  const auto known = entries_.find(id);
  if (id < 0 || (known != entries_.end() && !known->second.saved)) return false;
  if (known == entries_.end() && entries_.size() >= kMostPostures) return false;
  const int same = idOf(name);
  if (!name.empty() && same >= 0 && same != id) return false;
  entries_[id] = {name, {}, link_.sensors()->angle, true};
  return true;
}

bool PostureLibrary::rename(int id, const std::string& name) {
  const auto known = entries_.find(id);
  if (known == entries_.end() || !known->second.saved || idOf(name) >= 0) return false;
  known->second.name = name;
  return true;
}

void PostureLibrary::eraseSaved() {
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    entry = entry->second.saved ? entries_.erase(entry) : std::next(entry);
  }
}

void PostureLibrary::declareSaving(rpc::Service& service) {
  const char* const rule = " False for one of the robot's own.";
  addFunction(
      service, "_namePosture", [this](int id, const std::string& name) { return rename(id, name); },
      std::string("Names a saved posture.") + rule, kId, kName)
      .at(126);
  addFunction(
      service, "_renamePosture",
      [this](const std::string& from, const std::string& to) { return rename(idOf(from), to); },
      std::string("Renames a saved posture.") + rule, kName, Argument{"newName", "Its new name."})
      .at(127);
  addFunction(
      service, "_resavePosture", [this](int id) { return save(id, at(id).name); },
      std::string("Saves where the joints are in place of a saved posture.") + rule, kId)
      .at(128);
  addFunction(
      service, "_saveCurrentPosture", [this](int id) { return save(id, {}); },
      std::string("Saves where the joints are, without a name.") + rule, kId)
      .at(132);
  addFunction(
      service, "_saveCurrentPostureWithName",
      [this](int id, const std::string& name) { return save(id, name); },
      std::string("Saves where the joints are; goToPosture then knows it.") + rule, kId, kName)
      .at(133);
  addFunction(
      service, "_erasePosture",
      [this](int id) { return entries_.count(id) > 0 && at(id).saved && entries_.erase(id) > 0; },
      std::string("Forgets a saved posture.") + rule, kId)
      .at(140);
  addFunction(
      service, "_eraseAllPostures",
      [this] {
        eraseSaved();
        return true;
      },
      "Forgets all saved postures.")
      .at(135);
}

double PostureLibrary::jointDistance(const Entry& entry) const {
  double largest = 0;
  const auto sensors = link_.sensors();
  for (std::size_t i = 0; i < entry.angle.size(); ++i) {
    if (link_.model().actuators[i].coordinates.empty()) continue;  // hands are in no posture
    largest = std::max(largest, std::abs(sensors->angle[i] - entry.angle[i]));
  }
  return largest;
}

bool PostureLibrary::isIn(const Entry& entry, double joints) const {
  return jointDistance(entry) <= joints;
}

std::vector<float> PostureLibrary::effectorDistances(const Entry& entry) {
  std::vector<float> distances;
  for (const char* chain : {"Head", "LArm", "RArm", "LLeg", "RLeg"}) {
    const auto place = motion::findEffector(link_.model(), chain);
    if (!place) continue;
    kinematics_.update(entry.angle);
    const Vec3 there = kinematics_.calcPose(*place).translation();
    kinematics_.update(link_.sensors()->angle);
    distances.push_back(
        static_cast<float>((kinematics_.calcPose(*place).translation() - there).norm()));
  }
  return distances;
}

void PostureLibrary::declareDistances(rpc::Service& service) {
  const Argument joints{"jointThreshold", "How far joints may be off [rad]."};
  const Argument torso{"torsoThreshold", "Changes nothing."};
  addFunction(
      service, "_isRobotInPosture",
      [this](const std::string& name, float threshold, float) {
        const Entry& entry = at(idOf(name));
        return Value::list({isIn(entry, threshold), static_cast<float>(jointDistance(entry))});
      },
      "[whether the joints are there, how far the farthest is off [rad]].", kName, joints, torso)
      .at(121);
  addFunction(
      service, "_isRobotInPostureId",
      [this](int id, float threshold, float) { return isIn(at(id), threshold); },
      "Whether the joints are there.", kId, joints, torso)
      .at(122);
  addFunction(
      service, "_getArticularDistanceToPosture",
      [this](int id) { return static_cast<float>(jointDistance(at(id))); },
      "How far the farthest joint is off [rad].", kId)
      .at(146);
  addFunction(
      service, "_getCartesianDistanceToPosture",
      [this](int id) { return rpc::toValue(effectorDistances(at(id))); },
      "How far head, arms and legs are off, in the torso's frame [m].", kId)
      .at(147);
  addFunction(
      service, "_getCartesianDistanceVector", [this](int id) { return effectorDistances(at(id)); },
      "How far head, arms and legs are off, in the torso's frame [m].", kId)
      .at(148);
  addFunction(
      service, "_isReachable",
      [this](int id) {
        const Entry& entry = at(id);
        const std::string now = motion::currentFamily(link_.model(), *link_.sensors());
        return entry.saved || motion::findRoute(link_.model(), now, entry.family).has_value();
      },
      "Whether there is a way from the present family of postures; to saved ones it is straight.",
      kId)
      .at(150);
}

rpc::Pending<bool> PostureLibrary::goToEntry(const Entry& entry, double fraction) {
  motion::RequestId request = 0;
  if (!entry.saved) {
    request = link_.post(motion::GoToPosture{entry.name, fraction});
  } else {
    motion::InterpolateWithSpeed straight;
    for (std::size_t i = 0; i < entry.angle.size(); ++i) {
      straight.joints.push_back(toJoint(i));
      straight.angles.push_back(entry.angle[i]);
    }
    straight.fraction = fraction;
    request = link_.post(std::move(straight));
  }
  rpc::Pending<bool> done;
  const auto outcome = link_.outcomeOf(request);
  done.onCancel(outcome.canceler());
  outcome.whenDone([done](const auto& ended) {
    if (ended.isCanceled()) return done.cancelNow();
    done.resolve(ended.value->kind == motion::MotionOutcome::Kind::Done);
  });
  return done;
}

rpc::Pending<bool> PostureLibrary::goTo(const std::string& saved_name, double fraction) {
  const auto done = goToEntry(at(idOf(saved_name)), fraction);
  follow({saved_name}, done);
  return done;
}

void PostureLibrary::follow(const std::string& name, const rpc::Pending<bool>& done) {
  journey_ = std::make_shared<Journey>(Journey{{idOf(name)}, 1, done});
}

std::vector<float> PostureLibrary::currentPath() const {
  if (!journey_ || journey_->done.isDone()) return {};
  return {journey_->left.begin(), journey_->left.end()};
}

// As long as postures are reached.
void PostureLibrary::goOn(const std::shared_ptr<Journey>& journey) {
  if (journey->left.empty()) return journey->done.resolve(true);
  const auto reached = goToEntry(at(journey->left.front()), journey->fraction);
  journey->done.onCancel(reached.canceler());
  reached.whenDone([this, journey](const auto& ended) {
    if (ended.isCanceled()) return journey->done.cancelNow();
    if (ended.error || !*ended.value) return journey->done.resolve(false);
    journey->left.erase(journey->left.begin());
    try {
      goOn(journey);
    } catch (const CallError& error) {
      journey->done.fail(error.what());
    }
  });
}

void PostureLibrary::declareGoing(rpc::Service& service) {
  const auto go = [this](int id, float fraction) {
    return goToEntry(at(id), readFraction(fraction));
  };
  const char* const meaning = "Brings the robot into a posture; true if it gets there.";
  addFunction(service, "_setPostureId", go, meaning, kId, kFraction).at(124);
  addFunction(service, "_goToPostureId", go, meaning, kId, kFraction).at(125);
  addFunction(
      service, "_applyPostures",
      [this](const std::vector<int>& ids, float fraction, bool, bool) {
        for (const int id : ids) at(id);
        journey_ = std::make_shared<Journey>(Journey{ids, readFraction(fraction), {}});
        goOn(journey_);
        return journey_->done;
      },
      "Brings the robot into postures one after the other; true if it gets to all.",
      Argument{"ids", "Numbers of postures."}, kFraction, Argument{"first", "Ignored."},
      Argument{"second", "Ignored."})
      .at(134);
}

// The graph of postures is the robot file's own.
void PostureLibrary::declareKept(rpc::Service& service) {
  const char* const nothing = "True; has no effect: the ways between postures are the robot's own.";
  const auto kept = [](rpc::Service& declared, std::uint32_t uid) {
    declared.at(uid).answering(Answer::Simplified);
  };
  kept(addFunction(
           service, "_setSlowFactor", [](int, int, float) { return true; }, nothing, kId, kIgnored,
           kIgnored),
       129);
  kept(addFunction(
           service, "_setAntiCollision", [](int, bool) { return true; }, nothing, kId, kIgnored),
       130);
  kept(addFunction(
           service, "_setCost", [](int, float) { return true; }, nothing, kId, kIgnored),
       131);
  kept(addFunction(
           service, "_bindPostures", [](int, int, float, float) { return true; }, nothing, kId, kId,
           kIgnored, kIgnored),
       136);
  kept(addFunction(
           service, "_addNeighbourToPosture", [](int, int, float) { return true; }, nothing, kId,
           kId, kIgnored),
       137);
  kept(
      addFunction(
          service, "_removeNeighbourFromPosture", [](int, int) { return true; }, nothing, kId, kId),
      138);
  kept(addFunction(
           service, "_unBindPostures", [](int, int) { return true; }, nothing, kId, kId),
       139);
  kept(addFunction(
           service, "_isStandCallBack", [](const std::string&, const Value&, const std::string&) {},
           "Has no effect.", kIgnored, kIgnored, kIgnored),
       144);
  kept(addFunction(
           service, "_generateCartesianMap", [] {}, "Has no effect: distances are always fresh."),
       151);
}

}  // namespace nao::services
