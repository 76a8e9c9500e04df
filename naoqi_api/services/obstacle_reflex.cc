#include "naoqi_api/services/obstacle_reflex.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::Value;

constexpr double kTopSpeed = 0.0952;  // [m/s] ahead, of the default walk
constexpr double kAhead = 0.005;      // [m/s] slower walks lead nowhere; free
constexpr double kHalfWidth = 0.2;    // [m] of a Nao with its arms; free
constexpr std::size_t kMostTold = 1024;

// What the first argument of a walk says of the way ahead.
enum class Ahead { Speed, Fraction, Target };

struct WalkMethod {
  const char* name;
  Ahead kind;
};
constexpr WalkMethod kWalks[] = {{"move", Ahead::Speed},
                                 {"moveToward", Ahead::Fraction},
                                 {"setWalkTargetVelocity", Ahead::Fraction},
                                 {"_setMpcWalkTargetVelocity", Ahead::Fraction},
                                 {"moveTo", Ahead::Target},
                                 {"walkTo", Ahead::Target},
                                 {"_moveToPod", Ahead::Target}};

// The part of top speed at which a walk would lead ahead; 0 if it does not.
double partAhead(Ahead kind, const std::vector<Value>& arguments) {
  const Value* first = &arguments.front();
  while (const auto* items = first->findItems()) {  // of a path, its first point
    if (items->empty()) return 0;
    first = &items->front();
  }
  const double ahead = first->findNumber().value_or(0);
  switch (kind) {
    case Ahead::Speed:
      return ahead < kAhead ? 0 : ahead / kTopSpeed;
    case Ahead::Fraction:
      return std::max(ahead, 0.0);
    case Ahead::Target:
      return ahead > 0 ? 1 : 0;
  }
  return 0;
}

// Whether a name stands for a part: itself, both of its kind, or all.
bool covers(const std::string& name, const std::string& part) {
  const auto is = [&](const char* kind) { return part.find(kind) != std::string::npos; };
  return name == part || name == "All" || (name == "Body" && part != "Move") ||
         (name == "Arms" && is("Arm")) || (name == "Legs" && is("Leg"));
}

}  // namespace

void ObstacleReflex::declare(rpc::Service& service) {
  const Argument name{"pName", "A chain, Arms, Move or All."};
  addFunction(
      service, "setExternalCollisionProtectionEnabled",
      [this](const std::string& which, bool on) { set(which, on); },
      "Whether the walk stops before obstacles that the sonar hears. A Nao's arms see none.", name,
      Argument{"pEnable", "True: on, false: off."})
      .at(229);
  addFunction(
      service, "getExternalCollisionProtectionEnabled",
      [this](const std::string& which) { return isOn(which); },
      "Whether the walk stops before obstacles.", name)
      .at(232);
  addFunction(
      service, "getChainClosestObstaclePosition",
      [this](const std::string& which, int space) { return closest(which, space); },
      "Where the nearest obstacle is that the sonar hears or a client told of: x, y, z [m].",
      Argument{"pName", "Move, LArm or RArm."},
      Argument{"space", "0: torso, 1: world (odometry), 2: robot."})
      .at(231);
  addFunction(
      service, "_updateObstacles",
      [this](const std::vector<std::vector<float>>& places) {
        if (places.size() > kMostTold) throw rpc::CallError("too many obstacles");
        for (const auto& place : places) {
          if (place.size() < 2) throw rpc::CallError("expected [[x, y], ...]");
          finite(place[0]);
          finite(place[1]);
        }
        told_.clear();
        for (const auto& place : places) told_.emplace_back(place[0], place[1]);
      },
      "Tells of obstacles in place of those told before.",
      Argument{"obstacles", "[[x, y], ...] in the world [m]."})
      .at(276);
  addFunction(
      service, "_getDangerousRegion",
      [this] {
        const float x = orthogonal_distance_;
        const float y = static_cast<float>(kHalfWidth);
        return Value::list({Value::list({0.0F, -y}), Value::list({x, -y}), Value::list({x, y}),
                            Value::list({0.0F, y})});
      },
      "The corners [x, y] of the floor before the robot in which an obstacle ends a walk at full "
      "speed, in the robot's frame [m].")
      .at(244);
  declareDistances(service);
}

void ObstacleReflex::declareDistances(rpc::Service& service) {
  const Argument distance{"securityDistance", "Distance [m]; below 0 counts as 0."};
  addFunction(
      service, "setOrthogonalSecurityDistance",
      [this](float value) { orthogonal_distance_ = std::max(value, 0.0F); },
      "The distance at which a walk at full speed stops before an obstacle.", distance)
      .at(233);
  addFunction(
      service, "getOrthogonalSecurityDistance", [this] { return orthogonal_distance_; },
      "The distance at which a walk at full speed stops before an obstacle [m].")
      .at(234);
  addFunction(
      service, "setTangentialSecurityDistance",
      [this](float value) { tangential_distance_ = std::max(value, 0.0F); },
      "The distance at which the slowest walk stops before an obstacle.", distance)
      .at(235);
  addFunction(
      service, "getTangentialSecurityDistance", [this] { return tangential_distance_; },
      "The distance at which the slowest walk stops before an obstacle [m].")
      .at(236);
}

std::vector<std::string> ObstacleReflex::protectedParts() const {
  std::vector<std::string> parts = {"Move"};
  const auto chains = link_.model().groups.find("Chains");
  if (chains != link_.model().groups.end()) {
    parts.insert(parts.end(), chains->second.begin(), chains->second.end());
  }
  return parts;
}

void ObstacleReflex::set(const std::string& name, bool on) {
  bool is_known = false;
  for (const std::string& part : protectedParts()) {
    if (!covers(name, part)) continue;
    off_[part] = !on;
    is_known = true;
  }
  if (!is_known) throw rpc::CallError("unknown name: " + name + ", expected a chain, Move or All");
}

bool ObstacleReflex::isOn(const std::string& name) const {
  bool is_known = false;
  for (const std::string& part : protectedParts()) {
    if (!covers(name, part)) continue;
    is_known = true;
    const auto found = off_.find(part);
    if (found != off_.end() && found->second) return false;
  }
  if (!is_known) throw rpc::CallError("unknown name: " + name + ", expected a chain, Move or All");
  return true;
}

// The place that a receiver hears first, straight before it; nothing if it hears none.
std::optional<Vec3> ObstacleReflex::heard(std::size_t receiver) const {
  const SonarModel& sonar = link_.model().sonar;
  if (receiver >= sonar.receivers.size()) return std::nullopt;
  const double distance = link_.sensors()->sonar[receiver][0];
  if (distance <= 0 || distance >= sonar.max_range) return std::nullopt;
  const Frame& frame = link_.model().frames[static_cast<std::size_t>(sonar.receivers[receiver])];
  const Pose X_TF = kinematics_.calcPose({frame.body, frame.X_BF});
  return kinematics_.calcRobotFrame().inverse() * (X_TF * Vec3(distance, 0, 0));
}

std::optional<Vec3> ObstacleReflex::nearest() {
  kinematics_.update(link_.sensors()->angle);
  std::vector<Vec3> places;
  for (std::size_t receiver = 0; receiver < 2; ++receiver) {
    if (const auto place = heard(receiver)) places.push_back(*place);
  }
  const Pose2 at = link_.state()->position;
  for (const Eigen::Vector2d& told : told_) {
    const Pose2 place = relativeTo(at, {told.x(), told.y(), 0});
    places.emplace_back(place.x, place.y, 0);
  }
  const auto distance = [](const Vec3& place) { return std::hypot(place.x(), place.y()); };
  const auto found =
      std::min_element(places.begin(), places.end(),
                       [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
  if (found == places.end()) return std::nullopt;
  return *found;
}

std::vector<float> ObstacleReflex::closest(const std::string& name, int space) {
  isOn(name);
  if (space < 0 || space > 2) throw rpc::CallError("unknown space " + std::to_string(space));
  auto place = nearest();
  if (!place) throw rpc::CallError("no obstacle is known");
  if (space == 0) *place = kinematics_.calcRobotFrame() * *place;
  if (space == 1) {
    const Pose2 at = link_.state()->position;
    *place = translation({at.x, at.y, 0}) * (rotationFromRpy(0, 0, at.theta) * *place);
  }
  return {static_cast<float>(place->x()), static_cast<float>(place->y()),
          static_cast<float>(place->z())};
}

// Nearer than a walk ahead may come to it at this part of its top speed.
std::optional<Vec3> ObstacleReflex::inTheWay(double part_of_top_speed) {
  if (!isOn("Move")) return std::nullopt;
  const auto place = nearest();
  if (!place || std::abs(place->y()) > kHalfWidth || place->x() < 0) return std::nullopt;
  const double part = std::min(part_of_top_speed, 1.0);
  const double limit = tangential_distance_ + part * (orthogonal_distance_ - tangential_distance_);
  if (place->x() > limit) return std::nullopt;
  return place;
}

void ObstacleReflex::deliver() {
  if (!stopped_ || link_.now() == SimTime{}) return;
  const auto state = link_.state();
  if (!state->move_active) stopping_ = false;
  if (!state->move_active || stopping_ || state->velocity.x < kAhead) return;
  const auto place = inTheWay(state->velocity.x / kTopSpeed);
  if (!place) return;
  try {
    link_.post(motion::StopMove{});
  } catch (const rpc::CallError&) {
    return;  // the robot is busy; the next cycle comes soon
  }
  stopping_ = true;
  stopped_(*place, Walk::Ended);
}

void ObstacleReflex::guard(rpc::Service& service) {
  service.change([this](rpc::Method& method) {
    const auto walk = std::find_if(std::begin(kWalks), std::end(kWalks),
                                   [&](const WalkMethod& one) { return method.name == one.name; });
    if (walk == std::end(kWalks)) return;
    method.call = [this, call = method.call, kind = walk->kind,
                   tells = method.return_signature == "b"](const rpc::Caller& caller,
                                                           const std::vector<Value>& arguments) {
      const double part = stopped_ ? partAhead(kind, arguments) : 0;
      const bool asks = part > 0 && link_.now() != SimTime{};
      const auto place = asks ? inTheWay(part) : std::nullopt;
      if (!place) return call(caller, arguments);
      stopped_(*place, Walk::Refused);
      return rpc::Pending<Value>::done(tells ? Value(false) : Value());
    };
  });
}

}  // namespace nao::services
