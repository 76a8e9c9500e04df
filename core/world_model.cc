#include "core/world_model.h"

#include <algorithm>
#include <filesystem>

#include "core/config.h"

// A world's file. Lengths in metres, angles in radians, colours [red, green, blue] from 0 to 255;
// a key with a value behind it may be left out.
//
//   name: <file's name>           gravity: 9.80665          sky_color: [170, 190, 210]
//   ground:
//     size: [10, 10]              color: [60, 130, 60]      # painted part; the floor is endless
//     friction: 0.7               stiffness: 30e3           damping: 300
//     tangential_stiffness: 20e3  tangential_damping: 100
//   lines:      [{from: [x, y], to: [x, y], width: 0.05, color: white}]
//   rings:      [{center: [x, y], radius, width: 0.05, color: white}]
//   boxes:      [{position, rpy: zero, size: [x, y, z], color: grey}]
//   spheres:    [{position, radius, color}]
//   cylinders:  [{position, rpy, radius, height, color}]   # height along the local z axis
//   balls:      [{name: ball, position, radius, mass, rolling_deceleration: 0.5, color: orange}]
//   robots:     [{name, model, start: [x, y, theta]}]

namespace nao {
namespace {

using Presence = Config::Presence;

Eigen::Vector2d planar(Config& config, const std::string& key) {
  const auto values = config.numbers(key, 2);
  return {values[0], values[1]};
}

void readGround(Config& ground, WorldModel& world) {
  if (ground.has("size")) {
    const auto size = ground.numbers("size", 2, kPositive);
    world.ground_size = Eigen::Vector2d(size[0], size[1]);
  }
  world.ground_color = ground.color("color", world.ground_color);
  Material& material = world.ground;
  material.friction = ground.number("friction", {0, 10}, material.friction);
  material.stiffness = ground.number("stiffness", kPositive, material.stiffness);
  material.damping = ground.number("damping", kNotNegative, material.damping);
  material.tangential_stiffness =
      ground.number("tangential_stiffness", kPositive, material.tangential_stiffness);
  material.tangential_damping =
      ground.number("tangential_damping", kNotNegative, material.tangential_damping);
}

void readMarks(Config& config, WorldModel& world) {
  config.list("lines", Presence::Optional, [&](Config& entry) {
    GroundMark mark;
    mark.from = planar(entry, "from");
    mark.to = planar(entry, "to");
    mark.width = entry.number("width", kPositive, mark.width);
    mark.color = entry.color("color", mark.color);
    world.marks.push_back(mark);
  });
  config.list("rings", Presence::Optional, [&](Config& entry) {
    GroundMark mark;
    mark.kind = GroundMark::Kind::Ring;
    mark.from = planar(entry, "center");
    mark.radius = entry.number("radius", kPositive);
    mark.width = entry.number("width", kPositive, mark.width);
    mark.color = entry.color("color", mark.color);
    world.marks.push_back(mark);
  });
}

// The obstacles listed at `key`; `size_of` reads what is particular to their kind.
void readShapes(Config& config, const std::string& key, Shape::Kind kind, WorldModel& world,
                const std::function<Vec3(Config&)>& size_of) {
  config.list(key, Presence::Optional, [&](Config& entry) {
    Shape shape;
    shape.kind = kind;
    shape.X_BS = entry.pose();
    shape.size = size_of(entry);
    shape.color = entry.color("color", shape.color);
    world.obstacles.push_back({"", shape, {}});
  });
}

Vec3 boxSize(Config& entry) {
  const auto size = entry.numbers("size", 3, kPositive);
  return {size[0], size[1], size[2]};
}

void readObstacles(Config& config, WorldModel& world) {
  readShapes(config, "boxes", Shape::Kind::Box, world, boxSize);
  readShapes(config, "spheres", Shape::Kind::Sphere, world,
             [](Config& entry) { return Vec3(entry.number("radius", kPositive), 0, 0); });
  readShapes(config, "cylinders", Shape::Kind::Cylinder, world, [](Config& entry) {
    return Vec3(entry.number("radius", kPositive), 0, entry.number("height", kPositive));
  });
}

// The names so far, and this entry's, which must be new.
template <class List>
std::string newName(Config& entry, const std::string& name, const List& named) {
  const bool taken = std::any_of(named.begin(), named.end(),
                                 [&](const auto& other) { return other.name == name; });
  if (taken) entry.fail("`name`: expected each name once, found '" + name + "' again");
  return name;
}

void readBalls(Config& config, WorldModel& world) {
  config.list("balls", Presence::Optional, [&](Config& entry) {
    Ball ball;
    ball.name = newName(entry, entry.text("name", ball.name), world.balls);
    ball.radius = entry.number("radius", kPositive);
    ball.mass = entry.number("mass", kPositive);
    ball.rolling_deceleration =
        entry.number("rolling_deceleration", kNotNegative, ball.rolling_deceleration);
    ball.p_W = entry.vector("position");
    ball.color = entry.color("color", ball.color);
    world.balls.push_back(ball);
  });
}

void readRobots(Config& config, WorldModel& world) {
  config.list("robots", Presence::Optional, [&](Config& entry) {
    RobotPlace place;
    place.name = newName(entry, entry.text("name"), world.robots);
    place.model = entry.text("model");
    const auto start = entry.numbers("start", 3);
    place.start = {start[0], start[1], start[2]};
    world.robots.push_back(place);
  });
}

}  // namespace

std::shared_ptr<const WorldModel> loadWorldModel(const std::string& file) {
  auto world = std::make_shared<WorldModel>();
  Config::read(file, [&](Config& config) {
    world->name = config.text("name", std::filesystem::path(file).stem().string());
    world->gravity = config.number("gravity", {0, 100}, world->gravity);
    world->sky_color = config.color("sky_color", world->sky_color);
    config.map("ground", Presence::Optional, [&](Config& ground) { readGround(ground, *world); });
    readMarks(config, *world);
    readObstacles(config, *world);
    readBalls(config, *world);
    readRobots(config, *world);
  });
  return world;
}

}  // namespace nao
