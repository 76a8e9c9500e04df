#include "core/robot_model_parts.h"

namespace nao {
namespace {

// Postures are rounded to some digits, and so are limits.
constexpr double kSlack = 1e-4;  // [rad]

JointArray<double> readAngles(Config& angles, const RobotModel& model) {
  JointArray<double> result(model.jointCount());
  for (std::size_t i = 0; i < model.jointCount(); ++i) {
    const Actuator& actuator = model.actuators[i];
    result[i] = angles.number(actuator.name, {actuator.lower - kSlack, actuator.upper + kSlack});
  }
  return result;
}

}  // namespace

void readPostures(const std::string& file, RobotModel& model) {
  Config::read(file, [&](Config& config) {
    config.list("postures", Config::Presence::Required, [&](Config& entry) {
      Posture posture;
      posture.name = entry.text("name");
      posture.family = entry.text("family", posture.name);
      if (model.findPosture(posture.name)) entry.reject("name", "each name once");
      entry.map("angles", Config::Presence::Required,
                [&](Config& angles) { posture.angle = readAngles(angles, model); });
      model.postures.push_back(posture);
    });
    model.start_posture = config.text("start");
    if (!model.findPosture(model.start_posture)) config.reject("start", "one of `postures`");
  });
}

}  // namespace nao
