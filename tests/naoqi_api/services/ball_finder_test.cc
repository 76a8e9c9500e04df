#include "naoqi_api/services/ball_finder.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>

#include "naoqi_api/services/disc_fit.h"

namespace nao::services {
namespace {

/// A green picture with a disc of one colour.
camera::Image discAt(int x, int y, int radius, std::array<std::uint8_t, 3> color) {
  camera::Image image;
  image.size = {160, 120};
  image.color_space = camera::ColorSpace::kRGB;
  camera::Bytes bytes;
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 160; ++column) {
      const int dx = column - x;
      const int dy = row - y;
      const bool inside = dx * dx + dy * dy <= radius * radius;
      const std::array<std::uint8_t, 3> green = {38, 115, 52};
      for (const std::uint8_t part : inside ? color : green) bytes.push_back(part);
    }
  }
  image.bytes = std::make_shared<const camera::Bytes>(std::move(bytes));
  return image;
}

using Color = std::array<std::uint8_t, 3>;
constexpr Color kRed = {200, 20, 20};

/// The same picture with some pixels in another colour.
template <class Where>
camera::Image painted(camera::Image image, const Color& color, const Where& where) {
  camera::Bytes bytes = *image.bytes;
  for (int y = 0; y < image.size.height; ++y) {
    for (int x = 0; x < image.size.width; ++x) {
      if (!where(x, y)) continue;
      const auto at = static_cast<std::ptrdiff_t>(3 * (y * image.size.width + x));
      std::copy(color.begin(), color.end(), bytes.begin() + at);
    }
  }
  image.bytes = std::make_shared<const camera::Bytes>(std::move(bytes));
  return image;
}

// Pixels cut a circle to half of one on either side; an arc of it tells its size to a tenth.
constexpr double kPixel = 1.0 / 160;
constexpr double kOfArc = 0.1;

void expectBall(const camera::Image& image, int x, int y, int radius) {
  SCOPED_TRACE(testing::Message() << "at " << x << ", " << y);
  const auto ball = findRedBall(image);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->x, (x + 0.5) / 160, kPixel);
  EXPECT_NEAR(ball->y, (y + 0.5) / 120, kPixel * 160 / 120);
  EXPECT_NEAR(ball->diameter, 2 * radius * kPixel, std::max(kPixel, kOfArc * 2 * radius * kPixel));
}

TEST(BallFinder, FindsARedAndAnOrangeBallWhereItIs) {
  expectBall(discAt(40, 90, 8, kRed), 40, 90, 8);
  expectBall(discAt(40, 90, 8, {255, 120, 0}), 40, 90, 8);
}

TEST(BallFinder, ABallIsAsLargeAtTheEdgeAndInTheCornerOfThePicture) {
  expectBall(discAt(1, 90, 8, kRed), 1, 90, 8);
  expectBall(discAt(40, 119, 8, kRed), 40, 119, 8);
  expectBall(discAt(159, 119, 8, kRed), 159, 119, 8);
  expectBall(discAt(1, 2, 8, kRed), 1, 2, 8);
}

TEST(BallFinder, ABallHalfHiddenIsAsLarge) {
  const camera::Image ball = discAt(80, 60, 8, kRed);
  const auto behind = [&](const auto& where) { return painted(ball, {90, 90, 90}, where); };
  expectBall(behind([](int x, int /*y*/) { return x < 80; }), 80, 60, 8);
  expectBall(behind([](int /*x*/, int y) { return y > 61; }), 80, 60, 8);
  expectBall(behind([](int x, int y) { return x + y > 143; }), 80, 60, 8);
}

// Its lower part dark, so that a sickle is left, and specks of it that noise makes bright.
TEST(BallFinder, ABallInItsOwnShadowIsAsLarge) {
  const auto dark = [](int x, int y) {
    const int dx = x - 82;
    const int dy = y - 67;
    return dx * dx + dy * dy < 100;
  };
  expectBall(painted(discAt(80, 60, 8, kRed), {40, 5, 5}, dark), 80, 60, 8);
}

TEST(BallFinder, ASmallBallIsASmallOne) {
  expectBall(discAt(80, 60, 2, kRed), 80, 60, 2);
  expectBall(discAt(80, 60, 3, kRed), 80, 60, 3);
}

TEST(BallFinder, AnAlmostStraightBorderLiesOnAHugeCircle) {
  PatchShape shape{{}, 320 * 140, 320, 240};
  for (int x = 0; x < 320; ++x)
    shape.border.push_back({x + 0.5, 100 + 1e-10 * (x - 160) * (x - 160)});
  const auto disc = fitDisc(shape);
  ASSERT_TRUE(disc);
  EXPECT_NEAR(disc->radius, 5e9, 1e9);  // what rounding leaves of so slight a bend
}

TEST(BallFinder, SeesNeitherYellowNorSpecksNorBoxesNorStripes) {
  EXPECT_FALSE(findRedBall(discAt(40, 90, 8, {235, 205, 20})));
  EXPECT_FALSE(findRedBall(discAt(40, 90, 1, kRed)));
  const camera::Image empty = discAt(-20, -20, 1, kRed);
  const auto red = [&](const auto& where) { return painted(empty, kRed, where); };
  EXPECT_FALSE(findRedBall(red([](int x, int y) { return x > 50 && x < 90 && y > 50 && y < 90; })));
  EXPECT_FALSE(findRedBall(red([](int /*x*/, int y) { return y > 50 && y < 55; })));
  EXPECT_FALSE(findRedBall(red([](int x, int y) { return x > 50 && x < 56 && y > 20 && y < 90; })));
}

}  // namespace
}  // namespace nao::services
