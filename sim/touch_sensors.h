#pragma once

#include <string>
#include <vector>

#include "core/archive.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "sim/surroundings.h"

namespace nao::sim {

/// Bumpers, tactile sensors and the chest button: on while something pushes the robot near their
/// place (a frame of the model with NaoQi's device name), or while a press lasts. A bumper sits in
/// the toe and feels pushes from ahead, not the floor.
class TouchSensors {
 public:
  explicit TouchSensors(const RobotModel& model);

  void reset();

  /// NaoQi's device names of those this robot has, e.g. "Head/Touch/Front".
  std::vector<std::string> names() const;
  /// False if there is no sensor of that name.
  bool press(const std::string& name, SimTime until);

  void sample(const Surroundings& around, SimTime now, SensorFrame& frame) const;

  void archive(Archive& archive);

 private:
  struct Sensor {
    std::string name;
    int body;
    Vec3 p_B;
    bool bumper;
    int group = 0, place = 0;  // head 0, hands 1 and 2, feet 3 and 4; which of it
    SimTime pressed_until{};
  };
  void add(const RobotModel& model, const std::string& name, int group, int place);
  static bool feels(const Sensor& sensor, const Surroundings& around);
  static bool& target(const Sensor& sensor, SensorFrame& frame);

  std::vector<Sensor> sensors_;
};

}  // namespace nao::sim
