#include "naoqi_api/wire/lola_leds.h"

namespace nao::wire {
namespace {

using Names = std::vector<std::string>;

// The left eye goes round the other way, from 45 degrees down; so does the right ear.
Names eye(const std::string& side, int first, int step) {
  Names names;
  for (const std::string color : {"Red", "Green", "Blue"}) {
    for (int i = 0; i < 8; ++i) {
      const int angle = (first + i * step + 360) % 360;
      names.push_back("Face/Led/" + color + "/" + side + "/" + std::to_string(angle) + "Deg");
    }
  }
  return names;
}

Names ear(const std::string& side, int first, int step) {
  Names names;
  for (int i = 0; i < 10; ++i) {
    names.push_back("Ears/Led/" + side + "/" + std::to_string(first + i * step) + "Deg");
  }
  return names;
}

Names colors(const std::string& device) {
  return {device + "/Led/Red", device + "/Led/Green", device + "/Led/Blue"};
}

Names skull() {
  Names names;
  for (const char* place : {"Front/Left/1", "Front/Left/0", "Middle/Left/0", "Rear/Left/0",
                            "Rear/Left/1", "Rear/Left/2", "Rear/Right/2", "Rear/Right/1",
                            "Rear/Right/0", "Middle/Right/0", "Front/Right/0", "Front/Right/1"}) {
    names.push_back(std::string("Head/Led/") + place);
  }
  return names;
}

}  // namespace

const std::vector<LolaLeds>& lolaLeds() {
  static const std::vector<LolaLeds> kLeds{
      {"LEar", ear("Left", 0, 36)},    {"REar", ear("Right", 324, -36)},
      {"LEye", eye("Left", 45, -45)},  {"REye", eye("Right", 0, 45)},
      {"Chest", colors("ChestBoard")}, {"Skull", skull()},
      {"LFoot", colors("LFoot")},      {"RFoot", colors("RFoot")}};
  return kLeds;
}

}  // namespace nao::wire
