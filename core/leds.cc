#include "core/leds.h"

#include <algorithm>
#include <cstdlib>

#include "core/check.h"
#include "core/robot_model.h"

namespace nao {
namespace {

constexpr std::array<const char*, 2> kSides = {"Left", "Right"};
constexpr std::array<const char*, 3> kColors = {"Red", "Green", "Blue"};

using Names = std::vector<std::string>;

void addFace(Names& names) {
  for (const std::string side : kSides) {
    for (const std::string color : kColors) {
      for (int angle = 0; angle < 360; angle += 45) {
        names.push_back("Face/Led/" + color + "/" + side + "/" + std::to_string(angle) + "Deg");
      }
    }
    for (int angle = 0; angle < 360; angle += 36) {
      names.push_back("Ears/Led/" + side + "/" + std::to_string(angle) + "Deg");
    }
  }
}

void addHead(Names& names) {
  for (const std::string side : kSides) {
    for (const char* number : {"0", "1", "2"}) {
      names.push_back("Head/Led/Rear/" + side + "/" + number);
    }
    for (const char* number : {"0", "1"}) {
      names.push_back("Head/Led/Front/" + side + "/" + number);
    }
    names.push_back("Head/Led/Middle/" + side + "/0");
  }
}

// 3.3 of "V3.3"; 0 if the file says something else.
double versionOf(const RobotModel& model) {
  const std::string& text = model.version;
  return text.empty() || text[0] != 'V' ? 0 : std::strtod(text.c_str() + 1, nullptr);
}

// A light belongs to a group if its name has both of these in it.
struct Group {
  const char* name;
  const char* part;
  const char* other = "";
};
constexpr Group kGroups[] = {
    {"AllLeds", "Led/"},
    {"FaceLeds", "Face/"},
    {"LeftFaceLeds", "Face/", "/Left/"},
    {"RightFaceLeds", "Face/", "/Right/"},
    {"EarLeds", "Ears/"},
    {"LeftEarLeds", "Ears/", "/Left/"},
    {"RightEarLeds", "Ears/", "/Right/"},
    {"ChestLeds", "ChestBoard/"},
    {"FeetLeds", "Foot/"},
    {"LeftFootLeds", "LFoot/"},
    {"RightFootLeds", "RFoot/"},
    {"BrainLeds", "Head/"},
    {"BrainLedsFront", "Head/", "/Front/"},
    {"BrainLedsMiddle", "Head/", "/Middle/"},
    {"BrainLedsBack", "Head/", "/Rear/"},
    {"BrainLedsLeft", "Head/", "/Left/"},
    {"BrainLedsRight", "Head/", "/Right/"},
};

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

std::vector<std::string> ledNames(const RobotModel& model) {
  Names names;
  if (model.feet.size() != 2) return names;
  addFace(names);
  constexpr double kFirstWithHeadLeds = 4.0;
  if (versionOf(model) >= kFirstWithHeadLeds) addHead(names);
  for (const std::string device : {"ChestBoard", "LFoot", "RFoot"}) {
    for (const char* color : kColors) names.push_back(device + "/Led/" + color);
  }
  NAO_CHECK(names.size() <= kMaxLeds);
  return names;
}

std::vector<std::size_t> findLeds(const std::vector<std::string>& names,
                                  const std::string& wanted) {
  const Group* group = std::find_if(std::begin(kGroups), std::end(kGroups),
                                    [&](const Group& g) { return wanted == g.name; });
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool meant = group != std::end(kGroups)
                           ? contains(names[i], group->part) && contains(names[i], group->other)
                           : names[i] == wanted || names[i].rfind(wanted + "/", 0) == 0;
    if (meant) found.push_back(i);
  }
  return found;
}

}  // namespace nao
