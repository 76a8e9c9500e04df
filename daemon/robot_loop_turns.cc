// The loop of a world whose clients' clocks are its own: their time never goes back and goes on
// while the world is paused, so that nobody who sleeps then sleeps for ever.
#include <algorithm>
#include <cmath>

#include "clock/futex.h"
#include "daemon/robot_loop.h"

namespace nao::daemon {
namespace {

using std::chrono_literals::operator""ms;

constexpr Duration kPausedBeat = 10ms;
constexpr Duration kCallCost{clock::kCallCost};

}  // namespace

void RobotLoop::showTime() {
  const SimTime now = simulation_.now();
  if (now < shown_) ahead_ += shown_ - now;  // set back
  shown_ = now;
  if (!page_ || turns_) return;
  page_->now = (now.time_since_epoch() + ahead_).count();
  page_->speed = pace_.speed();
  clock::ring(page_->beat);
}

void RobotLoop::alternateWith(WorldTurns& turns, const std::function<bool()>& ended) {
  turns_ = &turns;
  pace_.restart(pace_.speed(), simulation_.now(), std::chrono::steady_clock::now());
  advanceTo(nextBeat());  // there is something to be seen of the robots when clients come
  settle();
  turns_->passTo(simulation_.now().time_since_epoch());
  turns_->setDue(dueOfTurns());
  while (!ended()) takeTurn();
  paused_ = true;
  publish();
}

void RobotLoop::takeTurn() {
  if (!turns_->await()) return;
  const bool heard = turns_->hearClients();
  const bool told = heard && settle();
  if (heard && told) turns_->pass(kCallCost);
  if (!told && turns_->everybodyWaits()) goOnTo(std::min(dueOfTurns(), turns_->firstDeadline()));
  while (turns_->now() >= dueOfTurns()) {
    beatOfTurns();
    settle();
  }
  turns_->setDue(dueOfTurns());
  turns_->give();
}

// All that clients have asked for is accepted and answered, as far as that takes no time.
bool RobotLoop::settle() {
  bool told = false;
  for (bool more = true; more;) {
    handleRequests();
    simulation_.acceptRequests();
    publish();
    after_cycle_();
    more = turns_->tellClients();
    told |= more;
  }
  return told;
}

// When clients' clocks next meet the simulation.
Duration RobotLoop::dueOfTurns() const { return nextBeat().time_since_epoch() + ahead_; }

// Lets the wall come as far as the speed demands.
void RobotLoop::goOnTo(Duration time) {
  const SimTime target(time - ahead_);
  for (;;) {
    const auto wall = std::chrono::steady_clock::now();
    const auto due = pace_.due(target, wall);
    if (due <= wall) break;
    waitUntil(due);
  }
  turns_->passTo(time);
}

// One beat of the simulation, or of a paused one's clients alone.
void RobotLoop::beatOfTurns() {
  waitForPictures();
  if (timeStands() || awaitsPictures()) {
    ahead_ += kPausedBeat;
  } else if (paused_) {
    advance();
  } else {
    advanceTo(nextBeat());
  }
  waitForPictures();
}

void RobotLoop::waitForPictures() {
  after_cycle_();
  while (hold_ && hold_()) waitUntil(std::chrono::steady_clock::now() + 5ms);
}

}  // namespace nao::daemon
