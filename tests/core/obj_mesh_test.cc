#include "core/obj_mesh.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/core/temporary_folder.h"

namespace nao {
namespace {

constexpr const char* kSquare =
    "# a square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "usemtl none\nf 1/1 2/2 3/3 4/4\n";

TEST(ObjMesh, AFaceOfFourCornersIsTwoTriangles) {
  const TemporaryFolder folder;
  const ObjMesh mesh = readObjMesh(folder.write("square.obj", kSquare));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.triangles[1][2].p, Vec3(0, 1, 0));
  EXPECT_EQ(mesh.triangles[0][0].normal, Vec3(0, 0, 1));  // flat, as there is none in the file
}

TEST(ObjMesh, TextureCountsFromTheTop) {
  const TemporaryFolder folder;
  const ObjMesh mesh = readObjMesh(folder.write("square.obj", kSquare));
  EXPECT_EQ(mesh.triangles[0][0].texture, Eigen::Vector2d(0, 1));
  EXPECT_EQ(mesh.triangles[0][2].texture, Eigen::Vector2d(1, 0));
}

TEST(ObjMesh, NumbersMayCountBackwardsAndNormalsAreTaken) {
  const TemporaryFolder folder;
  const ObjMesh mesh = readObjMesh(
      folder.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nf -3//1 -2//1 -1//-1\n"));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0][1].p, Vec3(1, 0, 0));
  EXPECT_EQ(mesh.triangles[0][1].normal, Vec3(0, 0, 1));
}

TEST(ObjMesh, FacesWithoutAreaAreLeftOut) {
  const TemporaryFolder folder;
  const ObjMesh mesh =
      readObjMesh(folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"));
  EXPECT_TRUE(mesh.triangles.empty());
}

TEST(ObjMesh, MistakesAreToldWithTheirLine) {
  const TemporaryFolder folder;
  for (const char* content : {"v 0 0\n", "v 0 0 0\nf 1 1\n", "v 0 0 0\nf 1 2 3\n",
                              "v 0 0 0\nf 0 1 1\n", "v 0 0 0\nf x 1 1\n"}) {
    const std::string file = folder.write("bad.obj", content);
    try {
      readObjMesh(file);
      FAIL() << content;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("bad.obj:"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace nao
