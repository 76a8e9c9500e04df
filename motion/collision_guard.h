#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/archive.h"
#include "core/joint.h"
#include "core/robot_model.h"
#include "motion/joint_set.h"

namespace nao::motion {

/// How near an arm's command is to the rest of the body, as ALMotion.isCollision tells.
enum class Nearness : std::uint8_t { None, Near, Collision };

/// Keeps commanded arms out of the body: between the collision solids of an arm and those of
/// torso, head, legs and the other arm (but the model's no_collision) no command makes a gap
/// negative. A step that would is shortened joint by joint, from the shoulder outwards, so that the
/// arm slides along and the joints that may move do. Where the gap is negative already (the legs
/// came up, protection was off) only steps that do not deepen it pass. An arm set free again
/// catches up at its joints' top speed. Ways to a posture pass unguarded, as many of the real
/// robot's posture graph do. Works on commands: servos lag and give way. A value.
class CollisionGuard {
 public:
  static constexpr std::size_t kArms = 2;  // left, right

  /// `model` must outlive this.
  explicit CollisionGuard(const RobotModel& model);

  /// Both arms are guarded until told otherwise.
  void enable(std::size_t arm, bool on);
  bool enabled(std::size_t arm) const { return arms_[arm].enabled; }

  /// One cycle of `dt` [s]: `from` are the commands of the last cycle, `command` those wanted now,
  /// changed where they must be.
  void apply(const JointArray<double>& from, double dt, JointArray<double>& command);

  Nearness nearness(std::size_t arm) const { return arms_[arm].nearness; }

  /// Lists switches and held joints.
  void archive(Archive& archive);

 private:
  struct Solid {
    int body = 0;
    Shape shape;
    double radius = 0;  // [m] of a sphere that holds it
    Pose X_TS = Pose::Identity();
  };
  struct Pair {
    std::size_t mine, other;
  };
  struct Arm {
    std::vector<std::size_t> joints;  // from the shoulder outwards
    std::vector<int> bodies;          // parents first
    std::vector<std::size_t> solids;
    std::vector<Pair> pairs;
    JointSet held;
    bool enabled = true;
    Nearness nearness = Nearness::None;
  };

  void findArm(const char* group, Arm& arm);
  void findPairs(Arm& arm);
  void placeAll(const JointArray<double>& angle);
  void placeArm(const Arm& arm, const JointArray<double>& angle);
  void placeBody(int body, const JointArray<double>& angle);
  double leastGap(const Arm& arm) const;
  double gapAt(const Arm& arm, const JointArray<double>& angle);
  void guard(Arm& arm, const JointArray<double>& from, double dt, JointArray<double>& command);
  double freePart(const Arm& arm, std::size_t joint, double way, double floor,
                  JointArray<double>& angle);

  const RobotModel& model_;
  std::vector<Solid> solids_;
  std::vector<Pose> X_TB_;
  std::array<Arm, kArms> arms_;
};

}  // namespace nao::motion
