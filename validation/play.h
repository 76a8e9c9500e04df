#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "core/scene_frame.h"
#include "core/world_model.h"
#include "motion/timeline/lint.h"
#include "motion/timeline/timeline.h"
#include "sim/world.h"

namespace nao::validation {

/// How a motion is played.
struct PlaySettings {
  std::shared_ptr<const RobotModel> model;
  std::shared_ptr<const WorldModel> world;
  Duration step = std::chrono::milliseconds(2);
  sim::Mode mode = sim::Mode::Implicit;
  std::uint64_t seed = 0;  // 0: none
  /// The pose the robot is put down in, at rest and stiff, before the motion begins; or "first":
  /// that of the motion's first keys, other joints as in StandInit. Into a pose of those that lie
  /// it is pushed over from its feet. Empty: StandInit, or the
  /// robot's start posture where it has no such.
  std::string from;
  double hold = 1.0;  // [s] watched after the end: long enough for a Nao to tip over
};

/// What every joint was told and did, by cycle; index by joint. Time 0 is the motion's beginning.
struct PlayTracks {
  std::vector<double> time;                 // [s]
  std::vector<std::vector<double>> asked;   // [rad] of the motors; hands 0..1
  std::vector<std::vector<double>> sensed;  // [rad] by their encoders
  std::vector<std::vector<double>> torque;  // [N m] of the motors
  std::vector<double> tilt;                 // [rad] of the torso from upright
  std::vector<double> height;               // [m] of the torso's origin
};

/// A motion that was played in the simulation.
struct Played {
  std::vector<motion::MotionFault> faults;  // described, in order of time
  double duration = 0;                      // [s] from its begin until the engine had done it
  bool done = false;                        // the engine played it to its end
  bool fell = false;
  bool upright = false;  // at the end of it all
  PlayTracks tracks;
  std::map<std::string, double> draw;
  std::uint64_t hash = 0;
};

/// Called after every physics step from the motion's beginning on, with the time since then [s].
using PlayWatch = std::function<void(const sim::World& world, double time)>;

/// Puts a robot into its pose, waits a second, plays the motion on the robot's own motion engine
/// and tells everything that went wrong: what lint() finds and what only physics shows, which is
/// falls, motors at the end of their torque, and a robot that touches itself. The robot's own
/// guards, against collisions of its arms and falls, are off.
/// @throws InputError for a pose the robot does not have.
Played play(const motion::Timeline& timeline, const PlaySettings& settings,
            const PlayWatch& watch = {});

}  // namespace nao::validation
