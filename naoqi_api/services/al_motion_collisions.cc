#include "naoqi_api/services/al_motion_collisions.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "core/shape_gap.h"
#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

constexpr std::size_t kMostShapes = 256;

struct KindName {
  Shape::Kind kind;
  const char* name;
};
constexpr KindName kKinds[] = {{Shape::Kind::Sphere, "Sphere"},
                               {Shape::Kind::Box, "Box"},
                               {Shape::Kind::Cylinder, "Cylinder"},
                               {Shape::Kind::Capsule, "Pill"},
                               {Shape::Kind::Hull, "Hull"}};

const char* nameOf(Shape::Kind kind) {
  const auto* const found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                         [&](const KindName& one) { return one.kind == kind; });
  return found->name;
}

// Hulls have no size to tell.
Shape::Kind readKind(const std::string& name) {
  for (const KindName& one : kKinds) {
    if (name == one.name && one.kind != Shape::Kind::Hull) return one.kind;
  }
  throw CallError("unknown kind of solid: " + name + ", expected Sphere, Box, Cylinder or Pill");
}

Value asList(const Vec3& vector) {
  return Value::list({static_cast<float>(vector.x()), static_cast<float>(vector.y()),
                      static_cast<float>(vector.z())});
}

// Whether one hangs on the other, or both on the same link.
bool areJoined(const RobotModel& model, std::size_t a, std::size_t b) {
  const int parent_a = model.bodies[a].parent;
  const int parent_b = model.bodies[b].parent;
  return a == b || parent_a == static_cast<int>(b) || parent_b == static_cast<int>(a) ||
         (parent_a == parent_b && parent_a >= 0);
}

bool mayTouch(const RobotModel& model, std::size_t a, std::size_t b) {
  const auto listed = [&](const std::pair<int, int>& pair) {
    const auto first = static_cast<std::size_t>(pair.first);
    const auto second = static_cast<std::size_t>(pair.second);
    return (first == a && second == b) || (first == b && second == a);
  };
  return std::any_of(model.no_collision.begin(), model.no_collision.end(), listed);
}

// Sizes of a Shape from [radius], [radius, length] or [three edges].
Vec3 readSize(Shape::Kind kind, const Value& value) {
  const auto numbers = value.to<std::vector<double>>();
  const std::size_t wanted = kind == Shape::Kind::Sphere ? 1 : kind == Shape::Kind::Box ? 3 : 2;
  if (numbers.size() < wanted) throw CallError("expected sizes [m], got " + value.print());
  for (std::size_t i = 0; i < wanted; ++i) {
    if (!(finite(numbers[i]) > 0)) throw CallError("a size must be above 0");
  }
  if (kind == Shape::Kind::Box) return {numbers[0], numbers[1], numbers[2]};
  return {numbers[0], 0, kind == Shape::Kind::Sphere ? 0 : numbers[1]};
}

// [x, y, z] or [x, y, z, and turns about them].
Pose readPlace(const Value& value) {
  auto numbers = value.to<std::vector<double>>();
  if (numbers.size() != 3 && numbers.size() != 6) {
    throw CallError("expected a place of 3 or 6 numbers, got " + value.print());
  }
  numbers.resize(6);
  for (const double number : numbers) finite(number);
  Pose place = translation({numbers[0], numbers[1], numbers[2]});
  place.linear() = rotationFromRpy(numbers[3], numbers[4], numbers[5]);
  return place;
}

Shape makeShape(const std::string& kind, const Value& size, const Value& place) {
  Shape shape;
  shape.kind = readKind(kind);
  shape.size = readSize(shape.kind, size);
  shape.X_BS = readPlace(place);
  return shape;
}

const std::vector<Value>& itemsOf(const Value& value, std::size_t count) {
  const auto* items = value.findItems();
  if (!items || items->size() != count) {
    throw CallError("expected a list of " + std::to_string(count) + ", got " + value.print());
  }
  return *items;
}

}  // namespace

void AlMotionCollisions::declare(rpc::Service& service) {
  addFunction(
      service, "_getCollisionNames",
      [this] {
        std::vector<std::string> names;
        for (std::size_t body = 0; body < link_.model().bodies.size(); ++body) {
          if (!shapesOf(body).empty()) names.push_back(link_.model().bodies[body].name);
        }
        return rpc::toValue(names);
      },
      "The links that have collision solids.")
      .at(239);
  addFunction(
      service, "_getCollisionShapes", [this](const std::string& name) { return getShapes(name); },
      "[[kind, [size], [place]], ...] of a link's solids in the link [m]: radius and length, or "
      "three edges.",
      Argument{"name", "Name of a link."})
      .at(240);
  addFunction(
      service, "_getCollisionStateForObstacleSummary",
      [&service](const std::string& chain) {
        rpc::Pending<bool> told;
        service.call("isCollision", {chain}, {}).whenDone([told](const auto& outcome) {
          if (!outcome.value) return told.fail(outcome.error.value_or("canceled"));
          told.resolve(*outcome.value != Value("none"));
        });
        return told;
      },
      "Whether an arm's command is near the body.", Argument{"pChainName", "LArm, RArm or Arms."})
      .at(238);
  addFunction(
      service, "_getDetectedCollisions", [this](float nearer) { return getDetected(nearer); },
      "[[link, link, distance], ...] of solids that are nearer to each other, as commanded [m].",
      Argument{"pMinimumDistance", "[m]"})
      .at(243);
  declareSetting(service);
}

void AlMotionCollisions::declareSetting(rpc::Service& service) {
  const char* const meaning =
      "Gives links other solids, for _getCollisionShapes and _getDetectedCollisions; the arms are "
      "kept from the body by the robot's own.";
  const Argument pairs{"pPairList", "Changes nothing: all links are looked at."};
  const Argument places{"pPositionList", "[x, y, z] in the link each, or six numbers [m, rad]."};
  addFunction(
      service, "_setCollisionShapes",
      [this](const std::vector<std::string>& names, const std::vector<std::string>&,
             const std::vector<std::string>& links, const std::vector<std::string>& kinds,
             const Value& sizes, const Value& positions) {
        const std::size_t count = names.size();
        if (links.size() != count || kinds.size() != count) {
          throw CallError("expected a link and a kind for each name");
        }
        const auto& size = itemsOf(sizes, count);
        const auto& place = itemsOf(positions, count);
        std::vector<Shape> shapes;
        for (std::size_t i = 0; i < count; ++i) {
          shapes.push_back(makeShape(kinds[i], size[i], place[i]));
        }
        setShapes(links, shapes);
      },
      meaning, Argument{"pNameList", "A name for each solid."}, pairs,
      Argument{"pBodyList", "The link of each."},
      Argument{"pTypeList", "Sphere, Box, Cylinder or Pill each."},
      Argument{"pShapeList", "[radius], [radius, length] or [three edges] each [m]."}, places)
      .at(241)
      .answering(rpc::Answer::Simplified);
  addFunction(
      service, "_setCollisionShapes",
      [this](const std::vector<std::string>& links, const std::vector<std::string>&,
             const Value& solids, const Value& positions) {
        const auto& solid = itemsOf(solids, links.size());
        const auto& place = itemsOf(positions, links.size());
        std::vector<Shape> shapes;
        for (std::size_t i = 0; i < links.size(); ++i) {
          const auto& kind_and_size = itemsOf(solid[i], 2);
          shapes.push_back(
              makeShape(kind_and_size[0].to<std::string>(), kind_and_size[1], place[i]));
        }
        setShapes(links, shapes);
      },
      meaning, Argument{"pNameList", "Names of links."}, pairs,
      Argument{"pShapeList", "[kind, [size]] each, as _getCollisionShapes tells them."}, places)
      .at(242)
      .answering(rpc::Answer::Simplified);
}

const std::vector<Shape>& AlMotionCollisions::shapesOf(std::size_t body) const {
  const auto told = told_.find(body);
  return told == told_.end() ? link_.model().bodies[body].collisions : told->second;
}

Value AlMotionCollisions::getShapes(const std::string& name) const {
  const auto body = link_.model().findBody(name);
  if (!body) throw CallError("unknown link: " + name);
  std::vector<Value> shapes;
  for (const Shape& shape : shapesOf(static_cast<std::size_t>(*body))) {
    shapes.push_back(
        Value::list({nameOf(shape.kind), asList(shape.size), asList(shape.X_BS.translation())}));
  }
  return Value::list(std::move(shapes));
}

// All links are known before the first one changes.
void AlMotionCollisions::setShapes(const std::vector<std::string>& links,
                                   const std::vector<Shape>& shapes) {
  if (links.size() > kMostShapes) throw CallError("too many solids");
  std::map<std::size_t, std::vector<Shape>> told;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto body = link_.model().findBody(links[i]);
    if (!body) throw CallError("unknown link: " + links[i]);
    told[static_cast<std::size_t>(*body)].push_back(shapes[i]);
  }
  for (auto& [body, solids] : told) told_[body] = std::move(solids);
}

double AlMotionCollisions::gapBetween(std::size_t a, std::size_t b) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Shape& mine : shapesOf(a)) {
    for (const Shape& other : shapesOf(b)) {
      const ShapeGap gap =
          calcShapeGap(mine, kinematics_.getPose(static_cast<int>(a)) * mine.X_BS, other,
                       kinematics_.getPose(static_cast<int>(b)) * other.X_BS);
      least = std::min(least, gap.distance);
    }
  }
  return least;
}

Value AlMotionCollisions::getDetected(float nearer) {
  const RobotModel& model = link_.model();
  kinematics_.update(link_.state()->command.angle);
  std::vector<Value> found;
  for (std::size_t a = 0; a < model.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < model.bodies.size(); ++b) {
      if (areJoined(model, a, b) || mayTouch(model, a, b)) continue;
      const double gap = gapBetween(a, b);
      if (gap >= nearer) continue;
      found.push_back(
          Value::list({model.bodies[a].name, model.bodies[b].name, static_cast<float>(gap)}));
    }
  }
  return Value::list(std::move(found));
}

}  // namespace nao::services
