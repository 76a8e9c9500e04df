#include "naoqi_api/wire/lola_sensors.h"

#include <cstdint>
#include <cstring>
#include <utility>

#include "core/check.h"

namespace nao::wire {
namespace {

constexpr double kNewtonPerKg = 9.80665;  // force sensors tell the weight
constexpr char kVersion[] = "6.0.0";
// 0x803C as an int16: not charging, by either of the two bits that clients look at.
constexpr double kNotCharging = -32708;

constexpr int kFixMap = 0x80;
constexpr int kFixArray = 0x90;
constexpr int kFixText = 0xa0;
constexpr int kArray16 = 0xdc;
constexpr int kFloat32 = 0xca;

std::string idOf(const char* part, std::size_t number) {
  constexpr std::size_t kLetters = 20;
  const std::string name = std::string("UsarNaoQi") + part;
  const std::string digits = std::to_string(number);
  NAO_CHECK(name.size() + digits.size() <= kLetters);
  return name + std::string(kLetters - name.size() - digits.size(), '0') + digits;
}

}  // namespace

LolaIdentity lolaIdentity(std::size_t number) {
  return {idOf("Body", number), idOf("Head", number)};
}

LolaSensors::LolaSensors(const RobotModel& model, LolaIdentity identity, LolaBattery battery)
    : identity_(std::move(identity)), battery_(battery) {
  for (std::size_t i = 0; i < joints_.size(); ++i) joints_[i] = model.findJoint(kLolaJoints[i]);
  bytes_.reserve(kSize);
}

const std::string& LolaSensors::encode(const SensorFrame& frame, const JointCommand& command) {
  bytes_.assign(1, static_cast<char>(kFixMap | 13));
  joints("Stiffness", [&](Joint joint) { return command.stiffness[joint]; });
  joints("Position", [&](Joint joint) { return frame.angle[joint]; });
  joints("Temperature", [&](Joint joint) { return frame.temperature[joint]; });
  joints("Current", [&](Joint joint) { return frame.current[joint]; });
  battery(frame.battery);
  numbers("Accelerometer",
          std::array{frame.accelerometer.x(), frame.accelerometer.y(), frame.accelerometer.z()});
  numbers("Gyroscope", std::array{frame.gyroscope.x(), frame.gyroscope.y(), frame.gyroscope.z()});
  numbers("Angles", std::array{frame.angle_x, frame.angle_y});
  numbers("Sonar", std::array{frame.sonar[0][0], frame.sonar[1][0]});
  std::array<double, 8> weights{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = frame.feet[i / 4].force[i % 4] / kNewtonPerKg;
  }
  numbers("FSR", weights);
  status(frame);
  touch(frame);
  robotConfig();
  NAO_CHECK(bytes_.size() == kSize);
  return bytes_;
}

void LolaSensors::key(const char* name) {
  const std::size_t size = std::strlen(name);
  bytes_.push_back(static_cast<char>(kFixText | size));
  bytes_.append(name, size);
}

void LolaSensors::number(double value) {
  const auto narrow = static_cast<float>(value);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &narrow, sizeof bits);
  const char big_endian[] = {static_cast<char>(kFloat32), static_cast<char>(bits >> 24U),
                             static_cast<char>(bits >> 16U), static_cast<char>(bits >> 8U),
                             static_cast<char>(bits)};
  bytes_.append(big_endian, sizeof big_endian);
}

template <class Read>
void LolaSensors::joints(const char* name, const Read& read) {
  key(name);
  bytes_.append({static_cast<char>(kArray16), 0, static_cast<char>(joints_.size())});
  for (const auto& joint : joints_) number(joint ? read(*joint) : 0);
}

template <class Values>
void LolaSensors::numbers(const char* name, const Values& values) {
  key(name);
  bytes_.push_back(static_cast<char>(kFixArray | values.size()));
  for (const double value : values) number(value);
}

void LolaSensors::status(const SensorFrame& frame) {
  key("Status");
  bytes_.append({static_cast<char>(kArray16), 0, static_cast<char>(joints_.size())});
  for (const auto& joint : joints_) {
    bytes_.push_back(joint ? static_cast<char>(frame.overheating[*joint]) : '\0');
  }
}

void LolaSensors::battery(const BatteryState& state) {
  const bool status_first = battery_ == LolaBattery::StatusFirst;
  numbers("Battery", std::array{state.charge, status_first ? kNotCharging : state.current,
                                status_first ? state.current : kNotCharging, state.temperature});
}

void LolaSensors::touch(const SensorFrame& frame) {
  const TouchState& touch = frame.touch;
  std::array<double, 14> touched{};
  auto next = touched.begin();
  *next++ = touch.chest_button ? 1 : 0;
  for (const bool head : touch.head) *next++ = head ? 1 : 0;
  for (std::size_t side = 0; side < 2; ++side) {
    // Bumpers are the foot's left and right, and a hand says back, left, right.
    for (const bool bumper : frame.feet[side].bumper) *next++ = bumper ? 1 : 0;
    for (const std::size_t part : {1, 0, 2}) *next++ = touch.hand[side][part] ? 1 : 0;
  }
  numbers("Touch", touched);
}

void LolaSensors::robotConfig() {
  key("RobotConfig");
  bytes_.push_back(static_cast<char>(kFixArray | 4));
  for (const std::string& text :
       {identity_.body, std::string(kVersion), identity_.head, std::string(kVersion)}) {
    key(text.c_str());
  }
}

}  // namespace nao::wire
