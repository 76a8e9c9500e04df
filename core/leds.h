#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace nao {

struct RobotModel;

/// How bright each light of a robot is: 0 dark to 1, in the order of ledNames(). A plain value.
inline constexpr std::size_t kMaxLeds = 96;  // a Nao V4 has 89
using LedState = std::array<float, kMaxLeds>;

/// NaoQi's device names of a robot's lights, e.g. "Face/Led/Red/Left/45Deg": eyes of eight sectors
/// in three colours, ears of ten in blue, chest and feet in three colours and, from V4 on, twelve
/// on the head (NAOqi 2.1.4.13 documentation, leds and actuator_sensor_names). None: no Nao.
std::vector<std::string> ledNames(const RobotModel& model);

/// Which of `names` are meant by `wanted`: one of them, a folder of them ("Face/Led/Red"), or a
/// whole part of the body by ALLeds' name for it: AllLeds, [Left|Right]FaceLeds, [Left|Right]
/// EarLeds, ChestLeds, FeetLeds, LeftFootLeds, RightFootLeds, BrainLeds[Front|Middle|Back|Left|
/// Right]. Empty: none.
std::vector<std::size_t> findLeds(const std::vector<std::string>& names, const std::string& wanted);

/// What the control side wants lit; taken over at the robot's next cycle.
struct LedOrder {
  std::string leds;      // see findLeds()
  float brightness = 0;  // 0 to 1
};

}  // namespace nao
