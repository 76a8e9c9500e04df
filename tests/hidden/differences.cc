#include <cmath>

#include "core/random.h"
#include "tests/hidden/hidden_set.h"

namespace nao::hidden {
namespace {

bool isFriction(const std::string& effect) { return effect.find("friction") != std::string::npos; }

}  // namespace

void addUndeclaredDifferences(RobotModel& model, std::uint64_t seed) {
  Random random(seed, "undeclared differences");
  const auto factor = [&](double most) { return 1 + random.uniform(-most, most); };
  for (std::size_t b = 1; b < model.bodies.size(); ++b) {
    model.bodies[b].mass *= factor(0.02);
    model.bodies[b].I_Bcm *= factor(0.05);
  }
  for (Actuator& motor : model.actuators) {
    motor.kp *= factor(0.02);
    motor.kd *= factor(0.02);
    motor.rotor_inertia *= factor(0.05);
  }
  for (EffectSetting& effect : model.effects) {
    if (!isFriction(effect.name)) continue;
    for (auto& [name, value] : effect.parameters) {
      if (name != "speed") value *= factor(0.1);
    }
  }
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    const double zero = random.uniform(-0.1, 0.1) * M_PI / 180;
    if (model.actuators[j].coordinates.empty()) continue;
    model.effects.push_back({"encoder_offset", {{"angle", zero}}, {toJoint(j)}, ""});
  }
}

}  // namespace nao::hidden
