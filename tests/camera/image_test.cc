#include "camera/image.h"

#include <gtest/gtest.h>

namespace nao::camera {
namespace {

TEST(Image, LayersAreNaoQis) {
  for (int id = 0; id <= 8; ++id) EXPECT_EQ(layers(*toColorSpace(id)), 1) << id;
  for (const int id : {9, 14}) EXPECT_EQ(layers(*toColorSpace(id)), 2) << id;
  for (const int id : {10, 11, 12, 13, 15, 16}) EXPECT_EQ(layers(*toColorSpace(id)), 3) << id;
}

TEST(Image, UnknownColorSpacesAreNone) {
  for (const int id : {-1, 17, 18, 1000}) EXPECT_FALSE(toColorSpace(id)) << id;
}

TEST(Image, ResolutionNumbersAreNaoQis) {
  EXPECT_EQ(*resolutionSize(0), (ImageSize{160, 120}));
  EXPECT_EQ(*resolutionSize(2), (ImageSize{640, 480}));
  EXPECT_EQ(*resolutionSize(3), (ImageSize{1280, 960}));
  EXPECT_EQ(resolutionOf({80, 60}), 7);
  for (const int id : {-1, 5, 99}) EXPECT_FALSE(resolutionSize(id)) << id;
  EXPECT_FALSE(resolutionOf({641, 480}));
}

TEST(Image, HashSeesASingleByte) {
  Image image;
  image.bytes = std::make_shared<const Bytes>(Bytes{1, 2, 3});
  Image other = image;
  EXPECT_EQ(image.hash(), other.hash());
  other.bytes = std::make_shared<const Bytes>(Bytes{1, 2, 4});
  EXPECT_NE(image.hash(), other.hash());
}

}  // namespace
}  // namespace nao::camera
