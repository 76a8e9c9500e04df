#include <algorithm>

#include "motion/motion_engine_impl.h"
#include "motion/phases.h"
#include "motion/postures.h"

namespace nao::motion {

void MotionEngine::Impl::take(RequestId id, const SetAngles& request) {
  for (std::size_t i = 0; i < request.joints.size(); ++i) {
    const Joint joint = request.joints[i];
    const Actuator& actuator = model_->actuators[index(joint)];
    if (walking_.ordered() && legs_.test(index(joint))) continue;  // the steps have the legs
    const double base = request.relative ? body_.angle[joint] : 0;
    schedule_.release(joint);
    pose_goals_.release(JointSet().set(index(joint)));
    setpoints_.set(joint, std::clamp(base + request.angles[i], actuator.lower, actuator.upper),
                   request.fraction[i] * actuator.max_velocity);
  }
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const DirectCommands& request) {
  if (direct_.take(request, time_, body_.angle, body_.stiffness.value())) return done(id);
  report(id, MotionOutcome::Kind::Failed, "more than 512 commands wait for one actuator");
}

void MotionEngine::Impl::take(RequestId id, const Interpolate& request) {
  Job job{id, "angleInterpolation", {}, std::make_unique<FollowCurves>(request)};
  for (const Curve& curve : request.curves) job.joints.set(index(curve.joint));
  schedule_.add(std::move(job));
}

void MotionEngine::Impl::take(RequestId id, const InterpolateWithSpeed& request) {
  Glide::Course course;
  course.target = JointArray<double>(model_->jointCount());
  course.fraction = request.fraction;
  for (std::size_t i = 0; i < request.joints.size(); ++i) {
    course.joints.set(index(request.joints[i]));
    course.target[request.joints[i]] = request.angles[i];
  }
  schedule_.add(
      {id, "angleInterpolationWithSpeed", course.joints, std::make_unique<Glide>(course)});
}

void MotionEngine::Impl::take(RequestId id, const InterpolatePoses& request) {
  PoseFollower follower(model_, request.tracks, request.relative);
  const JointSet joints = follower.joints();
  schedule_.add(
      {id, "positionInterpolation", joints, std::make_unique<FollowPoses>(std::move(follower))});
}

void MotionEngine::Impl::take(RequestId id, const SetPoses& request) {
  PoseFollower follower(model_, request.tracks, request.relative);
  done(id);
  if (walking_.ordered() && (legs_ & follower.joints()).any()) return;  // the steps have the legs
  follower.begin(body_.angle, walking_.gait() ? walking_.gait()->position() : Pose2{});
  for (std::size_t i = 0; i < model_->jointCount(); ++i) {
    if (follower.joints().test(i)) schedule_.release(toJoint(i));
  }
  setpoints_.clear(follower.joints());
  pose_goals_.add(std::move(follower), request.fraction);
}

void MotionEngine::Impl::take(RequestId id, const WbGoToBalance& request) {
  schedule_.add({id, "wbGoToBalance", legs_, std::make_unique<GoToBalance>(model_, request)});
}

void MotionEngine::Impl::take(RequestId id, const SetStiffness& request) {
  for (std::size_t i = 0; i < request.joints.size(); ++i) {
    body_.stiffness.set(request.joints[i], request.stiffness[i]);
  }
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const InterpolateStiffness& request) {
  body_.stiffness.run(id, request);
}

void MotionEngine::Impl::take(RequestId id, const WakeUp& /*request*/) {
  addWholeBody(id, "wakeUp", wakeUp(*model_));
}

void MotionEngine::Impl::take(RequestId id, const Rest& /*request*/) {
  addWholeBody(id, "rest", rest(*model_));
}

void MotionEngine::Impl::take(RequestId id, const GoToPosture& request) {
  const Posture* posture = model_->findPosture(request.posture);
  if (posture == nullptr) {
    return report(id, MotionOutcome::Kind::Failed, "unknown posture " + request.posture);
  }
  addWholeBody(id, "goToPosture", goToPosture(*model_, *posture, request.fraction));
}

void MotionEngine::Impl::take(RequestId id, const MoveInit& /*request*/) {
  const Posture* stand = model_->findPosture("StandInit");
  if (walking_.active() || stand == nullptr) return done(id);
  Job job{id, "moveInit", allJoints(*model_) & ~jointsOfGroup(*model_, "Head"),
          glideTo(*model_, *stand, 1.0)};
  walking_.stop(0);
  schedule_.add(std::move(job));
}

void MotionEngine::Impl::take(RequestId id, const StopMove& /*request*/) { walking_.stop(id); }

void MotionEngine::Impl::take(RequestId id, const KillMove& /*request*/) {
  walking_.kill();
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const SetMoveArms& request) {
  walking_.setMoveArms(request);
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const SetWalkFeedback& request) {
  walking_.setFeedback(request.feedback);
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const SetIdle& request) {
  idle_.set(request, body_);
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const SetBreath& request) {
  idle_.configure(request);
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const SetCollisionProtection& request) {
  guard_.enable(0, request.left);
  guard_.enable(1, request.right);
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const SetFallManager& request) {
  fall_.enable(request.on);
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const SetWalkProtection& request) {
  walking_.setProtection(request);
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const SetSmartStiffness& request) {
  spare_.enable(request.on);
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const Kill& request) {
  if (!walking_.stopRequest(request.id) && !schedule_.kill(request.id) &&
      body_.stiffness.kill(request.id)) {
    report(request.id, MotionOutcome::Kind::Killed);
  }
  collectOutcomes();
  done(id);
}

void MotionEngine::Impl::take(RequestId id, const KillAll& /*request*/) {
  walking_.stop(0);
  schedule_.killAll();
  setpoints_.clear(allJoints(*model_));
  pose_goals_.release(allJoints(*model_));
  for (const RequestId run : body_.stiffness.killAll()) report(run, MotionOutcome::Kind::Killed);
  collectOutcomes();
  done(id);
}

void MotionEngine::Impl::walk(RequestId id, const WalkOrder& order) {
  if (!walking_.order(id, order)) return;
  setpoints_.clear(legs_);
  pose_goals_.release(legs_);
  if (!schedule_.add({id, "move", legs_, walking_.phase(), false})) {
    walking_.kill("too many motions wait for their joints");
  }
}

void MotionEngine::Impl::addWholeBody(RequestId id, const char* name,
                                      std::unique_ptr<Phase> phase) {
  walking_.stop(0);
  schedule_.add({id, name, allJoints(*model_), std::move(phase)});
}

}  // namespace nao::motion
