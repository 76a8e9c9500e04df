#include "daemon/robot_loop.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/check.h"
#include "core/overloaded.h"
#include "daemon/prompt_thread.h"

namespace nao::daemon {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""ns;

constexpr char kDiverged[] = "the physics diverged; reset the world first";
constexpr auto kGuestsTurn = std::chrono::microseconds(200);  // between two looks at their requests
constexpr Duration kCycle = 10ms;  // how much is simulated between two looks at requests

}  // namespace

RobotLoop::RobotLoop(runtime::Simulation& simulation, double speed,
                     std::function<void()> after_cycle)
    : simulation_(simulation),
      after_cycle_(std::move(after_cycle)),
      beats_{kCycle},
      pace_(speed, simulation.now(), std::chrono::steady_clock::now()) {
  publish();
}

RobotLoop::~RobotLoop() { stop(); }

void RobotLoop::start() {
  publish();  // who asks before the first turn is told the truth, too
  thread_ = std::thread([this] { run(); });
}

void RobotLoop::stop() {
  stopping_ = true;
  wake();
  if (thread_.joinable()) thread_.join();
}

void RobotLoop::finish(std::function<void()> ended) {
  at_end_.publish(std::move(ended));
  wake();
}

bool RobotLoop::post(LoopRequest request) {
  if (!requests_.post(std::move(request))) return false;
  wake();
  return true;
}

void RobotLoop::wake() {
  {
    const std::lock_guard lock(mutex_);
    awake_ = true;
  }
  changed_.notify_one();
}

void RobotLoop::run() {
  makeThreadPrompt();
  pace_.restart(pace_.speed(), simulation_.now(), std::chrono::steady_clock::now());
  while (!stopping_) {
    handleRequests();
    const auto ended = at_end_.get();  // before time is found to stand
    const bool stands = timeStands();
    if (ended && stands) {
      (*ended)();
      break;
    }
    if (!stands && !awaitsPictures()) {
      advance();
    } else {  // a paused world still accepts what clients ask, so that nobody waits for that
      simulation_.acceptRequests();
      waitUntil(std::chrono::steady_clock::now() + 5ms);
    }
    publish();
    after_cycle_();
  }
  paused_ = true;
  publish();
}

bool RobotLoop::timeStands() {
  if (!simulation_.world().healthy() || (paused_ && steps_left_ == 0)) return true;
  return std::any_of(waits_.begin(), waits_.end(),
                     [this](const auto& waits) { return waits(simulation_.now()); });
}

bool RobotLoop::awaitsPictures() {
  const bool exact =
      paused_ || turns_ || std::isinf(pace_.speed());  // else a late picture is dropped
  return exact && hold_ && hold_();
}

void RobotLoop::advance() {
  if (paused_) {
    const Duration step = simulation_.stepSize();
    const Duration rest = nextBeat() - simulation_.now();
    const std::int64_t steps = std::min<std::int64_t>(steps_left_, (rest + step - 1ns) / step);
    advanceTo(simulation_.now() + steps * step);
    const bool healthy = simulation_.world().healthy();
    steps_left_ = healthy ? steps_left_ - steps : 0;
    if (steps_left_ == 0) finish(step_request_, healthy ? "" : kDiverged);
    return;
  }
  const auto wall = std::chrono::steady_clock::now();
  const auto due = pace_.due(simulation_.now(), wall);
  if (due > wall) waitUntil(due);
  if (due > std::chrono::steady_clock::now()) return;
  advanceTo(nextBeat());
  if (told_) told_(std::chrono::steady_clock::now() - due);
}

void RobotLoop::keepBeat(Duration cycle) {
  beats_.push_back(cycle);
  pace_.setPatience(cycle);
}

SimTime RobotLoop::nextBeat() const {
  SimTime next = SimTime::max();
  for (const Duration beat : beats_) {
    const auto passed = simulation_.now().time_since_epoch() / beat;
    next = std::min(next, SimTime(beat * (passed + 1)));
  }
  return next;
}

void RobotLoop::advanceTo(SimTime time) {
  if (before_beat_) before_beat_();
  const auto cycles = simulation_.now().time_since_epoch() / kCycle;
  simulation_.advanceTo(time);
  if (simulation_.now().time_since_epoch() / kCycle != cycles) hostGuests();
  if (simulation_.world().healthy()) return;
  spdlog::error("the physics diverged at {} s: time stands until UsarSim.reset",
                toSeconds(simulation_.now()));
}

// The robot answers its guests, who act at one simulated time: whatever they take, the same
// requests meet the same cycle.
void RobotLoop::hostGuests() {
  if (!guests_.begin) return;
  publish();
  after_cycle_();
  if (!guests_.begin()) return;
  while (!stopping_ && guests_.holds_time()) {
    simulation_.acceptRequests();
    publish();
    after_cycle_();
    waitUntil(std::chrono::steady_clock::now() + kGuestsTurn);
  }
  simulation_.acceptRequests();
}

void RobotLoop::waitUntil(Pace::Wall wall) {
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, wall, [this] { return awake_; });
  awake_ = false;
}

void RobotLoop::handleRequests() {
  for (const LoopRequest& request : requests_.drain()) handle(request);
}

void RobotLoop::handle(const LoopRequest& request) {
  const auto restart = [this](double speed) {
    pace_.restart(speed, simulation_.now(), std::chrono::steady_clock::now());
  };
  std::visit(Overloaded{[&](const PauseWorld&) {
                          paused_ = true;
                          endSteps();
                          finish(request.id);
                        },
                        [&](const ResumeWorld&) {
                          paused_ = false;
                          restart(pace_.speed());
                          endSteps();
                          finish(request.id);
                        },
                        [&](const StepWorld& r) {
                          if (!paused_ || steps_left_ > 0) {
                            return finish(request.id, "the world must be paused to step it");
                          }
                          if (!simulation_.world().healthy()) return finish(request.id, kDiverged);
                          steps_left_ = std::max<std::int64_t>(r.steps, 0);
                          step_request_ = request.id;
                          if (steps_left_ == 0) finish(request.id);
                        },
                        [&](const SetSpeed& r) {
                          restart(r.speed);
                          finish(request.id);
                        },
                        [&](const runtime::WorldRequest& r) { apply(request.id, r); }},
             request.action);
}

void RobotLoop::apply(std::uint64_t id, const runtime::WorldRequest& request) {
  try {
    const SimTime before = simulation_.now();
    simulation_.apply(request);
    if (simulation_.now() != before) {
      pace_.restart(pace_.speed(), simulation_.now(), std::chrono::steady_clock::now());
    }
    if (std::holds_alternative<runtime::RestoreSnapshot>(request)) {
      endSteps(motion::kSetBackReason);
    }
    finish(id);
  } catch (const InputError& error) {
    finish(id, error.what());
  }
}

// Who asked for steps is told when somebody else decides otherwise.
void RobotLoop::endSteps(const char* reason) {
  if (std::exchange(steps_left_, 0) > 0) finish(step_request_, reason);
}

void RobotLoop::finish(std::uint64_t id, std::string error) {
  unsent_.push_back({id, std::move(error)});
}

void RobotLoop::publish() {
  LoopState state;
  state.time = simulation_.now();
  state.speed = pace_.speed();
  state.paused = paused_;
  state.healthy = simulation_.world().healthy();
  if (paused_) state.hash = simulation_.hash();
  state.snapshots = simulation_.snapshotNames();
  state_.publish(state);
  showTime();
  std::size_t sent = 0;
  while (sent < unsent_.size() && outcomes_.post(unsent_[sent])) ++sent;
  unsent_.erase(unsent_.begin(), unsent_.begin() + static_cast<std::ptrdiff_t>(sent));
}

}  // namespace nao::daemon
