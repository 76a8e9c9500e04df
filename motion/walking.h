#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/value_ptr.h"
#include "motion/gait.h"
#include "motion/joint_set.h"
#include "motion/motion_request.h"
#include "motion/phase.h"

namespace nao::motion {

/// Where a walk is to lead.
using WalkOrder = std::variant<MoveTo, Move, MoveToward, WalkSteps>;

/// Brings walk requests to the gait. A new order replaces the one under way, from the end of the
/// steps that can no longer change. The steps begin when the schedule has given the legs free
/// (phase()) and the body stands as a walk starts. A moveTo ends when both feet stand again; move
/// and moveToward end at once, the walk goes on. A value: a copy goes on like the original.
class Walking {
 public:
  /// `gait` may be null: a robot that does not walk.
  Walking(const RobotModel& model, std::unique_ptr<Gait> gait);

  /// True if the legs must be booked for this order, by a job with phase().
  bool order(RequestId id, const WalkOrder& order);
  std::unique_ptr<Phase> phase();

  /// Lets the walk end in double support; `id` (of a stopMove, or 0) is done when it has.
  void stop(RequestId id);

  /// Ends the walk at once, and the orders with it; `reason` makes it their failure.
  void kill(const std::string& reason = {});

  /// Stops if this is the request under way; false otherwise.
  bool stopRequest(RequestId id);

  void setMoveArms(const SetMoveArms& arms) { move_arms_ = arms; }
  void setProtection(const SetWalkProtection& protection) { protection_ = protection; }

  void setFeedback(const WalkFeedback& feedback) {
    if (gait_) gait_->setFeedback(feedback);
  }

  bool ordered() const { return state_ != State::Idle; }
  bool active() const { return state_ == State::Walking; }
  RequestId id() const { return id_; }

  /// How many orders failed, and whether the last of these was walking by then.
  std::uint64_t failures() const { return failures_; }
  bool failedUnderWay() const { return failed_under_way_; }

  const Gait* gait() const { return gait_.get(); }

  /// One cycle of `dt` [s]: the gait's legs, and its arms where they are not `held` by others.
  void update(double dt, const JointSet& held, Body& body);

  std::vector<MotionOutcome> takeOutcomes();

  /// From now on nobody hears how the order under way ends.
  void forgetCallers();

  /// Lists the order, the gait and who moves the arms for hashing, not who waits.
  void archive(Archive& archive);

 private:
  class LegsPhase;
  enum class State { Idle, Ordered, Walking };

  bool isStand(const WalkOrder& order) const;
  std::string refusal(const Body& body) const;
  void start(const Body& body);
  void handToGait();
  void archiveOrder(Archive& archive);
  void endOrder(MotionOutcome::Kind kind, const std::string& reason = {});
  void fail(const std::string& reason);
  void becomeIdle(MotionOutcome::Kind kind, const std::string& reason = {});
  JointSet swingingArms() const;

  const RobotModel& model_;
  ValuePtr<Gait> gait_;
  const JointSet legs_, left_arm_, right_arm_;
  SetMoveArms move_arms_;
  SetWalkProtection protection_;
  State state_ = State::Idle;
  WalkOrder order_;
  RequestId id_ = 0;      // of the order under way
  bool awaited_ = false;  // somebody waits for its end (moveTo)
  bool stopping_ = false;
  std::uint64_t failures_ = 0;
  bool failed_under_way_ = false;
  JointSet commanded_;  // arms that a request moved during this walk
  std::vector<RequestId> stops_;
  std::vector<MotionOutcome> outcomes_;
};

}  // namespace nao::motion
