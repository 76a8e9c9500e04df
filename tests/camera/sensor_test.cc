#include "camera/sensor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/check.h"

namespace nao::camera {
namespace {

constexpr ImageSize kSize{64, 48};
constexpr CameraEffects kResponse{true, false, false, false, false, false};
constexpr CameraEffects kNoise{true, true, false, false, false, false};
constexpr CameraEffects kAll{true, true, true, false, false, false};

SimTime at(double seconds) { return SimTime(fromSeconds(seconds)); }

Raster plain(Color color, ImageSize size = kSize) {
  Raster raster;
  raster.reset(size);
  raster.fill(toPixel(color));
  return raster;
}

std::array<double, 3> meanOf(const Raster& raster) {
  std::array<double, 3> sum = {0, 0, 0};
  const ImageSize size = raster.size();
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      for (int c = 0; c < 3; ++c) sum[c] += raster.colors(row)[column] >> (8 * c) & 0xff;
    }
  }
  for (double& value : sum) value /= size.width * size.height;
  return sum;
}

double deviationOf(const Raster& raster) {
  const double mean = meanOf(raster)[1];
  double sum = 0;
  for (int row = 0; row < raster.size().height; ++row) {
    for (int column = 0; column < raster.size().width; ++column) {
      const double off = static_cast<double>(raster.colors(row)[column] >> 8 & 0xff) - mean;
      sum += off * off;
    }
  }
  return std::sqrt(sum / (raster.size().width * raster.size().height));
}

void set(CameraSettings& settings, const SensorType& type, Parameter parameter, int value) {
  ASSERT_TRUE(settings.set(*findParameter(type, static_cast<int>(parameter)), value));
}

/// A grey sheet as this sensor shows it.
std::array<double, 3> sheet(const SensorType& type, const CameraSettings& settings,
                            Color color = {100, 100, 100}, double light = 1) {
  Sensor sensor(type, kResponse, 1);
  Raster picture = plain(color);
  sensor.expose(picture, settings, light, at(1));
  return meanOf(picture);
}

CameraSettings manual(const SensorType& type, int exposure, int gain) {
  CameraSettings settings;
  set(settings, type, Parameter::kAutoExposure, 0);
  set(settings, type, Parameter::kExposure, exposure);
  set(settings, type, Parameter::kGain, gain);
  return settings;
}

TEST(Sensor, WithoutEffectsThePictureIsAsItWas) {
  Sensor sensor(sensorType("MT9M114"), {}, 1);
  Raster picture = plain({10, 120, 250});
  sensor.expose(picture, {}, 0.2, at(0));
  EXPECT_EQ(picture.colors(7)[9], toPixel({10, 120, 250}));
}

TEST(Sensor, UnknownNamesAreTold) { EXPECT_THROW(sensorType("OV9999"), InputError); }

TEST(Sensor, ManualExposureAndGainBrightenAlike) {
  const SensorType& type = sensorType("MT9M114");
  const double once = sheet(type, manual(type, 50, 32))[1];
  const double longer = sheet(type, manual(type, 100, 32))[1];
  const double gained = sheet(type, manual(type, 50, 64))[1];
  EXPECT_NEAR(longer, gained, 0.01);
  // Twice the light is the root of two on the picture, above the black level.
  EXPECT_NEAR((longer - type.black) / (once - type.black), std::sqrt(2.0), 0.05);
}

TEST(Sensor, NeutralExposureShowsMiddleGreyAsItIs) {
  const SensorType& type = sensorType("MT9M114");
  // Black at 4 lifts 100 by 4 * (1 - 100 / 255); whole numbers: 1.
  EXPECT_NEAR(sheet(type, manual(type, 100, 32))[1], 102.4, 1);
}

TEST(Sensor, AutomaticExposureBringsTheSheetToItsAimInAnyLight) {
  for (const char* name : {"OV7670", "MT9M114", "OV5640"}) {
    const SensorType& type = sensorType(name);
    for (const double light : {0.2, 1.0, 5.0}) {
      const double green = type.metered * type.cast[1];
      const double lifted = green + type.black * (1 - green / 255);
      // Whole numbers: of black, of the picture, and of a hundred levels metered.
      EXPECT_NEAR(sheet(type, {}, {100, 100, 100}, light)[1], lifted, 3) << name << light;
    }
  }
}

TEST(Sensor, BrightnessMovesTheAimOfAutomaticExposure) {
  const SensorType& type = sensorType("MT9M114");
  CameraSettings settings;
  set(settings, type, Parameter::kBrightness, 80);
  EXPECT_GT(sheet(type, settings)[1], sheet(type, {})[1] + 20);
}

TEST(Sensor, AutomaticExposureTakesItsTime) {
  const SensorType& type = sensorType("MT9M114");
  Sensor sensor(type, kResponse, 1);
  const auto shown = [&](double light, double time) {
    Raster picture = plain({100, 100, 100});
    sensor.expose(picture, {}, light, at(time));
    return meanOf(picture)[1];
  };
  const double before = shown(1, 0);
  const double first = shown(0.25, 0.033);
  EXPECT_LT(first, 0.7 * before);  // the lamps went out
  double after = 0;
  for (int i = 2; i < 120; ++i) after = shown(0.25, 0.033 * i);
  EXPECT_NEAR(after, before, 2);
}

TEST(Sensor, InTheDarkGainRisesAndWithItTheNoise) {
  const SensorType& type = sensorType("MT9M114");
  const auto noiseIn = [&](double light) {
    Sensor sensor(type, kNoise, 1);
    Raster picture = plain({100, 100, 100}, {640, 480});
    sensor.expose(picture, {}, light, at(1));
    return deviationOf(picture);
  };
  EXPECT_GT(noiseIn(0.05), 1.5 * noiseIn(1));
  // 37 dB over four pixels: 255 / 70.8 / 2 = 1.8, and whole numbers' own 0.3.
  EXPECT_NEAR(noiseIn(1), 1.8, 0.3);
}

TEST(Sensor, NoiseDiffersFromPictureToPictureAndIsTheSameAgain) {
  const auto shown = [](double time, std::uint64_t seed) {
    Sensor sensor(sensorType("MT9M114"), kAll, seed);
    Raster picture = plain({100, 100, 100});
    sensor.expose(picture, {}, 1, at(time));
    return std::vector<Pixel>(picture.colors(0), picture.colors(0) + kSize.width);
  };
  EXPECT_EQ(shown(1, 1), shown(1, 1));
  EXPECT_NE(shown(1, 1), shown(1.1, 1));
  EXPECT_NE(shown(1, 1), shown(1, 2));
}

TEST(Sensor, CornersAreDarkerThanTheMiddle) {
  const SensorType& type = sensorType("OV7670");
  Sensor sensor(type, {false, false, true, false, false, false}, 1);
  Raster picture = plain({200, 200, 200}, {640, 480});
  sensor.expose(picture, {}, 1, at(1));
  const double middle = picture.colors(240)[320] & 0xff;
  const double corner = picture.colors(0)[0] & 0xff;
  EXPECT_NEAR(corner / middle, 1 - type.corner_loss, 0.02);
}

TEST(Sensor, WhiteBalanceByHandWarmsAndCools) {
  const SensorType& type = sensorType("MT9M114");
  CameraSettings settings = manual(type, 100, 32);
  set(settings, type, Parameter::kAutoWhiteBalance, 0);
  set(settings, type, Parameter::kWhiteBalance, 6500);
  const auto warm = sheet(type, settings);
  set(settings, type, Parameter::kWhiteBalance, 2700);
  const auto cool = sheet(type, settings);
  EXPECT_GT(warm[0], warm[2] + 20);
  EXPECT_LT(cool[0], cool[2] - 20);
}

TEST(Sensor, ContrastSaturationAndHueDoAsTheySay) {
  const SensorType& type = sensorType("OV5640");
  CameraSettings settings = manual(type, 275, 16);
  const Color orange{200, 100, 40};
  const auto usual = sheet(type, settings, orange);
  set(settings, type, Parameter::kSaturation, 0);
  const auto grey = sheet(type, settings, orange);
  EXPECT_NEAR(grey[0], grey[2], 1);
  set(settings, type, Parameter::kSaturation, 64);
  set(settings, type, Parameter::kHue, 120);
  const auto turned = sheet(type, settings, orange);
  EXPECT_GT(turned[2] - turned[0], 20);  // no longer orange
  set(settings, type, Parameter::kHue, 0);
  set(settings, type, Parameter::kContrast, 64);
  const auto harder = sheet(type, settings, orange);
  EXPECT_GT(harder[0] - harder[2], 1.5 * (usual[0] - usual[2]));
}

TEST(Sensor, FlipsMirror) {
  const SensorType& type = sensorType("MT9M114");
  Sensor sensor(type, {}, 1);
  CameraSettings settings;
  set(settings, type, Parameter::kHFlip, 1);
  set(settings, type, Parameter::kVFlip, 1);
  Raster picture = plain({0, 0, 0});
  picture.colors(0)[1] = toPixel({9, 9, 9});
  sensor.expose(picture, settings, 1, at(1));
  EXPECT_EQ(picture.colors(47)[62], toPixel({9, 9, 9}));
}

// Figure 29 of the thesis: the same scene differs visibly between a V3.3 and a V4.
TEST(Sensor, V33AndV4ShowTheSameSceneDifferently) {
  const Color orange{255, 120, 0}, carpet{38, 115, 52};
  for (const Color& color : {orange, carpet}) {
    const auto old_one = sheet(sensorType("OV7670"), {}, color);
    const auto new_one = sheet(sensorType("MT9M114"), {}, color);
    double difference = 0;
    for (int c = 0; c < 3; ++c)
      difference = std::max(difference, std::abs(old_one[c] - new_one[c]));
    EXPECT_GT(difference, 12);  // an eye sees 2 of 255 beside each other
  }
}

TEST(Sensor, RangesAreTheSensorsOwn) {
  EXPECT_EQ(findParameter(sensorType("MT9M114"), 0)->max, 255);
  EXPECT_EQ(findParameter(sensorType("OV5640"), 0)->min, -255);
  EXPECT_EQ(findParameter(sensorType("OV7670"), 17)->max, 510);
  EXPECT_EQ(findParameter(sensorType("OV5640"), 11)->initial, 1);
  EXPECT_EQ(findParameter(sensorType("OV5640"), 99), nullptr);
}

}  // namespace
}  // namespace nao::camera
