#include "motion/motion_engine.h"

#include <algorithm>
#include <iterator>

#include "core/check.h"
#include "motion/limits.h"
#include "motion/motion_engine_impl.h"

namespace nao::motion {

MotionEngine::Impl::Impl(std::shared_ptr<const RobotModel> model, std::unique_ptr<Gait> gait,
                         RequestId last_accepted)
    : model_(std::move(model)),
      dt_(toSeconds(model_->cycle)),
      legs_(jointsOfGroup(*model_, "LLeg") | jointsOfGroup(*model_, "RLeg")),
      limbs_(legs_ | jointsOfGroup(*model_, "LArm") | jointsOfGroup(*model_, "RArm")),
      body_(*model_),
      setpoints_(model_->jointCount()),
      direct_(model_->jointCount()),
      walking_(*model_, std::move(gait)),
      whole_body_(model_),
      idle_(*model_),
      fall_(model_),
      guard_(*model_),
      spare_(model_),
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
  direct_.applyStiffness(time_,
                         [this](Joint joint, double value) { body_.stiffness.set(joint, value); });
  const JointSet limp = limpJoints();
  setpoints_.clear(limp);
  pose_goals_.release(limp);
  const JointSet held =
      schedule_.booked() | setpoints_.active() | pose_goals_.active() | direct_.activeAngles();
  setpoints_.advance(dt_, body_.angle);
  pose_goals_.advance(dt_, body_.angle);
  if (!walking_.ordered()) whole_body_.apply(dt_, before, held, limp, body_.angle);
  walking_.update(dt_, held, body_);
  idle_.update(dt_, held | limp | (walking_.active() ? limbs_ : JointSet{}), body_);

  direct_.apply(time_, body_.angle);

  // What the body can do.
  followSensors(limp);
  clipToLimits(*model_, allJoints(*model_) & ~limp, body_.angle);
  if (!body_.self_guarded) guard_.apply(before, dt_, body_.angle);
  if (limp == allJoints(*model_)) body_.awake = false;
  spare_.update(dt_, measured, body_.angle, body_.stiffness.value());
  collectOutcomes();
  return {body_.angle, spare_.value()};
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
  pose_goals_.release(allJoints(*model_));
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
  state.command = {body_.angle, spare_.value()};
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
  direct_.archive(archive);
  pose_goals_.archive(archive);
  walking_.archive(archive);
  whole_body_.archive(archive);
  idle_.archive(archive);
  fall_.archive(archive);
  ground_.archive(archive);
  guard_.archive(archive);
  spare_.archive(archive);
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
MotionEngine::MotionEngine(MotionEngine&& other) noexcept = default;
MotionEngine& MotionEngine::operator=(MotionEngine&& other) noexcept = default;
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
