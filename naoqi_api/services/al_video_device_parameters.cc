#include "naoqi_api/services/al_video_device_parameters.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace nao::services {
namespace {

constexpr std::int32_t kLowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();

// NaoQi's parameter numbers, with range and default of the MT9M114 from the NAOqi 2.1 pages on
// NAO's cameras; lines from kLowest to kHighest have no published range and default to 0.
constexpr CameraParameter kParameters[] = {
    {0, 0, 255, 55},             // brightness
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
    {17, 1, 2500, 1},            // exposure [0.1 ms]; its default is not published
    {18, 0, 1, 0},               // camera in use
    {19, 0, 1, 0},               // set to defaults
    {20, kLowest, kHighest, 0},  // colour space
    {21, kLowest, kHighest, 0},  // exposure correction
    {22, 0, 3, 1},               // exposure algorithm
    {23, kLowest, kHighest, 0},  // fast switch
    {24, -1, 7, 0},              // sharpness
    {33, 2700, 6500, 2700},      // white balance [K]; its default is not published
    {34, 0, 4, 1},               // backlight compensation
    {35, 0, 1, 0},               // keep alive
    {39, 0, 255, 0},             // average luminance
    {40, 0, 1, 0},               // automatic focus
    {43, 0, 250, 0},             // focus
};

}  // namespace

const CameraParameter* findCameraParameter(int id) {
  const auto found = std::find_if(std::begin(kParameters), std::end(kParameters),
                                  [&](const CameraParameter& known) { return known.id == id; });
  return found == std::end(kParameters) ? nullptr : found;
}

std::int32_t CameraParameters::get(const CameraParameter& parameter) const {
  const auto found = values_.find(parameter.id);
  return found == values_.end() ? parameter.initial : found->second;
}

bool CameraParameters::set(const CameraParameter& parameter, std::int32_t value) {
  if (value < parameter.min || value > parameter.max) return false;
  values_[parameter.id] = value;
  return true;
}

}  // namespace nao::services
