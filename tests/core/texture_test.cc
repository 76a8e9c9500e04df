#include "core/texture.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/core/temporary_folder.h"

namespace nao {
namespace {

TEST(Texture, EachLevelIsTheMeanOfTheOneBefore) {
  const Texture texture = makeTexture(2, 2, {0x000000, 0x0000ff, 0x00ff00, 0xff0000});
  ASSERT_EQ(texture.levels.size(), 2u);
  EXPECT_EQ(texture.levels[1].width, 1);
  EXPECT_EQ(texture.levels[1].pixels[0], 0x404040u);  // 255 / 4, rounded
}

TEST(Texture, OddSizesEndInOnePixelToo) {
  const Texture texture = makeTexture(5, 3, std::vector<std::uint32_t>(15, 0x102030));
  EXPECT_EQ(texture.levels.size(), 4u);  // 5x3, 3x2, 2x1, 1x1
  for (const auto& level : texture.levels) {
    for (const std::uint32_t pixel : level.pixels) EXPECT_EQ(pixel, 0x102030u);
  }
}

TEST(Texture, ReadsAllSixNetpbmFormats) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::vector<std::uint32_t>>> files = {
      {"P1\n# a comment\n2 1\n10\n", {0x000000, 0xffffff}},
      {"P2\n2 1\n3\n0 3\n", {0x000000, 0xffffff}},
      {"P3\n1 1\n255\n1 2 3\n", {0x030201}},
      {std::string("P4\n2 1\n\x80", 8), {0x000000, 0xffffff}},
      {"P5\n2 1\n255\nAB", {0x414141, 0x424242}},
      {"P6\n1 1\n255\nABC", {0x434241}}};
  for (const auto& [content, pixels] : files) {
    const Texture texture = readTexture(folder.write("picture", content));
    EXPECT_EQ(texture.levels[0].pixels, pixels) << content.substr(0, 2);
  }
}

TEST(Texture, WhatIsNoPictureIsToldOf) {
  const TemporaryFolder folder;
  for (const char* content : {"", "P7\n1 1\n255\n", "P5\n2 2\n255\nAB", "P5\n0 1\n255\n",
                              "P5\n60000 60000\n255\n", "P2\n1 1\n3\n4\n"}) {
    EXPECT_THROW(readTexture(folder.write("picture", content)), InputError) << content;
  }
  EXPECT_THROW(readTexture(folder.path() + "/absent.pgm"), InputError);
}

}  // namespace
}  // namespace nao
