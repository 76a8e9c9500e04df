#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/collision_guard.h"
#include "motion/direct_queue.h"
#include "motion/fall_manager.h"
#include "motion/ground_sense.h"
#include "motion/idle.h"
#include "motion/motion_engine.h"
#include "motion/pose_follower.h"
#include "motion/schedule.h"
#include "motion/setpoints.h"
#include "motion/smart_stiffness.h"
#include "motion/walking.h"
#include "motion/whole_body.h"

namespace nao::motion {

/// What MotionEngine is made of: motion_requests.cc takes requests in, motion_engine.cc lives the
/// cycle.
class MotionEngine::Impl {
 public:
  Impl(std::shared_ptr<const RobotModel> model, std::unique_ptr<Gait> gait,
       RequestId last_accepted);

  void accept(const MotionRequest& request);
  JointCommand update(const SensorFrame& measured);
  MotionState state() const;
  std::vector<MotionOutcome> takeOutcomes();
  void forgetCallers();
  void archive(Archive& archive);

 private:
  void take(RequestId id, const SetAngles& request);
  void take(RequestId id, const Interpolate& request);
  void take(RequestId id, const InterpolateWithSpeed& request);
  void take(RequestId id, const SetStiffness& request);
  void take(RequestId id, const InterpolateStiffness& request);
  void take(RequestId id, const WakeUp& request);
  void take(RequestId id, const Rest& request);
  void take(RequestId id, const GoToPosture& request);
  void take(RequestId id, const MoveTo& request) { walk(id, request); }
  void take(RequestId id, const Move& request) { walk(id, request); }
  void take(RequestId id, const MoveToward& request) { walk(id, request); }
  void take(RequestId id, const MoveInit& request);
  void take(RequestId id, const StopMove& request);
  void take(RequestId id, const KillMove& request);
  void take(RequestId id, const SetMoveArms& request);
  void take(RequestId id, const SetWalkFeedback& request);
  void take(RequestId id, const SetIdle& request);
  void take(RequestId id, const SetBreath& request);
  void take(RequestId id, const SetCollisionProtection& request);
  void take(RequestId id, const SetFallManager& request);
  void take(RequestId id, const SetWalkProtection& request);
  void take(RequestId id, const SetSmartStiffness& request);
  void take(RequestId id, const DirectCommands& request);
  void take(RequestId id, const Kill& request);
  void take(RequestId id, const KillAll& request);
  void take(RequestId id, const InterpolatePoses& request);
  void take(RequestId id, const SetPoses& request);
  void take(RequestId id, const WalkSteps& request) { walk(id, request); }
  void take(RequestId id, const WbGoToBalance& request);
  template <class WholeBodyRequest>
  void take(RequestId id, const WholeBodyRequest& request) {
    whole_body_.take(request, body_.angle);
    done(id);
  }

  void senseBalance(const SensorFrame& measured);
  void protectFromFall();
  void walk(RequestId id, const WalkOrder& order);
  void addWholeBody(RequestId id, const char* name, std::unique_ptr<Phase> phase);
  void report(RequestId id, MotionOutcome::Kind kind, std::string reason = {});
  void done(RequestId id) { report(id, MotionOutcome::Kind::Done); }
  void collectOutcomes();
  JointSet limpJoints() const;
  void followSensors(const JointSet& limp);

  const std::shared_ptr<const RobotModel> model_;
  const double dt_;  // [s]
  const JointSet legs_;
  const JointSet limbs_;
  Body body_;
  Schedule schedule_;
  Setpoints setpoints_;
  DirectQueue direct_;
  PoseGoals pose_goals_;
  Walking walking_;
  WholeBody whole_body_;
  Idle idle_;
  FallManager fall_;
  GroundSense ground_;
  CollisionGuard guard_;
  SmartStiffness spare_;
  SimTime time_{};
  RequestId last_accepted_;
  std::vector<MotionOutcome> outcomes_;
};

}  // namespace nao::motion
