#pragma once

#include <string>
#include <vector>

namespace nao::wire {

/// One list of lights in LoLA's actuator frame.
struct LolaLeds {
  std::string key;                 // LEye
  std::vector<std::string> names;  // NaoQi's device name of each item: Face/Led/Red/Left/45Deg
};

/// All lists of lights: eyes (eight reds, greens, blues), ears, chest, feet, and the head.
const std::vector<LolaLeds>& lolaLeds();

}  // namespace nao::wire
