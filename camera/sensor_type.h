#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/robot_model.h"

namespace nao::camera {

/// What a parameter of a NaoQi camera accepts.
struct ParameterRange {
  int id = 0;
  std::int32_t min = 0;
  std::int32_t max = 0;
  std::int32_t initial = 0;
};

/// NaoQi's numbers of the parameters that change pictures.
enum class Parameter {
  kBrightness = 0,
  kContrast = 1,
  kSaturation = 2,
  kHue = 3,
  kGain = 6,
  kHFlip = 7,
  kVFlip = 8,
  kAutoExposure = 11,
  kAutoWhiteBalance = 12,
  kExposure = 17,
  kWhiteBalance = 33
};

/// How an image sensor answers to light. Strengths are on the picture's own scale, 0 to 255, where
/// a signal of 1 shows a white sheet in a usual hall as white.
struct SensorType {
  const char* name;
  int naoqi_model;          // kOV7670 1, kMT9M114 2, kOV5640 3
  double exposure_unit;     // [s] of the parameter "exposure"
  double neutral_exposure;  // [s] at unit gain that gives a signal of 1 in a usual hall
  double longest_exposure;  // [s] that automatic exposure takes
  double unit_gain;         // the parameter "gain" for a gain of 1
  double largest_gain;      // that automatic exposure takes
  double metered;           // mean brightness automatic exposure aims at, 0 to 255
  double signal_to_noise;   // standard deviations in white at unit gain, all pixels
  int pixels;           // of the whole sensor; up to four are averaged where a picture has fewer
  double corner_loss;   // part of the light that the lens loses in the corners
  double colorfulness;  // of its pictures, part of the scene's
  double black;         // what no light at all shows as, 0 to 255
  std::array<double, 3> cast;  // red, green, blue left over when white is balanced
  double readout;              // [s] from the first to the last row
};

/// The type of this name; what a robot's cameras have when it is empty. @throws InputError for a
/// name that is not known.
const SensorType& sensorType(const std::string& name);

/// The sensor of a robot's camera: the one it names, else that of the robot's version.
const SensorType& sensorOf(const RobotModel& robot, const CameraModel& camera);

/// What this sensor's parameter of that NaoQi number takes, or null. A parameter without a
/// published range accepts every number.
const ParameterRange* findParameter(const SensorType& sensor, int id);

}  // namespace nao::camera
