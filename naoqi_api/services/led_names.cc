#include "naoqi_api/services/led_names.h"

#include <algorithm>
#include <regex>
#include <set>

#include "core/leds.h"

namespace nao::services {
namespace {

constexpr int kEyeSector = 45;  // [deg]
constexpr int kEarSector = 36;  // [deg]

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Those with all of these in their names.
std::vector<std::size_t> withParts(const std::vector<std::string>& lights,
                                   const std::vector<std::string>& parts) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const bool has_all = std::all_of(parts.begin(), parts.end(), [&](const std::string& part) {
      return contains(lights[i], part);
    });
    if (has_all) found.push_back(i);
  }
  return found;
}

std::vector<std::size_t> sector(const std::vector<std::string>& lights, const std::string& part,
                                const std::string& side, int angle) {
  std::vector<std::string> parts = {part, "/" + std::to_string(angle) + "Deg"};
  if (!side.empty()) parts.push_back("/" + side + "/");
  return withParts(lights, parts);
}

// Which eighths of an eye are its top, bottom, and the sides towards the nose and the ear. The left
// eye is the right one's mirror image. Free: the documentation shows them in a picture.
std::vector<int> eighthsOf(const std::string& place, bool left) {
  if (place == "Top") return {0, 1, 7};
  if (place == "Bottom") return {3, 4, 5};
  return (place == "Internal") == left ? std::vector<int>{5, 6, 7} : std::vector<int>{1, 2, 3};
}

std::vector<std::size_t> eyePlace(const std::vector<std::string>& lights, const std::string& side,
                                  const std::string& place) {
  std::set<std::size_t> found;
  for (const std::string eye : {"Left", "Right"}) {
    if (!side.empty() && side != eye) continue;
    for (const int eighth : eighthsOf(place, eye == "Left")) {
      for (const std::size_t light : sector(lights, "Face/", eye, eighth * kEyeSector)) {
        found.insert(light);
      }
    }
  }
  return {found.begin(), found.end()};
}

std::vector<std::size_t> sectorNamed(const std::vector<std::string>& lights,
                                     const std::string& name) {
  static const std::regex eye_from_1("(Left|Right)FaceLed([1-8])");
  static const std::regex eye_from_0("FaceLed(Left|Right)?([0-7])");
  static const std::regex ear("(Left|Right)EarLed([1-9]|10)");
  static const std::regex place("FaceLeds(Left|Right)?(Top|Bottom|Internal|External)");
  std::smatch match;
  if (std::regex_match(name, match, eye_from_1)) {
    return sector(lights, "Face/", match[1], (std::stoi(match[2]) - 1) * kEyeSector);
  }
  if (std::regex_match(name, match, eye_from_0)) {
    return sector(lights, "Face/", match[1], std::stoi(match[2]) * kEyeSector);
  }
  if (std::regex_match(name, match, ear)) {
    return sector(lights, "Ears/", match[1], (std::stoi(match[2]) - 1) * kEarSector);
  }
  if (std::regex_match(name, match, place)) return eyePlace(lights, match[1], match[2]);
  return {};
}

// A device's name without the folders before it and "/Actuator/Value" after it.
std::string bareDevice(std::string name) {
  const std::string before = "Device/SubDeviceList/";
  const std::string after = "/Actuator/Value";
  if (name.rfind(before, 0) == 0) name.erase(0, before.size());
  if (endsWith(name, after)) name.erase(name.size() - after.size());
  return name;
}

}  // namespace

std::vector<std::size_t> findLedsNamed(const std::vector<std::string>& lights,
                                       const std::string& name) {
  auto found = findLeds(lights, bareDevice(name));
  if (!found.empty()) return found;
  found = sectorNamed(lights, name);
  if (!found.empty()) return found;
  for (const std::string color : {"Red", "Green", "Blue"}) {
    if (!endsWith(name, color)) continue;
    std::vector<std::size_t> of_color;
    for (const std::size_t light :
         findLedsNamed(lights, name.substr(0, name.size() - color.size()))) {
      if (contains(lights[light], "/" + color)) of_color.push_back(light);
    }
    return of_color;
  }
  return {};
}

std::vector<std::string> ledGroupNames() {
  std::vector<std::string> names = {
      "AllLeds",        "AllLedsRed",      "AllLedsGreen",     "AllLedsBlue",     "FaceLeds",
      "LeftFaceLeds",   "RightFaceLeds",   "EarLeds",          "LeftEarLeds",     "RightEarLeds",
      "ChestLeds",      "FeetLeds",        "LeftFootLeds",     "RightFootLeds",   "BrainLeds",
      "BrainLedsFront", "BrainLedsMiddle", "BrainLedsBack",    "BrainLedsLeft",   "BrainLedsRight",
      "FaceLedsTop",    "FaceLedsBottom",  "FaceLedsInternal", "FaceLedsExternal"};
  for (const std::string side : {"", "Left", "Right"}) {
    for (int i = 0; i < 8; ++i) names.push_back("FaceLed" + side + std::to_string(i));
  }
  return names;
}

}  // namespace nao::services
