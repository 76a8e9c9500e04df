#pragma once

#include <memory>
#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "sim/world.h"

namespace nao::validation {

/// The joint targets of a walk, one per cycle: for a load that is the same in every simulator and
/// needs no motion engine.
struct WalkRecording {
  std::vector<JointCommand> commands;
  JointArray<double> start;  // [rad] standing, before the first command
};

/// Two seconds of standing in the walk's own pose, then about as many of walking straight on at
/// full speed as asked for, and back to a stand, walked by `model` on a flat ground.
WalkRecording recordWalk(const std::shared_ptr<const RobotModel>& model, Duration walking);

/// Replays a recording to some robots of a world, whose cycle must be the recording's.
class WalkReplay {
 public:
  explicit WalkReplay(const WalkRecording& recording) : recording_(recording) {}

  /// Puts every robot where the recording starts.
  void restart(sim::World& world);
  /// One cycle: sensors are read and commands sent for every robot, then the world moves.
  void advance(sim::World& world);
  bool done() const { return next_ == recording_.commands.size(); }

 private:
  const WalkRecording& recording_;
  std::size_t next_ = 0;
};

/// Robots in rows of a field, a metre apart, that all look along x.
std::vector<sim::RobotSetup> robotsInRows(const std::shared_ptr<const RobotModel>& model,
                                          int count);

/// Whether every robot's torso is as high as that of one that stands.
bool allStand(const sim::World& world);

}  // namespace nao::validation
