// Images that a program makes itself, or of values, without a robot.

#include <alvision/alimage.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>

#include "tests/core/temporary_folder.h"

namespace AL {
namespace {

// Two pixels: the first red, the second blue.
const unsigned char kPixels[] = {255, 0, 0, 0, 0, 255};

ALValue picture(int space = kRGBColorSpace) {
  return ALValue::array(2, 1, 3, space, 1400000000, 250000, ALValue(kPixels, 6), 1, 0.5F, -0.4F,
                        -0.5F, 0.4F);
}

TEST(AlImage, ReadsEachFieldOfAValue) {
  const ALImage image(picture());
  EXPECT_EQ(image.getWidth(), 2);
  EXPECT_EQ(image.getNbLayers(), 3);
  EXPECT_EQ(image.getTimeStamp(), 1400000000250000LL);
  EXPECT_EQ(image.getTimeStampUS(), 250000);
  EXPECT_EQ(image.getCameraId(), 1);
  EXPECT_EQ(image.getRightAngle(), -0.5F);
  EXPECT_EQ(image.getSize(), 6U);
  EXPECT_THROW(ALImage(ALValue::array(1, 2)), ALError);
}

TEST(AlImage, SharesAValuesPixelsAndCopiesThemWhenAsked) {
  const ALValue value = picture();
  EXPECT_EQ(ALImage(value).getData(), value[6].GetBinary());
  const std::unique_ptr<ALImage> copy(ALImage::fromALValue(value));
  ASSERT_TRUE(copy);
  EXPECT_NE(copy->getData(), value[6].GetBinary());
  EXPECT_TRUE(copy->toALValue() == value) << copy->toALValue();
  EXPECT_EQ(ALImage::fromALValue(ALValue(1)), nullptr);
}

TEST(AlImage, IsMadeBlackOfASizeOrAResolution) {
  const ALImage image(kQQVGA, kYUV422ColorSpace);
  EXPECT_EQ(image.getSize(), 160U * 120U * 2U);
  EXPECT_EQ(image.getResolution(), kQQVGA);
  EXPECT_EQ(image.getData()[0], 0);
  const ALImage other(3, 5, kBGRColorSpace, false, 0.1F, 0.2F, 0.3F, 0.4F);
  EXPECT_EQ(other.getSize(), 45U);
  EXPECT_EQ(other.getResolution(), -1);
  EXPECT_EQ(other.getBottomAngle(), 0.4F);
  EXPECT_THROW(ALImage(99, kBGRColorSpace), ALError);
  EXPECT_THROW(ALImage(3, 5, 99), ALError);
}

TEST(AlImage, ShowsABufferOfTheProgram) {
  unsigned char buffer[12] = {7};
  ALImage image(2, 2, kRGBColorSpace, true);
  EXPECT_EQ(image.getData(), nullptr);
  image.setData(buffer);
  EXPECT_TRUE(image.areDataExternal());
  EXPECT_EQ(image.getFrame(), buffer);
  EXPECT_EQ(image.toALValue()[6].getSize(), 12U);
  const ALImage copy = image.deepCopy();
  buffer[0] = 8;
  EXPECT_FALSE(copy.areDataExternal());
  EXPECT_EQ(copy.getData()[0], 7);
}

TEST(AlImage, ChangesItsShapeWithinItsRoom) {
  ALImage image(kQVGA, kRGBColorSpace);
  EXPECT_TRUE(image.setResolution(kQQVGA));
  EXPECT_EQ(image.getWidth(), 160);
  EXPECT_TRUE(image.setColorSpace(kYuvColorSpace));
  EXPECT_EQ(image.getNbLayers(), 1);
  EXPECT_FALSE(image.setResolution(k4VGA));
  EXPECT_FALSE(image.setColorSpace(99));
  EXPECT_EQ(image.getHeight(), 120);
  EXPECT_EQ(image.getMaxResolution(), kQVGA);
  EXPECT_EQ(image.getNbOfLayersMax(), 3);
}

TEST(AlImage, CopiesHaveTheirOwnPixels) {
  ALImage image(1, 1, kYuvColorSpace);
  const ALImage before = image;
  image.getData()[0] = 9;
  EXPECT_EQ(before.getData()[0], 0);
}

TEST(AlImage, TimeIsSetInAnyForm) {
  ALImage image(1, 1, kYuvColorSpace);
  image.setTimeStamp(3, 500000);
  EXPECT_EQ(image.getTimeStamp(), 3500000);
  image.setTimeStamp(4500000LL);
  EXPECT_EQ(image.getTimeStampS(), 4);
  qi::os::timeval time;
  time.tv_sec = 5;
  time.tv_usec = 1;
  image.setTimeStamp(time);
  EXPECT_EQ(image.getTimeStamp(), 5000001);
}

TEST(AlImage, KeepsPartsOfInterest) {
  ALImage image(4, 4, kYuvColorSpace);
  image.addROI(ALImage::ROI(1, 2, 2, 1));
  image.setEnableROIs(true);
  ASSERT_EQ(image.getNumOfROIs(), 1);
  EXPECT_EQ(image.getROI(0)->y, 2);
  EXPECT_EQ(image.getROI(1), nullptr);
  image.cleanROIs();
  EXPECT_EQ(image.getNumOfROIs(), 0);
  EXPECT_TRUE(image.isROIEnabled());
}

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(AlImage, IsSavedAsPpm) {
  const nao::TemporaryFolder folder;
  const std::string path = folder.write("image.ppm", "");
  const std::string head = "P6\n2 1\n255\n";
  EXPECT_EQ(ALImage(picture()).savePPM(path.c_str()), 0);
  EXPECT_EQ(contentOf(path), head + std::string(reinterpret_cast<const char*>(kPixels), 6));
  EXPECT_EQ(ALImage(picture(kBGRColorSpace)).savePPM(path.c_str()), 0);
  EXPECT_EQ(contentOf(path), head + std::string("\0\0\xff\xff\0\0", 6));
  EXPECT_EQ(ALImage(1, 1, kYUV422ColorSpace).savePPM(path.c_str()), -1);
  EXPECT_EQ(ALImage(picture()).savePPM("/no/such/folder/image.ppm"), -1);
}

}  // namespace
}  // namespace AL
