#pragma once

#include <cstddef>
#include <vector>

#include "core/archive.h"
#include "core/joint.h"
#include "core/sim_time.h"
#include "motion/joint_set.h"
#include "motion/motion_request.h"

namespace nao::motion {

/// Timed commands straight to the motors, past all motions: what NaoQi's DCM does. Between two
/// commands the value goes along a straight line, after the last it stays. It belongs to the
/// simulation thread, as its engine.
class DirectQueue {
 public:
  explicit DirectQueue(std::size_t joints) : angle_(joints), stiffness_(joints) {}

  static constexpr std::size_t kDeepest = 512;  // commands an actuator, as on the robot

  /// Takes commands in, or none of them: false if a queue would be deeper than kDeepest. `angle`
  /// and `stiffness` are what is commanded now, where lines begin.
  bool take(const DirectCommands& request, SimTime now, const JointArray<double>& angle,
            const JointArray<double>& stiffness);

  /// Joints whose angle is commanded here until the queue is empty.
  JointSet activeAngles() const;

  /// What the queues say at `now`, for the joints that they have something to say of.
  void apply(SimTime now, JointArray<double>& angle);
  template <class Set>
  void applyStiffness(SimTime now, const Set& set) {
    for (std::size_t i = 0; i < stiffness_.size(); ++i) {
      if (!stiffness_[i].points.empty()) set(toJoint(i), advance(stiffness_[i], now));
    }
  }

  /// Time was set back: what was planned for another time is forgotten.
  void clear();

  void archive(Archive& archive);

 private:
  struct Queue {
    TimedValue last{};  // where the line to the first point begins
    std::vector<TimedValue> points;
  };
  static double advance(Queue& queue, SimTime now);
  Queue& queueOf(const DirectCommands::Track& track);

  std::vector<Queue> angle_;
  std::vector<Queue> stiffness_;
};

}  // namespace nao::motion
