#include "naoqi_api/services/ball_finder.h"

#include <gtest/gtest.h>
#include <array>

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

TEST(BallFinder, FindsARedAndAnOrangeBallWhereItIs) {
  for (const std::array<std::uint8_t, 3> color :
       {std::array<std::uint8_t, 3>{200, 20, 20}, std::array<std::uint8_t, 3>{255, 120, 0}}) {
    const auto ball = findRedBall(discAt(40, 90, 8, color));
    ASSERT_TRUE(ball);
    EXPECT_NEAR(ball->x, 40.5 / 160, 1e-6);
    EXPECT_NEAR(ball->y, 90.5 / 120, 1e-6);
    EXPECT_NEAR(ball->diameter, 17.0 / 160, 1e-6);
  }
}

TEST(BallFinder, SeesNeitherYellowNorSpecks) {
  EXPECT_FALSE(findRedBall(discAt(40, 90, 8, {235, 205, 20})));
  EXPECT_FALSE(findRedBall(discAt(40, 90, 1, {200, 20, 20})));
}

}  // namespace
}  // namespace nao::services
