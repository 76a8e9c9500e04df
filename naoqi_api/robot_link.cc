#include "naoqi_api/robot_link.h"

#include <algorithm>
#include <iterator>

namespace nao::services {

RobotLink::RobotLink(std::shared_ptr<const RobotModel> model,
                     std::shared_ptr<motion::RobotPorts> ports)
    : model_(std::move(model)), ports_(std::move(ports)) {}

motion::RequestId RobotLink::post(motion::MotionAction action) {
  if (!ports_->requests.post({last_posted_ + 1, std::move(action)})) {
    throw rpc::CallError("the robot is busy: too many requests wait to be taken over");
  }
  return ++last_posted_;
}

void RobotLink::kill(motion::RequestId id) {
  if (ports_->requests.post({last_posted_ + 1, motion::Kill{id}})) ++last_posted_;
}

rpc::Pending<motion::MotionOutcome> RobotLink::outcomeOf(motion::RequestId id) {
  rpc::Pending<motion::MotionOutcome> pending;
  pending.onCancel([this, id] {
    awaited_.erase(id);
    kill(id);
  });
  awaited_.emplace(id, pending);
  return pending;
}

rpc::Pending<void> RobotLink::postAndWait(motion::MotionAction action) {
  const auto motion = outcomeOf(post(std::move(action)));
  rpc::Pending<void> done;
  motion.whenDone([done](const auto& outcome) {
    if (outcome.isCanceled()) return done.cancelNow();
    if (outcome.value->kind == motion::MotionOutcome::Kind::Failed) {
      return done.fail(outcome.value->reason);
    }
    done.resolve();
  });
  done.onCancel(motion.canceler());
  return done;
}

rpc::Pending<void> RobotLink::until(std::function<bool(const motion::MotionState&)> condition) {
  const auto state = ports_->state.get();
  Waiting waiting{last_posted_, state ? state->set_back : 0, std::move(condition), {}};
  waiting.pending.onlyWaits();
  if (holds(waiting, state.get())) {
    waiting.pending.resolve();
  } else {
    forgetCanceled();
    waiting_.push_back(waiting);
  }
  return waiting.pending;
}

// Clients come, wait and go also while time stands still.
void RobotLink::forgetCanceled() {
  if (waiting_.size() < forget_at_) return;
  const auto is_done = [](const Waiting& waiting) { return waiting.pending.isDone(); };
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_done), waiting_.end());
  forget_at_ = std::max(kForgetAt, 2 * waiting_.size());
}

bool RobotLink::isSettled() const {
  const auto state = ports_->state.get();
  return state && state->last_accepted >= last_posted_;
}

bool RobotLink::holds(const Waiting& waiting, const motion::MotionState* state) {
  if (state == nullptr || state->last_accepted < waiting.posted) return false;
  return !waiting.condition || waiting.condition(*state);
}

std::shared_ptr<const SensorFrame> RobotLink::sensors() const {
  auto frame = ports_->sensors.get();
  if (!frame) throw rpc::CallError("the robot is starting");
  return frame;
}

std::shared_ptr<const motion::MotionState> RobotLink::state() const {
  auto state = ports_->state.get();
  if (!state) throw rpc::CallError("the robot is starting");
  return state;
}

SimTime RobotLink::now() const {
  const auto state = ports_->state.get();
  return state ? state->time : SimTime{};
}

std::uint64_t RobotLink::after(Duration delay, std::function<void()> callback) {
  keepDelays();
  timers_.emplace(now() + delay, Timer{++last_timer_, std::move(callback)});
  return last_timer_;
}

void RobotLink::cancelTimer(std::uint64_t timer) {
  const auto found = std::find_if(timers_.begin(), timers_.end(),
                                  [timer](const auto& entry) { return entry.second.id == timer; });
  if (found != timers_.end()) timers_.erase(found);
}

void RobotLink::deliver() {
  deliverTouches();
  deliverOutcomes();
  deliverConditions();
  deliverTimers();
}

void RobotLink::deliverTouches() {
  for (const auto& frame : ports_->touches.drain()) tellTouch(frame);
  tellTouch(ports_->sensors.get());  // if some did not fit
}

void RobotLink::tellTouch(const std::shared_ptr<const SensorFrame>& frame) {
  if (!frame || motion::feelTheSame(*frame, touch_told_ ? *touch_told_ : SensorFrame())) return;
  touch_told_ = frame;
  for (const Touched& tell : on_touch_) tell(frame);
}

void RobotLink::deliverOutcomes() {
  for (motion::MotionOutcome& outcome : ports_->outcomes.drain()) {
    const auto node = awaited_.extract(outcome.id);
    if (!node.empty()) node.mapped().resolve(std::move(outcome));
  }
}

void RobotLink::deliverConditions() {
  const auto state = ports_->state.get();
  // What is told may ask and post again: only then is the list left as it is.
  std::vector<Waiting> before;
  before.swap(waiting_);
  std::vector<Waiting> fulfilled;
  std::vector<Waiting> overtaken;
  for (Waiting& waiting : before) {
    if (waiting.pending.isDone()) continue;  // canceled
    const bool set_back = state && state->set_back != waiting.set_back;
    auto& next = set_back ? overtaken : holds(waiting, state.get()) ? fulfilled : waiting_;
    next.push_back(std::move(waiting));
  }
  for (const Waiting& waiting : overtaken) waiting.pending.fail(motion::kSetBackReason);
  for (const Waiting& waiting : fulfilled) waiting.pending.resolve();
}

// Time does not only pass, it is also set back: what is left of a delay stays.
void RobotLink::keepDelays() {
  const auto state = ports_->state.get();
  if (!state) return;
  if (state->set_back != set_back_) {
    const Duration jump = state->time - last_now_;
    std::multimap<SimTime, Timer> moved;
    for (auto& [due, timer] : timers_) moved.emplace(due + jump, std::move(timer));
    timers_ = std::move(moved);
    set_back_ = state->set_back;
  }
  last_now_ = state->time;
}

void RobotLink::deliverTimers() {
  keepDelays();
  const SimTime now = this->now();
  while (!timers_.empty() && timers_.begin()->first <= now) {
    const auto timer = timers_.extract(timers_.begin());
    timer.mapped().callback();
  }
}

}  // namespace nao::services
