#include "core/world_model.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/config.h"

// A world's file. Lengths in metres, angles in radians, colours [red, green, blue] from 0 to 255;
// a key with a value behind it may be left out.
//
//   name: <file's name>           gravity: 9.80665          sky_color: [170, 190, 210]
//   light: 1                                                # on everything; 1: a usual hall
//   materials:
//     <name>: {friction: 0.7, torsional_friction: 0, restitution: 0, stiffness: 30e3, damping: 300,
//              tangential_stiffness: 20e3, tangential_damping: 100}
//   ground:
//     size: [10, 10]              color: [60, 130, 60]      # painted part; the floor is endless
//     grain: 0                    # part by which the carpet's brightness strays, for the eye
//     slope: 0                    uphill: 0                 # how steep; which way up, from x
//     material: <name>            # or the keys of a material themselves, or both: keys win
//   lines:      [{from: [x, y], to: [x, y], width: 0.05, color: white}]
//   rings:      [{center: [x, y], radius, width: 0.05, color: white}]
//   boxes:      [{name, position, rpy: zero, size: [x, y, z], color: grey, material: <name>,
//                 texture: <file>}]              # Netpbm, on each face; beside the world's file
//   spheres:    [{name, position, rpy, radius, color, material, texture}]  # as a globe's map
//   cylinders:  [{name, position, rpy, radius, height, color, material,  # height along local z
//                 texture}]                      # once around, from local x on; and on the lids
//   hulls:      [{name, file, scale: 1, position, rpy, color, material}]  # convex hull of an OBJ's
//                                                  # corners, its axes; beside the world's file
//                 faces: false, texture: <file>}]  # faces: seen as in the file, not as its hull
//   balls:      [{name: ball, position, radius, mass, inertia_factor: 0.4, material,
//                 rolling_deceleration: 0.5, color: orange, patches: false}]  # twelve black ones
//   robots:     [{name, model, start: [x, y, theta], team: color}]             # of its shirt

namespace nao {
namespace {

using Presence = Config::Presence;

Eigen::Vector2d planar(Config& config, const std::string& key) {
  const auto values = config.numbers(key, 2);
  return {values[0], values[1]};
}

using Materials = std::map<std::string, Material>;

void readMaterial(Config& config, Material& material) {
  material.friction = config.number("friction", {0, 10}, material.friction);
  material.torsional_friction =
      config.number("torsional_friction", {0, 1}, material.torsional_friction);
  material.restitution = config.number("restitution", {0, 1}, material.restitution);
  material.stiffness = config.number("stiffness", kPositive, material.stiffness);
  material.damping = config.number("damping", kNotNegative, material.damping);
  material.tangential_stiffness =
      config.number("tangential_stiffness", kPositive, material.tangential_stiffness);
  material.tangential_damping =
      config.number("tangential_damping", kNotNegative, material.tangential_damping);
}

Materials readMaterials(Config& config) {
  Materials materials;
  config.map("materials", Presence::Optional, [&](Config& list) {
    for (const std::string& name : list.keys()) {
      list.map(name, Presence::Required,
               [&](Config& entry) { readMaterial(entry, materials[name]); });
    }
  });
  return materials;
}

// What `material` names, or the usual one.
Material materialOf(Config& entry, const Materials& materials) {
  if (!entry.has("material")) return {};
  const auto found = materials.find(entry.text("material"));
  if (found != materials.end()) return found->second;
  std::string names;
  for (const auto& [name, material] : materials) names += (names.empty() ? "" : ", ") + name;
  entry.reject("material", names.empty() ? "no name, since the world has no `materials`"
                                         : "one of the world's `materials`: " + names);
}

void readGround(Config& ground, const Materials& materials, WorldModel& world) {
  if (ground.has("size")) {
    const auto size = ground.numbers("size", 2, kPositive);
    world.ground_size = Eigen::Vector2d(size[0], size[1]);
  }
  world.ground_color = ground.color("color", world.ground_color);
  world.ground_grain = ground.number("grain", {0, 1}, 0);
  const double slope = ground.number("slope", {0, 1}, 0);
  const double uphill = ground.number("uphill", {}, 0);
  const double along = std::sin(slope);
  world.ground_normal = Vec3(-along * std::cos(uphill), -along * std::sin(uphill), std::cos(slope));
  world.ground = materialOf(ground, materials);
  readMaterial(ground, world.ground);
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

// The names so far, and this entry's, which must be new.
template <class List>
std::string newName(Config& entry, const std::string& name, const List& named) {
  const bool taken = std::any_of(named.begin(), named.end(),
                                 [&](const auto& other) { return other.name == name; });
  if (taken) entry.fail("`name`: expected each name once, found '" + name + "' again");
  return name;
}

// The obstacles listed at `key`; `finish` reads what is particular to their kind.
void readShapes(Config& config, const std::string& key, Shape::Kind kind,
                const Materials& materials, WorldModel& world,
                const std::function<void(Config&, Shape&)>& finish) {
  config.list(key, Presence::Optional, [&](Config& entry) {
    Obstacle obstacle;
    const std::string name = entry.text("name", "");
    if (!name.empty()) obstacle.name = newName(entry, name, world.obstacles);
    obstacle.shape.kind = kind;
    obstacle.shape.X_BS = entry.pose();
    obstacle.shape.color = entry.color("color", obstacle.shape.color);
    obstacle.material = materialOf(entry, materials);
    finish(entry, obstacle.shape);
    world.obstacles.push_back(obstacle);
  });
}

// A file beside the world's.
std::string fileBeside(Config& entry, const std::string& key, const std::string& expected) {
  const auto file = std::filesystem::path(entry.file()).parent_path() / entry.text(key);
  if (!std::filesystem::exists(file)) entry.reject(key, expected + " beside this one");
  return file.string();
}

void readPaint(Config& entry, Shape& shape) {
  if (!entry.has("texture")) return;
  const std::string file = fileBeside(entry, "texture", "a Netpbm picture");
  shape.texture = std::make_shared<const Texture>(readTexture(file));
}

// The triangles of the file, where its hull stands.
void readFaces(const std::string& file, double scale, const Vec3& middle, Shape& shape) {
  ObjMesh mesh = readObjMesh(file);
  for (ObjMesh::Triangle& triangle : mesh.triangles) {
    for (ObjMesh::Corner& corner : triangle) corner.p = scale * corner.p - middle;
  }
  shape.mesh = std::make_shared<const ObjMesh>(std::move(mesh));
}

// About the middle of the hull, so that a sphere about the shape's centre holds it closely.
void readHull(Config& entry, Shape& shape) {
  const double scale = entry.number("scale", kPositive, 1);
  const std::string file = fileBeside(entry, "file", "an OBJ file");
  std::vector<Vec3> corners = readObjCorners(file);
  Eigen::AlignedBox3d box;
  for (Vec3& corner : corners) box.extend(corner *= scale);
  const Vec3 middle = corners.empty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
  for (Vec3& corner : corners) corner -= middle;
  Hull hull = calcHull(corners);
  if (hull.faces.empty())
    entry.reject("file", "an OBJ file of corners that are not all in one plane");
  shape.X_BS = shape.X_BS * translation(middle);
  shape.size = box.sizes();
  shape.hull = std::make_shared<const Hull>(std::move(hull));
  const bool has_paint = entry.has("texture");
  if (entry.flag("faces", has_paint) || has_paint) readFaces(file, scale, middle, shape);
  readPaint(entry, shape);
}

void readObstacles(Config& config, const Materials& materials, WorldModel& world) {
  const auto read = [&](const std::string& key, Shape::Kind kind, const auto& finish) {
    readShapes(config, key, kind, materials, world, finish);
  };
  read("boxes", Shape::Kind::Box, [](Config& entry, Shape& shape) {
    const auto size = entry.numbers("size", 3, kPositive);
    shape.size = Vec3(size[0], size[1], size[2]);
    readPaint(entry, shape);
  });
  read("spheres", Shape::Kind::Sphere, [](Config& entry, Shape& shape) {
    shape.size = Vec3(entry.number("radius", kPositive), 0, 0);
    readPaint(entry, shape);
  });
  read("cylinders", Shape::Kind::Cylinder, [](Config& entry, Shape& shape) {
    shape.size = Vec3(entry.number("radius", kPositive), 0, entry.number("height", kPositive));
    readPaint(entry, shape);
  });
  read("hulls", Shape::Kind::Hull, readHull);
}

void readBalls(Config& config, const Materials& materials, WorldModel& world) {
  config.list("balls", Presence::Optional, [&](Config& entry) {
    Ball ball;
    ball.name = newName(entry, entry.text("name", ball.name), world.balls);
    ball.radius = entry.number("radius", kPositive);
    ball.mass = entry.number("mass", kPositive);
    ball.inertia_factor = entry.number("inertia_factor", {0.01, 2.0 / 3}, ball.inertia_factor);
    ball.rolling_deceleration =
        entry.number("rolling_deceleration", kNotNegative, ball.rolling_deceleration);
    ball.material = materialOf(entry, materials);
    ball.p_W = entry.vector("position");
    ball.color = entry.color("color", ball.color);
    ball.has_patches = entry.flag("patches", false);
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
    if (entry.has("team")) place.team = entry.color("team", {});
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
    world->light = config.number("light", {0.001, 1000}, world->light);
    const Materials materials = readMaterials(config);
    config.map("ground", Presence::Optional,
               [&](Config& ground) { readGround(ground, materials, *world); });
    readMarks(config, *world);
    readObstacles(config, materials, *world);
    readBalls(config, materials, *world);
    readRobots(config, *world);
  });
  return world;
}

}  // namespace nao
