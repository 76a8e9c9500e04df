#include "core/world_model.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/check.h"
#include "tests/core/temporary_folder.h"

namespace nao {
namespace {

std::shared_ptr<const WorldModel> shipped(const std::string& name) {
  return loadWorldModel(NAO_SOURCE_DIR "/worlds/" + name);
}

// The complaint about a world of this text.
std::string complaintAbout(const std::string& text) {
  const TemporaryFolder folder;
  const std::string file = folder.write("world.yaml", text);
  try {
    loadWorldModel(file);
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return "no complaint";
}

std::size_t count(const WorldModel& world, GroundMark::Kind kind) {
  return static_cast<std::size_t>(
      std::count_if(world.marks.begin(), world.marks.end(),
                    [&](const GroundMark& mark) { return mark.kind == kind; }));
}

TEST(WorldModel, EmptyIsAFloorAndNothingElse) {
  const auto world = shipped("empty.yaml");
  EXPECT_EQ(world->name, "empty");
  EXPECT_DOUBLE_EQ(world->gravity, 9.80665);
  EXPECT_DOUBLE_EQ(world->ground.stiffness, 30e3);
  EXPECT_TRUE(world->marks.empty() && world->obstacles.empty() && world->balls.empty());
}

TEST(WorldModel, Field2011HasSixByFourMetresOfLines) {
  const auto world = shipped("field_2011.yaml");
  EXPECT_EQ(world->ground_size, Eigen::Vector2d(7.4, 5.4));
  EXPECT_EQ(count(*world, GroundMark::Kind::Line), 15u);
  ASSERT_EQ(count(*world, GroundMark::Kind::Ring), 1u);
  Eigen::Vector2d farthest = Eigen::Vector2d::Zero();
  for (const GroundMark& mark : world->marks) {
    EXPECT_DOUBLE_EQ(mark.width, 0.05);
    if (mark.kind == GroundMark::Kind::Ring) {
      EXPECT_DOUBLE_EQ(mark.radius, 0.6);
      continue;
    }
    farthest = farthest.cwiseMax(mark.from.cwiseAbs()).cwiseMax(mark.to.cwiseAbs());
  }
  // Line centres at 3 and 2; corners reach half a width further.
  EXPECT_NEAR(farthest.x(), 3.025, 1e-12);
  EXPECT_NEAR(farthest.y(), 2.025, 1e-12);
}

TEST(WorldModel, Field2011IsTheSameFromBothSides) {
  const auto world = shipped("field_2011.yaml");
  const auto touches = [](const GroundMark& mark, const Eigen::Vector2d& a,
                          const Eigen::Vector2d& b) {
    const auto close = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
      return (p - q).norm() < 1e-12;
    };
    return (close(mark.from, a) && close(mark.to, b)) || (close(mark.from, b) && close(mark.to, a));
  };
  for (const GroundMark& mark : world->marks) {
    if (mark.kind == GroundMark::Kind::Ring) continue;
    EXPECT_TRUE(
        std::any_of(world->marks.begin(), world->marks.end(),
                    [&](const GroundMark& other) { return touches(other, -mark.from, -mark.to); }))
        << mark.from.transpose() << " to " << mark.to.transpose();
  }
}

TEST(WorldModel, Field2011HasAYellowGoalAheadAndABlueOneBehind) {
  const auto world = shipped("field_2011.yaml");
  ASSERT_EQ(world->obstacles.size(), 6u);
  for (const Obstacle& obstacle : world->obstacles) {
    const Shape& part = obstacle.shape;
    EXPECT_EQ(part.kind, Shape::Kind::Cylinder);
    EXPECT_DOUBLE_EQ(part.size.x(), 0.05);
    EXPECT_DOUBLE_EQ(std::abs(part.X_BS.translation().x()), 3);
    const bool ahead = part.X_BS.translation().x() > 0;
    EXPECT_EQ(part.color.red > part.color.blue, ahead);
    // A post stands on the ground, the bar lies across 0.8 m above it.
    const double half_height = 0.5 * part.size.z() * std::abs(part.X_BS.linear()(2, 2));
    const bool is_post = half_height > 0.1;
    const double bottom = part.X_BS.translation().z() - (is_post ? half_height : part.size.x());
    EXPECT_NEAR(bottom, is_post ? 0 : 0.8, 1e-9);
  }
}

TEST(WorldModel, Field2011HasTheOrangeBall) {
  const auto world = shipped("field_2011.yaml");
  ASSERT_EQ(world->balls.size(), 1u);
  const Ball& ball = world->balls[0];
  EXPECT_DOUBLE_EQ(ball.radius, 0.0325);
  EXPECT_DOUBLE_EQ(ball.mass, 0.055);
  EXPECT_DOUBLE_EQ(ball.p_W.z(), ball.radius);  // lies on the ground
  EXPECT_GT(ball.color.red, 200);
  EXPECT_LT(ball.color.blue, 50);
}

TEST(WorldModel, ReadsObstaclesAndRobots) {
  const TemporaryFolder folder;
  const auto world = loadWorldModel(folder.write("two_boxes.yaml", R"(
boxes:
  - {position: [1, 2, 0.5], rpy: [0, 0, 1.5], size: [1, 2, 1], color: [1, 2, 3]}
spheres:
  - {position: [0, 0, 1], radius: 0.25}
robots:
  - {name: keeper, model: nao_h25_v50, start: [-2.8, 0, 0.5]}
)"));
  EXPECT_EQ(world->name, "two_boxes");
  ASSERT_EQ(world->obstacles.size(), 2u);
  EXPECT_EQ(world->obstacles[0].shape.size, Vec3(1, 2, 1));
  EXPECT_NEAR(rpyOf(world->obstacles[0].shape.X_BS.linear()).z(), 1.5, 1e-12);
  EXPECT_EQ(world->obstacles[0].shape.color.blue, 3);
  EXPECT_EQ(world->obstacles[1].shape.kind, Shape::Kind::Sphere);
  EXPECT_EQ(world->robots[0].model, "nao_h25_v50");
  EXPECT_DOUBLE_EQ(world->robots[0].start.theta, 0.5);
}

TEST(WorldModel, SaysWhereAndWhatInABrokenFile) {
  EXPECT_EQ(complaintAbout("name: x\ngravity: up\n"),
            "world.yaml:2: `gravity`: expected a number in [0, 100], found 'up'");
  EXPECT_EQ(complaintAbout("name: x\nground:\n  friction: -1\n"),
            "world.yaml:3: `friction`: expected a number in [0, 10], found '-1'");
  EXPECT_EQ(complaintAbout("lines:\n  - from: [0, 0]\n    to: [1]\n"),
            "world.yaml:3: `to`: expected a list of 2 numbers, found 1");
  EXPECT_EQ(complaintAbout("balls:\n  - {radius: 0.03, position: [0, 0, 0]}\n"),
            "world.yaml:2: `mass`: missing, expected a number above 0");
  EXPECT_EQ(
      complaintAbout("name: x\ngrond: {}\n"),
      "world.yaml:2: `grond`: unknown key, expected one of balls, boxes, cylinders, "
      "gravity, ground, hulls, light, lines, materials, name, rings, robots, sky_color, spheres");
  EXPECT_EQ(complaintAbout("robots:\n"
                           "  - {name: a, model: m, start: [0, 0, 0]}\n"
                           "  - {name: a, model: m, start: [1, 0, 0]}\n"),
            "world.yaml:3: `name`: expected each name once, found 'a' again");
}

TEST(WorldModel, Field2020HasNineBySixMetresOfLinesAndASmallLightBall) {
  const auto world = shipped("field_2020.yaml");
  EXPECT_EQ(world->ground_size, Eigen::Vector2d(10.4, 7.4));
  Eigen::Vector2d farthest = Eigen::Vector2d::Zero();
  for (const GroundMark& mark : world->marks) {
    if (mark.kind == GroundMark::Kind::Line) {
      farthest = farthest.cwiseMax(mark.from.cwiseAbs()).cwiseMax(mark.to.cwiseAbs());
    } else {
      EXPECT_DOUBLE_EQ(mark.radius, 0.75);
    }
  }
  EXPECT_NEAR(farthest.x(), 4.525, 1e-12);
  EXPECT_NEAR(farthest.y(), 3.025, 1e-12);
  EXPECT_EQ(world->obstacles.size(), 6u);
  EXPECT_DOUBLE_EQ(world->obstacles[0].material.restitution, 0.5);
  ASSERT_EQ(world->balls.size(), 1u);
  EXPECT_DOUBLE_EQ(world->balls[0].mass, 0.044);
  EXPECT_DOUBLE_EQ(world->balls[0].radius, 0.05);
}

TEST(WorldModel, ObstaclesHaveNamesAndMaterials) {
  const auto world = shipped("obstacles.yaml");
  const auto find = [&](const std::string& name) {
    return *std::find_if(world->obstacles.begin(), world->obstacles.end(),
                         [&](const Obstacle& obstacle) { return obstacle.name == name; });
  };
  EXPECT_DOUBLE_EQ(find("ice").material.friction, 0.1);
  EXPECT_DOUBLE_EQ(find("wall").material.stiffness, 10000);
  const Shape boulder = find("boulder").shape;
  EXPECT_EQ(boulder.kind, Shape::Kind::Hull);
  EXPECT_GT(boulder.hull->faces.size(), 10u);
  EXPECT_NEAR(boulder.size.x(), 0.3, 0.05);
  EXPECT_DOUBLE_EQ(world->balls[0].material.restitution, 0.8);
}

TEST(WorldModel, ASlopeRisesTheWayItSays) {
  const TemporaryFolder folder;
  const auto world =
      loadWorldModel(folder.write("hill.yaml", "ground: {slope: 0.1, uphill: 1.570796327}\n"));
  EXPECT_NEAR(world->ground_normal.norm(), 1, 1e-12);
  EXPECT_NEAR(world->ground_normal.y(), -std::sin(0.1), 1e-9);
  EXPECT_NEAR(world->ground_normal.x(), 0, 1e-9);
}

TEST(WorldModel, TheHullOfACubeLosesWhatIsInside) {
  const TemporaryFolder folder;
  std::string obj = "# a cube\no cube\n";
  for (const char* x : {"0", "1"}) {
    for (const char* y : {"0", "1"}) {
      for (const char* z : {"0", "1"}) {
        obj += std::string("v ") + x + " " + y + " " + z + "\n";
      }
    }
  }
  folder.write("cube.obj", obj + "v 0.5 0.5 0.5\nv 0.2 0.9 0.4\nf 1 2 3\n");
  const auto world =
      loadWorldModel(folder.write("world.yaml", "hulls:\n  - {file: cube.obj, scale: 2}\n"));
  const Shape& cube = world->obstacles[0].shape;
  EXPECT_EQ(cube.hull->corners.size(), 8u);
  EXPECT_EQ(cube.hull->faces.size(), 12u);
  EXPECT_EQ(cube.hull->edges.size(), 12u);
  EXPECT_EQ(cube.size, Vec3(2, 2, 2));
  EXPECT_EQ(cube.X_BS.translation(), Vec3(1, 1, 1));  // about its middle
  EXPECT_NEAR(cube.hull->radius, std::sqrt(3.0), 1e-12);
  for (const Hull::Face& face : cube.hull->faces) {
    EXPECT_NEAR(face.offset, 1, 1e-12);  // outwards, all
  }
}

TEST(WorldModel, SaysWhatIsWrongWithAHullOrAMaterial) {
  const TemporaryFolder folder;
  folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n");
  folder.write("broken.obj", "v 0 0 0\nv 1 x 0\n");
  const auto complaint = [&](const std::string& text) -> std::string {
    try {
      loadWorldModel(folder.write("world.yaml", text));
    } catch (const InputError& error) {
      return folder.withoutPath(error.what());
    }
    return "no complaint";
  };
  EXPECT_EQ(complaint("hulls:\n  - {file: none.obj}\n"),
            "world.yaml:2: `file`: expected an OBJ file beside this one, found 'none.obj'");
  EXPECT_EQ(complaint("hulls:\n  - {file: flat.obj}\n"),
            "world.yaml:2: `file`: expected an OBJ file of corners that are not all in one plane, "
            "found 'flat.obj'");
  EXPECT_EQ(complaint("hulls:\n  - {file: broken.obj}\n"),
            "broken.obj:2: expected `v x y z` with three numbers");
  EXPECT_EQ(complaint("materials:\n  ice: {friction: 0.1}\nground:\n  material: snow\n"),
            "world.yaml:4: `material`: expected one of the world's `materials`: ice, found 'snow'");
  EXPECT_EQ(complaint("materials:\n  ice: {restitution: 2}\n"),
            "world.yaml:2: `restitution`: expected a number in [0, 1], found '2'");
  EXPECT_EQ(complaint("boxes:\n  - {name: a, size: [1, 1, 1]}\n  - {name: a, size: [1, 1, 1]}\n"),
            "world.yaml:3: `name`: expected each name once, found 'a' again");
}

TEST(WorldModel, WhatMeetsTheEyeIsRead) {
  const TemporaryFolder folder;
  folder.write("paint.pgm", "P2\n1 1\n255\n7\n");
  folder.write("tip.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n");
  const auto world = loadWorldModel(
      folder.write("world.yaml",
                   "light: 0.5\nground: {grain: 0.2}\n"
                   "boxes:\n  - {position: [0, 0, 0], size: [1, 1, 1], texture: paint.pgm}\n"
                   "spheres:\n  - {position: [0, 0, 0], radius: 1, texture: paint.pgm}\n"
                   "cylinders:\n  - {radius: 1, height: 1, texture: paint.pgm}\n"
                   "hulls:\n  - {file: tip.obj, scale: 2, position: [1, 0, 0], faces: true}\n"
                   "balls:\n  - {position: [0, 0, 1], radius: 0.05, mass: 0.04, patches: true}\n"
                   "robots:\n  - {name: a, model: m, start: [0, 0, 0], team: [200, 0, 0]}\n"));
  EXPECT_EQ(world->light, 0.5);
  EXPECT_EQ(world->ground_grain, 0.2);
  ASSERT_TRUE(world->obstacles[0].shape.texture);
  EXPECT_EQ(world->obstacles[0].shape.texture->levels[0].pixels[0], 0x070707u);
  EXPECT_TRUE(world->obstacles[1].shape.texture);
  EXPECT_TRUE(world->obstacles[2].shape.texture);
  const Shape& tip = world->obstacles[3].shape;
  ASSERT_TRUE(tip.mesh && tip.hull);
  ASSERT_EQ(tip.mesh->triangles.size(), 2u);
  // The corner at (2, 0, 0) of the scaled file, 1 m along x in the world.
  EXPECT_TRUE((tip.X_BS * tip.mesh->triangles[0][2].p).isApprox(Vec3(3, 0, 0)));
  EXPECT_TRUE(world->balls[0].has_patches);
  ASSERT_TRUE(world->robots[0].team);
  EXPECT_EQ(world->robots[0].team->red, 200);
}

TEST(WorldModel, SaysWhatIsWrongWithATexture) {
  EXPECT_EQ(complaintAbout("boxes:\n  - {position: [0, 0, 0], size: [1, 1, 1], texture: no.pgm}\n")
                .find("world.yaml:2:"),
            0u);
}

TEST(WorldModel, SaysWhichFileIsMissing) {
  try {
    loadWorldModel("/nowhere/moon.yaml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/moon.yaml: can not be read");
  }
}

}  // namespace
}  // namespace nao
