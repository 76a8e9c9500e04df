#include "motion/motion_engine.h"

#include <algorithm>
#include <iterator>

#include "core/check.h"
#include "motion/collision_guard.h"
#include "motion/fall_manager.h"
#include "motion/ground_sense.h"
#include "motion/idle.h"
#include "motion/limits.h"
#include "motion/phases.h"
#include "motion/pose_follower.h"
#include "motion/postures.h"
#include "motion/schedule.h"
#include "motion/setpoints.h"
#include "motion/walking.h"
#include "motion/whole_body.h"

namespace nao::motion {

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
  void take(RequestId id, const SetIdle& request);
  void take(RequestId id, const SetBreath& request);
  void take(RequestId id, const SetCollisionProtection& request);
  void take(RequestId id, const SetFallManager& request);
  void take(RequestId id, const SetWalkProtection& request);
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
  PoseGoals pose_goals_;
  Walking walking_;
  WholeBody whole_body_;
  Idle idle_;
  FallManager fall_;
  GroundSense ground_;
  CollisionGuard guard_;
  SimTime time_{};
  RequestId last_accepted_;
  std::vector<MotionOutcome> outcomes_;
};

MotionEngine::Impl::Impl(std::shared_ptr<const RobotModel> model, std::unique_ptr<Gait> gait,
                         RequestId last_accepted)
    : model_(std::move(model)),
      dt_(toSeconds(model_->cycle)),
      legs_(jointsOfGroup(*model_, "LLeg") | jointsOfGroup(*model_, "RLeg")),
      limbs_(legs_ | jointsOfGroup(*model_, "LArm") | jointsOfGroup(*model_, "RArm")),
      body_(*model_),
      setpoints_(model_->jointCount()),
      walking_(*model_, std::move(gait)),
      whole_body_(model_),
      idle_(*model_),
      fall_(model_),
      guard_(*model_),
      last_accepted_(last_accepted) {
  if (const Posture* start = model_->findPosture(model_->start_posture)) {
    body_.angle = start->angle;
  }
}

void MotionEngine::Impl::accept(const MotionRequest& request) {
  std::visit([&](const auto& action) { take(request.id, action); }, request.action);
  last_accepted_ = request.id;
  collectOutcomes();
}

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

JointCommand MotionEngine::Impl::update(const SensorFrame& measured) {
  // What is sensed: tilt, and limp joints, whose commands follow the body.
  time_ = measured.time;
  body_.measured = measured;
  if (!model_->feet.empty()) senseBalance(measured);
  followSensors(limpJoints());

  // What was asked for: booked motions, setpoints, stiffness, and the walk over both.
  const JointArray<double> before = body_.angle;
  body_.self_guarded = false;
  body_.walking = &walking_;
  body_.whole_body = walking_.ordered() ? nullptr : &whole_body_;
  schedule_.advance(dt_, body_);
  body_.walking = nullptr;
  body_.whole_body = nullptr;
  setpoints_.clear(schedule_.booked());
  pose_goals_.release(schedule_.booked());
  for (const RequestId id : body_.stiffness.advance(dt_)) done(id);
  const JointSet limp = limpJoints();
  setpoints_.clear(limp);
  pose_goals_.release(limp);
  const JointSet held = schedule_.booked() | setpoints_.active() | pose_goals_.active();
  setpoints_.advance(dt_, body_.angle);
  pose_goals_.advance(dt_, body_.angle);
  if (!walking_.ordered()) whole_body_.apply(dt_, before, held, limp, body_.angle);
  walking_.update(dt_, held, body_);
  idle_.update(dt_, held | limp | (walking_.active() ? limbs_ : JointSet{}), body_);

  // What the body can do.
  followSensors(limp);
  clipToLimits(*model_, allJoints(*model_) & ~limp, body_.angle);
  if (!body_.self_guarded) guard_.apply(before, dt_, body_.angle);
  if (limp == allJoints(*model_)) body_.awake = false;
  collectOutcomes();
  return {body_.angle, body_.stiffness.value()};
}

void MotionEngine::Impl::senseBalance(const SensorFrame& measured) {
  ground_.update(measured, dt_);
  const bool falls = fall_.update(measured, ground_.grounded(), dt_);
  body_.grounded = ground_.grounded();
  body_.upright = !fall_.falling() && !fall_.fallen();
  if (!body_.upright && walking_.ordered()) walking_.kill("the robot fell");
  if (falls) protectFromFall();
}

void MotionEngine::Impl::protectFromFall() {
  // Who goes to a posture may lie down on purpose, or get up; a limp robot has nothing to protect.
  const std::vector<Task> tasks = schedule_.tasks();
  const auto goes_to_posture = [](const Task& task) { return task.name == "goToPosture"; };
  if (std::any_of(tasks.begin(), tasks.end(), goes_to_posture)) return;
  if (limpJoints() == allJoints(*model_)) return;
  schedule_.killAll();
  setpoints_.clear(allJoints(*model_));
  for (const RequestId run : body_.stiffness.killAll()) report(run, MotionOutcome::Kind::Killed);
  schedule_.add(
      {0, "fallManager", allJoints(*model_), protectivePose(*model_, body_.measured), false});
}

JointSet MotionEngine::Impl::limpJoints() const {
  JointSet limp;
  for (std::size_t i = 0; i < model_->jointCount(); ++i) {
    if (body_.stiffness.value()[i] <= 0) limp.set(i);
  }
  return limp;
}

void MotionEngine::Impl::followSensors(const JointSet& limp) {
  for (std::size_t i = 0; i < model_->jointCount(); ++i) {
    if (limp.test(i)) body_.angle[i] = body_.measured.angle[i];
  }
}

MotionState MotionEngine::Impl::state() const {
  MotionState state;
  state.time = time_;
  state.last_accepted = last_accepted_;
  state.command = {body_.angle, body_.stiffness.value()};
  state.awake = body_.awake;
  state.stiffness = body_.stiffness.value();
  state.move_active = walking_.ordered();
  state.moves_failed = walking_.failures();
  state.failed_under_way = walking_.failedUnderWay();
  state.tasks = schedule_.tasks();
  state.falling = fall_.falling();
  state.fallen = fall_.fallen();
  for (std::size_t arm = 0; arm < CollisionGuard::kArms; ++arm) {
    state.arms[arm] = guard_.nearness(arm);
  }
  if (const Gait* gait = walking_.gait()) {
    state.position = gait->position();
    state.next_position = gait->nextPosition();
    state.velocity = gait->velocity();
    state.footsteps = gait->footsteps();
  }
  return state;
}

void MotionEngine::Impl::report(RequestId id, MotionOutcome::Kind kind, std::string reason) {
  outcomes_.push_back({id, kind, std::move(reason)});
}

void MotionEngine::Impl::collectOutcomes() {
  for (std::vector<MotionOutcome> ended : {schedule_.takeOutcomes(), walking_.takeOutcomes()}) {
    std::move(ended.begin(), ended.end(), std::back_inserter(outcomes_));
  }
}

std::vector<MotionOutcome> MotionEngine::Impl::takeOutcomes() {
  std::vector<MotionOutcome> taken;
  taken.swap(outcomes_);
  return taken;
}

void MotionEngine::Impl::forgetCallers() {
  schedule_.forgetCallers();
  body_.stiffness.forgetCallers();
  walking_.forgetCallers();
  outcomes_.clear();
}

// Not body_.measured: every cycle begins with a new frame, which the world's hash answers for.
void MotionEngine::Impl::archive(Archive& archive) {
  archive.value(body_.angle);
  body_.stiffness.archive(archive);
  archive.value(body_.upright);
  archive.value(body_.awake);
  schedule_.archive(archive);
  setpoints_.archive(archive);
  pose_goals_.archive(archive);
  walking_.archive(archive);
  whole_body_.archive(archive);
  idle_.archive(archive);
  fall_.archive(archive);
  ground_.archive(archive);
  guard_.archive(archive);
  archive.value(time_);
}

MotionEngine::MotionEngine(std::shared_ptr<const RobotModel> model, std::unique_ptr<Gait> gait,
                           RequestId last_accepted)
    : impl_(std::make_unique<Impl>(std::move(model), std::move(gait), last_accepted)) {}
MotionEngine::MotionEngine(const MotionEngine& other)
    : impl_(std::make_unique<Impl>(*other.impl_)) {}
MotionEngine& MotionEngine::operator=(const MotionEngine& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
MotionEngine::~MotionEngine() = default;

void MotionEngine::accept(const MotionRequest& request) { impl_->accept(request); }
JointCommand MotionEngine::update(const SensorFrame& measured) { return impl_->update(measured); }
MotionState MotionEngine::state() const { return impl_->state(); }
std::vector<MotionOutcome> MotionEngine::takeOutcomes() { return impl_->takeOutcomes(); }
void MotionEngine::forgetCallers() { impl_->forgetCallers(); }
void MotionEngine::addTo(Archive& hash) const {
  NAO_CHECK(hash.mode() == Archive::Mode::Hash);
  impl_->archive(hash);
}

}  // namespace nao::motion
