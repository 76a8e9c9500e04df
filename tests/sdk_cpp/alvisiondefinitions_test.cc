// What ALVideoDevice's numbers mean, against the tables of NAOqi 2.1 and 2.8.

#include <alvision/alvisiondefinitions.h>
#include <gtest/gtest.h>

namespace AL {
namespace {

TEST(AlVisionDefinitions, OtherNamesAreTheSameNumbers) {
  EXPECT_EQ(k960p, k4VGA);
  EXPECT_EQ(k1920p, k16VGA);
  EXPECT_EQ(kYUV422InterlacedColorSpace, kYUV422ColorSpace);
  EXPECT_EQ(kCameraAecAlgorithmID, kCameraExposureAlgorithmID);
}

TEST(AlVisionDefinitions, AResolutionHasItsSizeAndBack) {
  for (int resolution = 0; isResolutionValid(resolution); ++resolution) {
    int width = 0, height = 0;
    setSizeFromResolution(resolution, width, height);
    EXPECT_EQ(getResolutionFromSize(width, height), resolution);
  }
  EXPECT_TRUE(isResolutionValid(kQQQQ720px2));
  EXPECT_FALSE(isResolutionValid(-1));
  EXPECT_FALSE(isResolutionValid(kQQQQ720px2 + 1));
}

// Layers are bytes of a pixel; a channel may have several.
TEST(AlVisionDefinitions, AColorSpaceHasItsLayersAndChannels) {
  EXPECT_EQ(getNumLayersInColorSpace(krGbColorSpace), 1);
  EXPECT_EQ(getNumLayersInColorSpace(kYUV422ColorSpace), 2);
  EXPECT_EQ(getNumChannelsInColorSpace(kBGRColorSpace), 3);
  EXPECT_EQ(getNumLayersInColorSpace(kDepthColorSpace), 2);
  EXPECT_EQ(getNumChannelsInColorSpace(kDepthColorSpace), 1);
  EXPECT_EQ(getNumLayersInColorSpace(kXYZColorSpace), 12);
  EXPECT_EQ(getNumChannelsInColorSpace(kXYZColorSpace), 3);
  EXPECT_EQ(getNumLayersInColorSpace(kARGBColorSpace), 4);
}

TEST(AlVisionDefinitions, AColorSpaceOfNoNumberIsNone) {
  EXPECT_TRUE(isColorSpaceValid(kYuvColorSpace));
  EXPECT_TRUE(isColorSpaceValid(kLChuvColorSpace));
  EXPECT_FALSE(isColorSpaceValid(kLChuvColorSpace + 1));
  EXPECT_EQ(getNumLayersInColorSpace(-1), -1);
  EXPECT_EQ(getNumChannelsInColorSpace(99), -1);
}

TEST(AlVisionDefinitions, AnglesAreSharesOfTheImage) {
  EXPECT_FLOAT_EQ(convertAnglePosToNormalizedImgPos(0.25F, -0.5F, 0.5F), 0.75F);
  EXPECT_FLOAT_EQ(convertAngleValToNormalizedImgVal(0.25F, -0.5F, 0.5F), 0.25F);
}

}  // namespace
}  // namespace AL
