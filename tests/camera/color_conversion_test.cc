#include "camera/color_conversion.h"

#include <gtest/gtest.h>

namespace nao::camera {
namespace {

Raster twoPixels(Color first, Color second) {
  Raster raster;
  raster.reset({2, 1});
  raster.colors(0)[0] = toPixel(first);
  raster.colors(0)[1] = toPixel(second);
  return raster;
}

constexpr Color kRed{255, 0, 0};
constexpr Color kOrange{255, 120, 0};

// Known values of JFIF's full-range BT.601, rounded.
TEST(ColorConversion, YuvOfKnownColors) {
  EXPECT_EQ(toYuv({0, 0, 0}), (Triple{0, 128, 128}));
  EXPECT_EQ(toYuv({255, 255, 255}), (Triple{255, 128, 128}));
  EXPECT_EQ(toYuv(kRed), (Triple{76, 85, 255}));
  EXPECT_EQ(toYuv({0, 255, 0}), (Triple{150, 44, 21}));
  EXPECT_EQ(toYuv({0, 0, 255}), (Triple{29, 255, 107}));
}

TEST(ColorConversion, YuvIsWithinOneOfTheFormulaForEveryColor) {
  for (int r = 0; r <= 255; r += 15) {
    for (int g = 0; g <= 255; g += 15) {
      for (int b = 0; b <= 255; b += 15) {
        const Triple yuv = toYuv({std::uint8_t(r), std::uint8_t(g), std::uint8_t(b)});
        const double y = .299 * r + .587 * g + .114 * b;
        // 0.51: rounding to a whole number, and the 16 bits of the weights.
        EXPECT_NEAR(yuv[0], y, 0.51);
        EXPECT_NEAR(yuv[1], std::min(255.0, 128 + (b - y) * .5 / (1 - .114)), 0.51);
        EXPECT_NEAR(yuv[2], std::min(255.0, 128 + (r - y) * .5 / (1 - .299)), 0.51);
      }
    }
  }
}

TEST(ColorConversion, HsyOfKnownColors) {
  EXPECT_EQ(toHsy(kRed), (Triple{0, 255, 76}));
  EXPECT_EQ(toHsy({0, 255, 0})[0], 85);
  EXPECT_EQ(toHsy({0, 0, 255})[0], 170);
  EXPECT_EQ(toHsy({255, 0, 255})[0], 213);
  EXPECT_EQ(toHsy({90, 90, 90}), (Triple{0, 0, 90}));
  EXPECT_EQ(toHsy({0, 0, 0}), (Triple{0, 0, 0}));
}

TEST(ColorConversion, HueAloneIsAPureColor) {
  EXPECT_EQ(toPureHue({128, 0, 0}), (Triple{255, 0, 0}));
  EXPECT_EQ(toPureHue({90, 90, 90}), (Triple{255, 0, 0}));
  const Triple orange = toPureHue({128, 60, 0});  // 60 / 128 of the way to yellow
  EXPECT_NEAR(orange[1], 120, 6);                 // a hue of one byte has steps of 6
  const Triple blue = toPureHue({10, 10, 200});
  EXPECT_LE(blue[0] + blue[1], 6);
  EXPECT_EQ(toHueSaturation({0, 255, 0}), (Triple{85, 255, 170}));
}

// The fast way over eight pixels against the plain formula, also for what does not fill eight.
TEST(ColorConversion, Yuv422OfLongRowsIsThePairsFormula) {
  Raster raster;
  raster.reset({22, 1});
  for (int i = 0; i < 22; ++i) raster.colors(0)[i] = 0xff000000u | (i * 0x1b7a35u & 0xffffffu);
  const Bytes bytes = toBytes(raster, ColorSpace::kYUV422);
  for (int i = 0; i < 22; i += 2) {
    const auto yuv = [&](int at) {
      const Pixel p = raster.colors(0)[at];
      return toYuv({std::uint8_t(p), std::uint8_t(p >> 8), std::uint8_t(p >> 16)});
    };
    const Triple a = yuv(i), b = yuv(i + 1);
    EXPECT_EQ(bytes[2 * i], a[0]) << i;
    EXPECT_EQ(bytes[2 * i + 1], (a[1] + b[1] + 1) / 2) << i;
    EXPECT_EQ(bytes[2 * i + 2], b[0]) << i;
    EXPECT_EQ(bytes[2 * i + 3], (a[2] + b[2] + 1) / 2) << i;
  }
}

TEST(ColorConversion, BytesOfRgbAndBgrAreMirrored) {
  const Raster raster = twoPixels({1, 2, 3}, {4, 5, 6});
  EXPECT_EQ(toBytes(raster, ColorSpace::kRGB), (Bytes{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(toBytes(raster, ColorSpace::kBGR), (Bytes{3, 2, 1, 6, 5, 4}));
}

TEST(ColorConversion, SingleChannelsPickTheirCapital) {
  const Raster raster = twoPixels(kRed, {4, 5, 6});
  EXPECT_EQ(toBytes(raster, ColorSpace::kRgb), (Bytes{255, 4}));
  EXPECT_EQ(toBytes(raster, ColorSpace::krGb), (Bytes{0, 5}));
  EXPECT_EQ(toBytes(raster, ColorSpace::krgB), (Bytes{0, 6}));
  EXPECT_EQ(toBytes(raster, ColorSpace::kYuv)[0], 76);
  EXPECT_EQ(toBytes(raster, ColorSpace::kyUv)[0], 85);
  EXPECT_EQ(toBytes(raster, ColorSpace::kyuV)[0], 255);
  EXPECT_EQ(toBytes(raster, ColorSpace::khSy)[0], 255);
}

TEST(ColorConversion, Yuv422InterleavesAndSharesTheMeanChroma) {
  const Raster raster = twoPixels(kRed, {255, 255, 255});
  // U: (85 + 128 + 1) / 2, V: (255 + 128 + 1) / 2.
  EXPECT_EQ(toBytes(raster, ColorSpace::kYUV422), (Bytes{76, 107, 255, 192}));
  EXPECT_EQ(toBytes(raster, ColorSpace::kYYCbCr), (Bytes{76, 255, 107, 192}));
}

TEST(ColorConversion, EveryColorSpaceFillsItsLayers) {
  const Raster raster = twoPixels(kOrange, kRed);
  for (int id = 0; id <= 16; ++id) {
    const ColorSpace space = *toColorSpace(id);
    EXPECT_EQ(toBytes(raster, space).size(), 2u * layers(space)) << id;
  }
}

TEST(Pixel, BlendIsExactAtBothEndsAndHalfInTheMiddle) {
  const Pixel black = toPixel({0, 0, 0});
  const Pixel color = toPixel({200, 100, 51});
  EXPECT_EQ(blend(black, color, 0), black);
  EXPECT_EQ(blend(black, color, 256), color);
  EXPECT_EQ(blend(black, color, 128), toPixel({100, 50, 26}));
}

}  // namespace
}  // namespace nao::camera
