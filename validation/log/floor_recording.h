#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "core/sim_time.h"
#include "motion/motion_request.h"
#include "sim/effects/catalogue.h"
#include "validation/log/floor_motions.h"

namespace nao::validation {

/// How a standing or walking set is recorded from a simulated robot.
struct FloorPlan {
  std::shared_ptr<const RobotModel> model;  // its effects act; its variation does not
  std::vector<EffectSetting> extra;         // on top of those, the same in every run
  std::vector<FloorMotion> motions;
  /// By a motion's name: what is asked of the robot in place of what the protocol says.
  std::map<std::string, motion::MotionAction> actions{};
  int repeats = 6;
  Duration step = std::chrono::microseconds(250);
  std::uint64_t seed = 1;                         // of all that differs between runs
  const sim::EffectCatalogue* effects = nullptr;  // null: standardEffects()
};

/// Wakes a robot up on a flat floor for every run, lets it play the motion on its own motion engine
/// and writes down a row per cycle: commands, all sensors, and where the torso really is.
LogSet recordOnFloor(const FloorPlan& plan);

}  // namespace nao::validation
