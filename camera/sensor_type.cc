#include "camera/sensor_type.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "core/check.h"

namespace nao::camera {
namespace {

// Sources. Signal to noise, number of pixels and the relation of sensitivities: data sheets, for
// the OV7670 46 dB and 1.3 V/(lux s), for the MT9M114 37 dB and 2.24 V/(lux s) (also on NAOqi's
// pages), for the OV5640 36 dB and 0.6 V/(lux s); what a less sensitive one lacks it makes up by
// exposure. Readout: one frame of 1/30 s, less the rows that are not shown. Exposure units: a row
// (OV7670, 510 a frame; OV5640, 984), 0.1 ms (MT9M114, NAOqi 2.1). The rest are free choices by
// eye, so that pictures of a V3.3 are paler, darker in their corners and slightly green beside
// those of a V4, as in figure 29 of van Noort's thesis.
constexpr double kFrame = 1.0 / 30;  // [s]
constexpr SensorType kTypes[] = {
    {"OV7670",
     1,
     kFrame / 510,
     0.0172,
     kFrame,
     16,
     8,
     102,
     200,
     640 * 480,
     0.20,
     0.78,
     16,
     {0.98, 1.05, 0.97},
     kFrame * 480 / 510},
    {"MT9M114",
     2,
     1e-4,
     0.010,
     kFrame,
     32,
     8,
     100,
     70.8,
     1280 * 960,
     0.15,
     1.0,
     4,
     {1, 1, 1},
     kFrame * 960 / 990},
    {"OV5640",
     3,
     kFrame / 984,
     0.0373 / 4,
     kFrame,
     16,
     16,
     104,
     63.1,
     2592 * 1944,
     0.15,
     1.05,
     2,
     {1.01, 1, 1},
     kFrame * 960 / 984},
};

constexpr std::int32_t kLowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();

// NaoQi's parameters, for all sensors; lines from kLowest to kHighest have no published range and
// default to 0. A sensor's own lines below go before these, which are those of the MT9M114 from
// the NAOqi 2.1 pages on NAO's cameras.
constexpr ParameterRange kCommon[] = {
    {0, 0, 255, 55},             // brightness: what automatic exposure aims at
    {1, 16, 64, 32},             // contrast
    {2, 0, 255, 128},            // saturation
    {3, -180, 180, 0},           // hue
    {4, kLowest, kHighest, 0},   // red chroma
    {5, kLowest, kHighest, 0},   // blue chroma
    {6, 32, 255, 32},            // gain
    {7, 0, 1, 0},                // horizontal flip
    {8, 0, 1, 0},                // vertical flip
    {9, kLowest, kHighest, 0},   // lens x
    {10, kLowest, kHighest, 0},  // lens y
    {11, 0, 1, 1},               // automatic exposure
    {12, 0, 1, 1},               // automatic white balance
    {13, kLowest, kHighest, 0},  // automatic gain
    {14, 0, 8, 1},               // resolution
    {15, 1, 30, 5},              // frame rate
    {16, kLowest, kHighest, 0},  // buffer size
    {17, 1, 2500, 100},          // exposure [0.1 ms]; its default is not published
    {18, 0, 1, 0},               // camera in use
    {19, 0, 1, 0},               // set to defaults
    {20, kLowest, kHighest, 0},  // colour space
    {21, kLowest, kHighest, 0},  // exposure correction
    {22, 0, 3, 1},               // exposure algorithm
    {23, kLowest, kHighest, 0},  // fast switch
    {24, -1, 7, 0},              // sharpness
    {33, 2700, 6500, 4500},      // white balance [K]; its default is not published
    {34, 0, 4, 1},               // backlight compensation
    {35, 0, 1, 0},               // keep alive
    {39, 0, 255, 0},             // average luminance
    {40, 0, 1, 0},               // automatic focus
    {43, 0, 250, 0},             // focus
};

// Widths of the OV7670's registers, as its Linux driver offers them; no page of NAOqi 1.14 with
// its ranges was found.
constexpr ParameterRange kOv7670[] = {
    {0, 0, 255, 128}, {1, 0, 127, 64}, {6, 0, 255, 16}, {17, 0, 510, 255}, {24, 0, 31, 0},
};

// NAOqi 2.8, pages on the V6's cameras.
constexpr ParameterRange kOv5640[] = {
    {0, -255, 255, 0}, {1, 0, 255, 32},    {2, 0, 255, 64}, {6, 0, 1023, 16},
    {14, 0, 4, 1},     {17, 0, 65535, 32}, {24, 0, 9, 4},   {34, 0, 1, 0},
};

template <std::size_t count>
const ParameterRange* findIn(const ParameterRange (&list)[count], int id) {
  const auto found = std::find_if(std::begin(list), std::end(list),
                                  [&](const ParameterRange& known) { return known.id == id; });
  return found == std::end(list) ? nullptr : found;
}

}  // namespace

const SensorType& sensorType(const std::string& name) {
  for (const SensorType& type : kTypes) {
    if (name == type.name) return type;
  }
  throw InputError("camera sensor '" + name + "': expected OV7670, MT9M114 or OV5640");
}

const SensorType& sensorOf(const RobotModel& robot, const CameraModel& camera) {
  if (!camera.sensor.empty()) return sensorType(camera.sensor);
  const char generation = robot.version.size() > 1 ? robot.version[1] : '4';  // of "V3.3"
  return kTypes[generation <= '3' ? 0 : generation >= '6' ? 2 : 1];
}

const ParameterRange* findParameter(const SensorType& sensor, int id) {
  const ParameterRange* own = nullptr;
  if (sensor.naoqi_model == 1) own = findIn(kOv7670, id);
  if (sensor.naoqi_model == 3) own = findIn(kOv5640, id);
  return own != nullptr ? own : findIn(kCommon, id);
}

}  // namespace nao::camera
