#include "camera/lens_dirt.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace nao::camera {
namespace {

constexpr ImageSize kSize{160, 120};

Raster stripes() {
  Raster picture;
  picture.reset(kSize);
  for (int row = 0; row < kSize.height; ++row) {
    for (int column = 0; column < kSize.width; ++column) {
      picture.colors(row)[column] =
          column / 8 % 2 == 0 ? toPixel({250, 240, 20}) : toPixel({0, 0, 90});
    }
  }
  return picture;
}

// Part of the pixels that are not as they were.
double changed(float dirt) {
  const Raster before = stripes();
  Raster after = stripes();
  layDirt(after, dirt);
  int count = 0;
  for (int row = 0; row < kSize.height; ++row) {
    for (int column = 0; column < kSize.width; ++column) {
      count += before.colors(row)[column] != after.colors(row)[column] ? 1 : 0;
    }
  }
  return static_cast<double>(count) / (kSize.width * kSize.height);
}

TEST(LensDirt, CoversMoreTheMoreThereIs) {
  EXPECT_EQ(changed(0), 0);
  EXPECT_GT(changed(0.3F), 0.05);
  EXPECT_GT(changed(0.5F), changed(0.3F));
  EXPECT_LT(changed(0.5F), 0.9);  // some places are clear
  EXPECT_EQ(changed(1), 1);
}

TEST(LensDirt, ABlindLensShowsOneColour) {
  Raster picture = stripes();
  layDirt(picture, 1);
  const Pixel first = picture.colors(0)[0];
  for (int row = 0; row < kSize.height; ++row) {
    for (int column = 0; column < kSize.width; ++column) {
      ASSERT_EQ(picture.colors(row)[column], first);
    }
  }
}

// A blotch is where it is on the lens, however many pixels show it.
TEST(LensDirt, LiesInTheSamePlaceAtEverySize) {
  Raster small, large;
  small.reset({160, 120});
  large.reset({640, 480});
  small.fill(toPixel({255, 255, 255}));
  large.fill(toPixel({255, 255, 255}));
  layDirt(small, 0.5F);
  layDirt(large, 0.5F);
  for (int row = 0; row < 120; row += 7) {
    for (int column = 0; column < 160; column += 7) {
      const int one = static_cast<int>(small.colors(row)[column] & 0xff);
      const int other = static_cast<int>(large.colors(4 * row)[4 * column] & 0xff);
      EXPECT_LE(std::abs(one - other), 6) << column << " " << row;  // a pixel's slope of a blotch
    }
  }
}

}  // namespace
}  // namespace nao::camera
