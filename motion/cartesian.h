#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/frames.h"
#include "motion/joint_set.h"
#include "motion/kinematics.h"

namespace nao::motion {

/// NaoQi's frames, by its numbers.
enum class Space { Torso = 0, World = 1, Robot = 2 };

/// What Cartesian control moves: the end of a chain (Head, LArm, RArm, LLeg, RLeg), or the torso on
/// its legs.
struct Chain {
  enum class Kind { Upper, LeftLeg, RightLeg, Torso };
  Kind kind = Kind::Upper;
  Effector place;
  JointSet joints;  // it books; of a leg or the torso: both legs, which share a motor
};

/// Nothing if the robot has no such chain, or none that moves.
std::optional<Chain> findChain(const RobotModel& model, std::string_view name);

/// Where one effector is to go.
struct PoseTrack {
  std::string chain;  // one that findChain() knows
  Space space = Space::Torso;
  int mask = 63;              // NaoQi's axis mask: 1 x, 2 y, 4 z, 8, 16, 32 the turns about them
  std::vector<Pose> path;     // in `space`, or changes along its axes
  std::vector<double> times;  // [s] ascending and positive, one per pose
};

/// Books the chains until the last time; through the poses along smooth ways, which are straight
/// where there is one pose. The space stands still in the supporting foot (the other one, for a
/// leg), or in the torso. (positionInterpolations, transformInterpolations)
struct InterpolatePoses {
  std::vector<PoseTrack> tracks;
  bool relative = false;  // to where the effector is at the start: p0 + dp, dR R0
};

/// Goes to the last pose of every track as fast as allowed; books nothing and ends at once.
/// (setPositions, setTransforms, changePosition, ...)
struct SetPoses {
  std::vector<PoseTrack> tracks;  // `times` does not count
  double fraction = 1;            // of the joints' top speed, (0, 1]
  bool relative = false;
};

/// The place X_TSpace of a space for a robot whose odometry is `odometry`.
Pose calcSpace(const Kinematics& body, Space space, const Pose2& odometry);

}  // namespace nao::motion
