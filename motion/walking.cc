#include "motion/walking.h"

#include <algorithm>
#include <cmath>

#include "core/overloaded.h"
#include "motion/phases.h"
#include "motion/postures.h"

namespace nao::motion {
namespace {

// ALMotion.xml, ENABLE_STIFFNESS_PROTECTION: no walk on legs this soft.
constexpr double kSoftLegs = 0.6;

// Free: arms join the swing and leave it no faster than a strolling swing itself.
constexpr double kArmSpeed = 2.0;  // [rad/s]

const char* const kWalkPosture = "StandInit";

}  // namespace

/// Holds the legs for the walk: first to the pose it starts from, then while the gait is active.
class Walking::LegsPhase final : public Phase {
 public:
  void begin(Body& body) override {
    const Walking& walking = *body.walking;
    const Posture* stand = body.model.findPosture(kWalkPosture);
    if (!walking.ordered() || !walking.refusal(body).empty() || stand == nullptr ||
        legsAreNear(body.model, body.angle, *stand)) {
      return;
    }
    to_start_ = glideTo(body.model, *stand, 1.0);
    to_start_->begin(body);
  }

  Progress advance(double dt, const JointSet& mine, Body& body) override {
    Walking& walking = *body.walking;
    // Even a walk that was called off meanwhile ends in a pose the robot can stand in.
    if (to_start_) {
      if (to_start_->advance(dt, mine, body) == Progress::Running) return Progress::Running;
      to_start_.reset();
    }
    if (walking.state_ == State::Idle) return Progress::Done;
    if (walking.state_ == State::Ordered) walking.start(body);
    return walking.state_ == State::Idle ? Progress::Done : Progress::Running;
  }

  std::unique_ptr<Phase> clone() const override { return std::make_unique<LegsPhase>(*this); }
  void archive(Archive& archive) override {
    bool at_start = !to_start_;
    archive.value(at_start);
    if (to_start_) to_start_->archive(archive);
  }

 private:
  ValuePtr<Phase> to_start_;
};

Walking::Walking(const RobotModel& model, std::unique_ptr<Gait> gait)
    : model_(model),
      gait_(std::move(gait)),
      legs_(jointsOfGroup(model, "LLeg") | jointsOfGroup(model, "RLeg")),
      left_arm_(jointsOfGroup(model, "LArm")),
      right_arm_(jointsOfGroup(model, "RArm")) {}

bool Walking::order(RequestId id, const WalkOrder& order) {
  const auto* const steps = std::get_if<WalkSteps>(&order);
  const bool awaited = std::holds_alternative<MoveTo>(order) || (steps && steps->awaited);
  if (!awaited) outcomes_.push_back({id, MotionOutcome::Kind::Done, {}});
  if (isStand(order)) {
    stop(0);
    return false;
  }
  endOrder(MotionOutcome::Kind::Killed, "a later move took its place");
  order_ = order;
  id_ = id;
  awaited_ = awaited;
  stopping_ = false;
  if (state_ == State::Walking) {
    handToGait();
    return false;
  }
  const bool needs_legs = state_ == State::Idle;
  state_ = State::Ordered;
  return needs_legs;
}

std::unique_ptr<Phase> Walking::phase() { return std::make_unique<LegsPhase>(); }

bool Walking::isStand(const WalkOrder& order) const {
  return std::visit(
      Overloaded{
          [](const MoveTo&) { return false; }, [](const WalkSteps& w) { return w.steps.empty(); },
          [](const Move& move) {
            return move.velocity.x == 0 && move.velocity.y == 0 && move.velocity.theta == 0;
          },
          [](const MoveToward& move) { return move.x == 0 && move.y == 0 && move.theta == 0; }},
      order);
}

std::string Walking::refusal(const Body& body) const {
  if (!gait_) return "this robot does not walk";
  if (!body.upright) return "the robot is not on its feet";
  if (protection_.foot_contact && !body.grounded) return "no foot feels the ground";
  for (std::size_t i = 0; protection_.stiffness && i < model_.jointCount(); ++i) {
    if (legs_.test(i) && body.stiffness.value()[i] <= kSoftLegs) {
      return "the legs are too soft to walk: every stiffness must be above 0.6";
    }
  }
  return {};
}

void Walking::start(const Body& body) {
  const std::string reason = refusal(body);
  if (!reason.empty()) return fail(reason);
  state_ = State::Walking;
  commanded_.reset();
  handToGait();
}

void Walking::handToGait() {
  std::visit(Overloaded{[this](const MoveTo& to) { gait_->walkTo(to.target, to.config); },
                        [this](const WalkSteps& to) { gait_->walkSteps(to.steps, to.clear); },
                        [this](const Move& move) { gait_->walkAt(move.velocity, move.config); },
                        [this](const MoveToward& move) {
                          gait_->walkToward(move.x, move.y, move.theta, move.config);
                        }},
             order_);
}

void Walking::stop(RequestId id) {
  if (id != 0) stops_.push_back(id);
  if (state_ == State::Walking) {
    stopping_ = true;
    gait_->stop();
  } else {
    becomeIdle(MotionOutcome::Kind::Killed);
  }
}

bool Walking::stopRequest(RequestId id) {
  if (state_ == State::Idle || id == 0 || id != id_) return false;
  endOrder(MotionOutcome::Kind::Killed);
  stop(0);
  return true;
}

void Walking::kill(const std::string& reason) {
  if (state_ == State::Walking) gait_->kill();
  if (!reason.empty()) return fail(reason);
  becomeIdle(MotionOutcome::Kind::Killed);
}

void Walking::fail(const std::string& reason) {
  ++failures_;
  failed_under_way_ = state_ == State::Walking;
  becomeIdle(MotionOutcome::Kind::Failed, reason);
}

void Walking::update(double dt, const JointSet& held, Body& body) {
  if (state_ != State::Walking) return;
  const std::string reason = refusal(body);
  if (!reason.empty()) return kill(reason);
  commanded_ |= held;
  JointCommand command{body.angle, body.stiffness.value()};
  gait_->update(body.measured, command);
  const JointSet arms = swingingArms();
  for (std::size_t i = 0; i < model_.jointCount(); ++i) {
    const double way = command.angle[i] - body.angle[i];
    if (legs_.test(i)) body.angle[i] = command.angle[i];
    if (arms.test(i)) body.angle[i] += std::clamp(way, -kArmSpeed * dt, kArmSpeed * dt);
  }
  if (gait_->active()) return;
  becomeIdle(stopping_ ? MotionOutcome::Kind::Killed : MotionOutcome::Kind::Done);
}

JointSet Walking::swingingArms() const {
  JointSet arms;
  if (move_arms_.left) arms |= left_arm_;
  if (move_arms_.right) arms |= right_arm_;
  return arms & ~commanded_;
}

void Walking::endOrder(MotionOutcome::Kind kind, const std::string& reason) {
  if (awaited_) outcomes_.push_back({id_, kind, reason});
  awaited_ = false;
}

void Walking::becomeIdle(MotionOutcome::Kind kind, const std::string& reason) {
  endOrder(kind, reason);
  for (const RequestId id : stops_) outcomes_.push_back({id, MotionOutcome::Kind::Done, {}});
  stops_.clear();
  state_ = State::Idle;
  stopping_ = false;
}

void Walking::forgetCallers() {
  id_ = 0;
  awaited_ = false;
  stops_.clear();
  outcomes_.clear();
}

void Walking::archiveOrder(Archive& archive) {
  auto kind = static_cast<std::uint64_t>(order_.index());
  archive.value(kind);
  std::visit(Overloaded{[&](MoveTo& to) {
                          archive.value(to.target);
                          double time = to.time.value_or(0);
                          archive.value(time);
                          archiveConfig(archive, to.config);
                        },
                        [&](WalkSteps& walk) {
                          archive.each(walk.steps, [&archive](StepOrder& step) {
                            archive.value(step.foot);
                            archive.value(step.place);
                            archive.value(step.period);
                          });
                          archive.value(walk.clear);
                        },
                        [&](Move& move) {
                          archive.value(move.velocity);
                          archiveConfig(archive, move.config);
                        },
                        [&](MoveToward& move) {
                          archive.value(move.x);
                          archive.value(move.y);
                          archive.value(move.theta);
                          archiveConfig(archive, move.config);
                        }},
             order_);
}

void Walking::archive(Archive& archive) {
  archive.value(move_arms_);
  archive.value(protection_);
  archive.value(state_);
  if (state_ != State::Idle) archiveOrder(archive);
  archive.value(stopping_);
  archive.value(failures_);
  archive.value(failed_under_way_);
  archive.value(commanded_);
  if (gait_) gait_->archive(archive);
}

std::vector<MotionOutcome> Walking::takeOutcomes() {
  std::vector<MotionOutcome> taken;
  taken.swap(outcomes_);
  return taken;
}

}  // namespace nao::motion
