#include "validation/film.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <string>

#include "core/check.h"
#include "sim/world.h"
#include "tests/core/temporary_folder.h"
#include "validation/png.h"

namespace nao::validation {
namespace {

TEST(Png, HoldsThePixelsRowByRow) {
  camera::Raster picture;
  picture.reset({2, 2});
  picture.fill(camera::toPixel({10, 20, 30}));
  picture.colors(1)[1] = camera::toPixel({200, 0, 1});
  const std::string png = encodePng(picture);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\0\2\0\0\0\2", 8));

  const std::size_t data = png.find("IDAT") + 4;
  std::string rows(14, '\0');
  uLongf length = rows.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &length,
                       reinterpret_cast<const Bytef*>(png.data() + data),
                       static_cast<uLong>(png.size() - data)),
            Z_OK);
  EXPECT_EQ(length, 14u);
  EXPECT_EQ(rows, std::string("\0\x0a\x14\x1e\x0a\x14\x1e\0\x0a\x14\x1e\xc8\0\x01", 14));
}

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(toBase64(""), "");
  EXPECT_EQ(toBase64("f"), "Zg==");
  EXPECT_EQ(toBase64("fo"), "Zm8=");
  EXPECT_EQ(toBase64("foobar"), "Zm9vYmFy");
}

SceneFrame sceneWithNao() {
  const auto model = loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33");
  return sim::World(std::make_shared<WorldModel>(), {{"nao", model, {}}},
                    std::chrono::milliseconds(2))
      .scene();
}

TEST(OutsideCamera, SeesTheRobot) {
  SceneFrame scene = sceneWithNao();
  OutsideCamera camera({160, 120});
  const std::string with = encodePng(camera.picture(scene));
  auto bare = std::make_shared<RobotModel>(*scene.robots[0].model);
  for (Body& body : bare->bodies) body.visuals.clear();
  scene.robots[0].model = bare;
  EXPECT_NE(encodePng(camera.picture(scene)), with);
}

TEST(Film, AFolderTakesSinglePictures) {
  const TemporaryFolder folder;
  Film film(folder.path() + "/frames", "");
  EXPECT_TRUE(film.isDue(0));
  film.add(sceneWithNao());
  EXPECT_FALSE(film.isDue(0.03));
  EXPECT_TRUE(film.isDue(0.04));
  EXPECT_GT(std::filesystem::file_size(folder.path() + "/frames/frame_00000.png"), 1000u);
  EXPECT_THROW(Film(folder.path() + "/a.mp4", "/nowhere/encode"), InputError);
  EXPECT_THROW(Film(folder.path() + "/a.gif", ""), InputError);
}

}  // namespace
}  // namespace nao::validation
