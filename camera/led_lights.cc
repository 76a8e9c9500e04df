#include "camera/led_lights.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace nao::camera {
namespace {

// In the frames of their bodies [m]: an eye's middle, how far its lamps stand from it to the side
// and forward, and how large one is; the left one, the right one is mirrored.
const Vec3 kEye(0.043, 0.024, 0.05);
constexpr double kEyeRing = 0.007;
constexpr double kEyeDepth = 0.0085;
constexpr double kEyeLamp = 0.0032;
const Vec3 kEar(-0.005, 0.0625, 0.062);
constexpr double kEarRing = 0.024;
constexpr double kEarLamp = 0.0035;
const Vec3 kChest(0.0499, 0.0016, 0.0552);  // the chest button (NAOqi 2.1 documentation)
constexpr double kChestLamp = 0.012;
const Vec3 kFoot(0.078, 0.0056, -0.012);
constexpr double kFootLamp = 0.008;
constexpr double kHeadLamp = 0.004;

// Turns by 45 and 36 degrees, written out: the C library's sine picks its way by the CPU.
const Eigen::Vector2d kEighth(0.7071067811865476, 0.7071067811865476);
const Eigen::Vector2d kTenth(0.8090169943749475, 0.5877852522924731);

Eigen::Vector2d turned(const Eigen::Vector2d& by, int times) {
  Eigen::Vector2d direction(1, 0);
  for (int i = 0; i < times; ++i) {
    direction = {by.x() * direction.x() - by.y() * direction.y(),
                 by.y() * direction.x() + by.x() * direction.y()};
  }
  return direction;
}

int indexOf(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::array<int, 3> threeColors(const std::vector<std::string>& names, const std::string& before,
                               const std::string& after) {
  return {indexOf(names, before + "Red" + after), indexOf(names, before + "Green" + after),
          indexOf(names, before + "Blue" + after)};
}

std::uint8_t toByte(float brightness) {
  return static_cast<std::uint8_t>(255 * std::clamp(brightness, 0.0F, 1.0F) + 0.5F);
}

}  // namespace

std::vector<LedLights::Lamp> LedLights::lampsOf(const RobotModel& model) {
  std::vector<Lamp> lamps;
  const std::vector<std::string> names = ledNames(model);
  const auto add = [&](const char* body, const Vec3& p_B, double radius, std::array<int, 3> leds) {
    const bool exists = *std::max_element(leds.begin(), leds.end()) >= 0;
    if (const auto number = model.findBody(body); number && exists)
      lamps.push_back({*number, p_B, radius, leds});
  };
  for (const int side : {1, -1}) {
    const std::string word = side > 0 ? "Left/" : "Right/";
    const Vec3 mirror(1, side, 1);
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector2d ring = kEyeRing * turned(kEighth, i);
      add("HeadPitch", kEye.cwiseProduct(mirror) + Vec3(kEyeDepth, ring.x(), ring.y()), kEyeLamp,
          threeColors(names, "Face/Led/", "/" + word + std::to_string(45 * i) + "Deg"));
    }
    for (int i = 0; i < 10; ++i) {
      const Eigen::Vector2d ring = kEarRing * turned(kTenth, i);
      add("HeadPitch", kEar.cwiseProduct(mirror) + Vec3(ring.x(), 0, ring.y()), kEarLamp,
          {-1, -1, indexOf(names, "Ears/Led/" + word + std::to_string(36 * i) + "Deg")});
    }
    for (const auto& [part, x] : {std::pair("Rear/", -0.045), {"Middle/", 0.0}, {"Front/", 0.03}}) {
      for (int i = 0; i < 3; ++i) {
        const double out = 0.012 + 0.012 * i;
        const double z = 0.055 + std::sqrt(std::max(0.0, 0.055 * 0.055 - x * x - out * out));
        add("HeadPitch", Vec3(x, side * out, z), kHeadLamp,
            {-1, -1, indexOf(names, std::string("Head/Led/") + part + word + std::to_string(i))});
      }
    }
    add(side > 0 ? "LAnkleRoll" : "RAnkleRoll", kFoot.cwiseProduct(mirror), kFootLamp,
        threeColors(names, side > 0 ? "LFoot/Led/" : "RFoot/Led/", ""));
  }
  add("Torso", kChest, kChestLamp, threeColors(names, "ChestBoard/Led/", ""));
  return lamps;
}

std::vector<LedLight> LedLights::lit(const std::shared_ptr<const RobotModel>& model,
                                     const LedState& leds) {
  const auto [found, is_new] = lamps_.try_emplace(model);
  if (is_new) found->second = lampsOf(*model);
  std::vector<LedLight> on;
  for (const Lamp& lamp : found->second) {
    std::array<std::uint8_t, 3> rgb = {0, 0, 0};
    for (int c = 0; c < 3; ++c) {
      if (lamp.leds[c] >= 0) rgb[c] = toByte(leds[static_cast<std::size_t>(lamp.leds[c])]);
    }
    if (rgb[0] + rgb[1] + rgb[2] == 0) continue;
    on.push_back({lamp.body, lamp.p_B, lamp.radius, {rgb[0], rgb[1], rgb[2]}});
  }
  return on;
}

}  // namespace nao::camera
