#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/frames.h"
#include "core/joint.h"
#include "core/sim_time.h"
#include "motion/cartesian.h"
#include "motion/gait.h"
#include "motion/whole_body_request.h"

namespace nao::motion {

/// Numbers requests in the order they were posted; also NaoQi's motion task id.
using RequestId = std::uint64_t;

/// Moves without booking the joints; a later request takes over. (setAngles, changeAngles)
struct SetAngles {
  std::vector<Joint> joints;
  std::vector<double> angles;    // [rad], one per joint
  std::vector<double> fraction;  // of the joint's maximum speed, (0, 1], one per joint
  bool relative = false;         // changeAngles: to the present command
};

/// One cubic piece's handle, relative to its key. (angleInterpolationBezier)
struct Handle {
  enum class Kind : std::uint8_t { Constant = 0, Linear = 1, Bezier = 2, BezierAuto = 3 };
  Kind kind = Kind::Bezier;
  double dt = 0;      // [s]  <= 0 before the key, >= 0 after it
  double dangle = 0;  // [rad]
};
struct Key {
  double time = 0;   // [s] after the start of the motion
  double angle = 0;  // [rad]
  Handle before, after;
};
struct Curve {
  Joint joint{};
  std::vector<Key> keys;  // times ascending and positive
};

/// Books the joints until the last key; other interpolations of theirs wait. Starts from the
/// present command. `smooth`: handles come from the keys' neighbours (angleInterpolation).
struct Interpolate {
  std::vector<Curve> curves;
  bool relative = false;
  bool smooth = true;
};

/// As Interpolate, in the least time that keeps every joint below its fraction of top speed.
struct InterpolateWithSpeed {
  std::vector<Joint> joints;
  std::vector<double> angles;  // [rad]
  double fraction = 1;
};

struct SetStiffness {
  std::vector<Joint> joints;
  std::vector<double> stiffness;  // -1 or 0 to 1
};

/// Stiffness along straight lines; books nothing.
struct InterpolateStiffness {
  struct Track {
    Joint joint{};
    std::vector<double> stiffness;
    std::vector<double> times;  // [s] ascending
  };
  std::vector<Track> tracks;
};

struct WakeUp {};  // stiffness on; a Nao keeps its pose, and stands up from Crouch
struct Rest {};    // to Crouch, then stiffness off

struct GoToPosture {
  std::string posture;
  double fraction = 0.5;  // of top speed
};

struct MoveTo {
  Pose2 target;                // in R
  std::optional<double> time;  // [s]
  GaitConfig config;
};
struct Move {
  Velocity2 velocity;
  GaitConfig config;
};
struct MoveToward {
  double x = 0, y = 0, theta = 0;  // fractions, -1 to 1
  GaitConfig config;
};
/// Steps one by one. (setFootSteps, setFootStepsWithSpeed)
struct WalkSteps {
  std::vector<StepOrder> steps;
  bool clear = false;    // forget the steps ordered before that may still change
  bool awaited = false;  // ends when the robot stands again, else at once
};
struct MoveInit {};  // to the pose from which walking starts
struct StopMove {};
struct KillMove {};

/// Whether the arms swing with the steps; both do until told otherwise.
struct SetMoveArms {
  bool left = true;
  bool right = true;
};

/// How walks answer what they sense; both ways until told otherwise.
struct SetWalkFeedback {
  WalkFeedback feedback;
};

/// What joints do while nobody commands them (setBreathEnabled, setIdlePostureEnabled): see Idle.
struct SetIdle {
  enum class Mode : std::uint8_t { Nothing, Posture, Breath };
  std::vector<Joint> joints;
  Mode mode = Mode::Nothing;
};

/// How those breathe that do (setBreathConfig); clipped to what NaoQi allows.
struct SetBreath {
  double beats_per_minute = 12;  // 5 to 30
  double amplitude = 0.5;        // 0 to 1
};

/// Whether the commands of an arm keep out of the body; both do until told otherwise.
struct SetCollisionProtection {
  bool left = true;
  bool right = true;
};

/// Whether a fall ends in a protective pose and limp joints; it does until told otherwise.
struct SetFallManager {
  bool on = true;
};

/// Whether joints that hold still are commanded no stiffer than they need; they are until told
/// otherwise.
struct SetSmartStiffness {
  bool on = true;
};

/// Whether a walk demands ground under a foot, and stiff legs; it does until told otherwise.
struct SetWalkProtection {
  bool foot_contact = true;
  bool stiffness = true;
};

/// A value for a moment of simulated time.
struct TimedValue {
  SimTime time{};
  double value = 0;
};

/// Timed commands past all motions, along straight lines (NaoQi's DCM): see DirectQueue.
struct DirectCommands {
  enum class Merge : std::uint8_t {
    ClearAll,     // of these actuators: all others go
    Merge,        // all others stay
    ClearAfter,   // those from the first new one on go
    ClearBefore,  // those up to the last new one go
  };
  enum class Quantity : std::uint8_t { Angle, Stiffness };  // [rad]; -1 or 0 to 1
  struct Track {
    Joint joint{};
    Quantity quantity = Quantity::Angle;
    std::vector<TimedValue> points;
  };
  std::vector<Track> tracks;
  Merge merge = Merge::Merge;
};

/// Ends one request (kill, cancel) or all of them; joints keep their last command, a walk comes to
/// a stand.
struct Kill {
  RequestId id = 0;
};
struct KillAll {};

using MotionAction =
    std::variant<SetAngles, Interpolate, InterpolateWithSpeed, SetStiffness, InterpolateStiffness,
                 WakeUp, Rest, GoToPosture, MoveTo, Move, MoveToward, MoveInit, StopMove, KillMove,
                 SetMoveArms, SetWalkFeedback, SetIdle, SetBreath, SetCollisionProtection,
                 SetFallManager, SetWalkProtection, SetSmartStiffness, DirectCommands, Kill,
                 KillAll, InterpolatePoses, SetPoses, WalkSteps, WbEnable, WbFootState, WbBalance,
                 WbGoToBalance, WbEffector, WbEffectorTarget, WbOptimize>;

/// Everything a client can ask of the motion engine, checked for names, shapes and ranges before
/// it is posted.
struct MotionRequest {
  RequestId id = 0;
  MotionAction action;
};

/// How a request ended; every request gets exactly one.
struct MotionOutcome {
  enum class Kind : std::uint8_t { Done, Killed, Failed };
  RequestId id = 0;
  Kind kind = Kind::Done;
  std::string reason;  // of a failure, one sentence
};

}  // namespace nao::motion
