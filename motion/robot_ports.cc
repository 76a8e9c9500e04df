#include "motion/robot_ports.h"

#include <utility>

namespace nao::motion {

bool feelTheSame(const SensorFrame& one, const SensorFrame& other) {
  return one.touch.head == other.touch.head && one.touch.hand == other.touch.hand &&
         one.touch.chest_button == other.touch.chest_button &&
         one.feet[0].bumper == other.feet[0].bumper && one.feet[1].bumper == other.feet[1].bumper;
}

void RobotPorts::publish(std::shared_ptr<const SensorFrame> frame) {
  const auto before = sensors.get();
  sensors.publish(frame);
  const bool is_news = frame && !feelTheSame(before ? *before : SensorFrame(), *frame);
  if (is_news && !touches.post(std::move(frame))) return;  // the newest will tell what is left
}

}  // namespace nao::motion
