#include "validation/log/memory_columns.h"

#include <array>
#include <string_view>
#include <utility>

namespace nao::validation {
namespace {

using std::string_view;

constexpr string_view kDevices = "Device/SubDeviceList/";
constexpr double kNewtonPerKg = 9.80665;  // force sensors are in kg of weight

// Behind a joint's name.
constexpr std::array<std::pair<string_view, const char*>, 5> kOfJoint{{
    {"/Position/Actuator/Value", "cmd."},
    {"/Position/Sensor/Value", "q."},
    {"/Hardness/Actuator/Value", "cmd_stiffness."},
    {"/ElectricCurrent/Sensor/Value", "cur."},
    {"/Temperature/Sensor/Value", "temp."},
}};

// Behind InertialSensor/, before the axis; the short names are those of NAOqi 1.x.
constexpr std::array<std::pair<string_view, const char*>, 5> kOfImu{{
    {"Accelerometer", "imu.acc."},
    {"Acc", "imu.acc."},
    {"Gyroscope", "imu.gyr."},
    {"Gyr", "imu.gyr."},
    {"Angle", "imu.ang."},
}};

constexpr std::array<std::pair<string_view, const char*>, 4> kCells{
    {{"FrontLeft", "fl"}, {"FrontRight", "fr"}, {"RearLeft", "rl"}, {"RearRight", "rr"}}};

bool takePrefix(string_view& text, string_view prefix) {
  if (text.substr(0, prefix.size()) != prefix) return false;
  text.remove_prefix(prefix.size());
  return true;
}

bool takeSuffix(string_view& text, string_view suffix) {
  if (text.size() < suffix.size()) return false;
  if (text.substr(text.size() - suffix.size()) != suffix) return false;
  text.remove_suffix(suffix.size());
  return true;
}

std::optional<MemoryColumn> findImuColumn(string_view name) {
  if (!takeSuffix(name, "/Sensor/Value")) return {};
  for (const auto& [signal, column] : kOfImu) {
    string_view axis = name;
    if (!takePrefix(axis, signal) || axis.size() != 1) continue;
    if (axis[0] < 'X' || axis[0] > 'Z') continue;
    return MemoryColumn{std::string(column) + static_cast<char>(axis[0] - 'X' + 'x'), 1};
  }
  return {};
}

std::optional<MemoryColumn> findForceColumn(string_view name) {
  const bool left = takePrefix(name, "LFoot/FSR/");
  if (!left && !takePrefix(name, "RFoot/FSR/")) return {};
  for (const auto& [cell, column] : kCells) {
    if (name != std::string(cell) + "/Sensor/Value") continue;
    return MemoryColumn{std::string(left ? "fsr.L." : "fsr.R.") + column, kNewtonPerKg};
  }
  return {};
}

}  // namespace

std::optional<MemoryColumn> findMemoryColumn(const std::string& key) {
  string_view name = key;
  if (!takePrefix(name, kDevices)) return {};
  if (name == "Battery/Current/Sensor/Value") return MemoryColumn{"bat.i", 1};
  if (takePrefix(name, "InertialSensor/")) return findImuColumn(name);
  if (name.find("/FSR/") != string_view::npos) return findForceColumn(name);
  for (const auto& [signal, column] : kOfJoint) {
    string_view joint = name;
    if (!takeSuffix(joint, signal) || joint.find('/') != string_view::npos) continue;
    if (joint == "Battery" || joint == "Head") continue;
    return MemoryColumn{column + std::string(joint), 1};
  }
  return {};
}

std::string findColumnJoint(const std::string& column) {
  for (const char* signal : {"cmd.", "cmd_stiffness.", "q.", "qd.", "cur.", "tau.", "temp."}) {
    if (column.rfind(signal, 0) == 0) return column.substr(std::string(signal).size());
  }
  return {};
}

}  // namespace nao::validation
