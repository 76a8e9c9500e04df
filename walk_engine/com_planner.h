#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "core/archive.h"
#include "core/robot_model.h"
#include "walk_engine/footstep_plan.h"
#include "walk_engine/support.h"
#include "walk_engine/tuning.h"
#include "walk_engine/zmp_qp.h"

namespace nao::walk {

/// Moves the centre of mass over the steps of a plan: every motion tick (20 ms, 12 on robots with
/// that cycle) it solves the ZmpQp over the preview and follows its first jerk until the next.
class ComPlanner {
 public:
  ComPlanner(const RobotModel& model, const Tuning& tuning, double tick_seconds);

  /// At rest over `place` [m].
  void reset(double com_height, const Eigen::Vector2d& place, std::int64_t now);

  /// By how much the swinging leg drives the zero moment point away from the pendulum's [m].
  using Reaction = std::function<Eigen::Vector2d(std::int64_t tick)>;

  /// One control cycle. The plan must reach as far as horizon().
  void advance(const FootstepPlan& plan, std::int64_t now, const Reaction& reaction);
  int horizon() const { return horizon_; }  // [ticks]

  const QpProblem& problem() const { return qp_.problem(); }  // of the last motion tick
  const ComState& com() const { return com_; }
  Eigen::Vector2d position() const { return {com_.x[0], com_.y[0]}; }  // [m]
  Eigen::Vector2d velocity() const { return {com_.x[1], com_.y[1]}; }  // [m/s]

  /// How much further the landing under way shall move when the capture point is `deviation` [m]
  /// away from where the plan has it; `range` says how far it may.
  Eigen::Vector2d calcLanding(const FootstepPlan& plan, std::int64_t now,
                              const Eigen::Vector2d& deviation, const LandingRange& range,
                              const Reaction& reaction);

  /// The body goes on with another velocity than planned [m/s], as after a push.
  void push(const Eigen::Vector2d& velocity);

  void archive(Archive& archive);

 private:
  void setHeight(double com_height);
  void preview(const FootstepPlan& plan, std::int64_t now, const Reaction& reaction, int movable);
  Eigen::Vector2d calcReference(const FootstepPlan& plan, std::int64_t tick, int width) const;
  CaptureGoal calcEnd(const FootstepPlan& plan, std::int64_t tick, int movable) const;

  Support support_;
  double dt_;               // [s] of a tick
  int lead_;                // [ticks] of the reference
  std::vector<int> ticks_;  // between the instants of the preview
  int after_ = 0;           // [ticks] beyond the preview that its end depends on
  int horizon_ = 0;         // [ticks] both together
  double height_ = 0;       // [m] of the centre of mass
  ZmpQp qp_;
  ZmpQp landing_qp_;
  std::vector<ZmpSample> samples_;
  CaptureGoal end_;
  ComState com_;
  Eigen::Vector2d jerk_ = Eigen::Vector2d::Zero();  // [m/s^3]
  std::int64_t solved_ = 0;                         // [ticks] when the last plan was made
};

}  // namespace nao::walk
