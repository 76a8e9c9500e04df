#include "recorder/hanging.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "core/check.h"

namespace nao::recorder {
namespace {

using validation::LogRun;

constexpr double kNewtonPerKg = 9.80665;
// A robot on its feet shows all of its weight; cells in the air drift by some 0.1 kg a foot.
constexpr double kBorne = 0.2;  // of the robot's weight
constexpr double kTilt = 0.17;  // [rad] turns 3 % of gravity's pull, or 17 % of its side, wrong

double weightOf(const RobotModel& model) {
  double mass = 0;
  for (const Body& body : model.bodies) mass += body.mass;
  return kNewtonPerKg * mass;
}

std::optional<double> meanOf(const LogRun& rows, const std::string& name) {
  const validation::Column* values = rows.find(name);
  if (values == nullptr || values->empty()) return {};
  double sum = 0;
  for (const double value : *values) sum += value;
  const double mean = sum / static_cast<double>(values->size());
  return std::isnan(mean) ? std::nullopt : std::optional(mean);
}

double borneByFeet(const LogRun& rows) {
  double borne = 0;
  for (const char* foot : {"L", "R"}) {
    for (const char* cell : {"fl", "fr", "rl", "rr"}) {
      borne += meanOf(rows, std::string("fsr.") + foot + "." + cell).value_or(0);
    }
  }
  return borne;
}

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

void requireHanging(const LogRun& rows, const RobotModel& model) {
  const std::string expected =
      model.name + ": expected a robot that hangs by its torso, upright, feet in the air; ";
  const double borne = borneByFeet(rows);
  if (borne > kBorne * weightOf(model)) {
    throw InputError(expected + "its feet bear " + number("%.1f N", borne) + " of " +
                     number("%.1f N", weightOf(model)));
  }
  for (const auto& [axis, name] : {std::pair("x", "roll"), std::pair("y", "pitch")}) {
    const double tilt = meanOf(rows, std::string("imu.ang.") + axis).value_or(0);
    if (std::abs(tilt) <= kTilt) continue;
    throw InputError(expected + "its " + name + " is " + number("%.1f degrees", tilt * 180 / M_PI));
  }
}

}  // namespace nao::recorder
