#include "ci/director.h"

#include <utility>

#include "ci/sentence.h"
#include "core/check.h"

namespace nao::ci {
namespace {

std::vector<memory::RobotMemory*> memoriesOf(daemon::Daemon& daemon) {
  std::vector<memory::RobotMemory*> memories;
  for (std::size_t i = 0; i < daemon.robotCount(); ++i) memories.push_back(&daemon.memory(i));
  return memories;
}

}  // namespace

Director::Director(Scenario scenario, daemon::Daemon& daemon, Stage stage)
    : scenario_(std::move(scenario)),
      daemon_(daemon),
      stage_(std::move(stage)),
      hearing_(scenario_, memoriesOf(daemon)),
      judge_(scenario_.expectations),
      violations_(scenario_.robots.size()) {
  daemon.follow(*this);
}

Director::~Director() = default;

// The same moment is looked at again when clients' calls were served in it: what they raised counts
// for the next beat.
bool Director::look(const daemon::LoopState& state) {
  if (!state.healthy && !std::exchange(told_diverged_, true)) stage_.over();
  if (looked_ == state.time || !state.healthy) return false;
  looked_ = state.time;
  disturbWires(state.time);
  NAO_CHECK(looks_.post({state.time, hearing_.take(), stage_.take_ended()}));
  return true;
}

void Director::disturbWires(SimTime now) {
  const auto& events = scenario_.events;
  for (; next_wire_event_ < events.size(); ++next_wire_event_) {
    const Event& event = events[next_wire_event_];
    if (event.at > now.time_since_epoch()) return;
    const auto* deed = std::get_if<DisturbWire>(&event.deed);
    if (deed) daemon_.disturbWire(deed->robot, {deed->delay, deed->loss, now + deed->duration});
  }
}

bool Director::waits(SimTime now) {
  for (Look& look : looks_.drain()) new_looks_.push_back(std::move(look));
  return is_over_ || new_looks_.empty() || new_looks_.back().time != now;
}

Moment Director::makeMoment(runtime::Simulation& simulation) {
  Moment moment;
  moment.now = simulation.now();
  moment.scene = std::make_shared<const SceneFrame>(simulation.world().scene());
  for (std::size_t i = 0; i < simulation.robotCount(); ++i) {
    moment.sensors.push_back(simulation.robot(i).ports()->sensors.get());
  }
  for (Look& look : std::exchange(new_looks_, {})) {
    auto& events = moment.heard.events;
    for (HeardEvent& event : look.heard.events) events.push_back(std::move(event));
    moment.heard.memory = std::move(look.heard.memory);
    for (const EndedClient& ended : look.ended) moment.ended.push_back(ended);
  }
  moment.violations = violations_.look(simulation, moment.sensors);
  return moment;
}

void Director::direct(runtime::Simulation& simulation) {
  if (is_over_) return;
  now_ = simulation.now();
  if (now_ == SimTime{}) return act(simulation);  // nothing has been measured yet
  const Moment moment = makeMoment(simulation);
  judge_.look(moment);
  last_seconds_.look(simulation, moment.scene, judge_.hasFailed());
  if (now_.time_since_epoch() >= scenario_.duration) return end();
  act(simulation);
}

void Director::act(runtime::Simulation& simulation) {
  const auto& events = scenario_.events;
  for (; next_event_ < events.size(); ++next_event_) {
    const Event& event = events[next_event_];
    if (event.at > now_.time_since_epoch()) return;
    const auto* deed = std::get_if<runtime::WorldRequest>(&event.deed);
    if (!deed) continue;  // the wire's: see look()
    try {
      simulation.apply(*deed);
    } catch (const InputError& error) {
      return end(event.text + " at " + shown(event.at) + ": " + error.what());
    }
  }
}

void Director::end(std::string trouble) {
  trouble_ = std::move(trouble);
  is_over_ = true;
  stage_.over();
}

Result Director::result() {
  Result result;
  result.scenario = scenario_.name;
  result.file = scenario_.file;
  result.about = scenario_.about;
  result.seed = scenario_.seed;
  result.drawn = scenario_.drawn;
  result.time = toSeconds(now_);
  result.verdicts = judge_.finish(now_);
  result.trouble = trouble_;
  if (told_diverged_)
    result.trouble = "the physics diverged after " + shown(now_.time_since_epoch());
  if (!is_over_ && result.trouble.empty()) {
    result.trouble = "the world ended after " + shown(now_.time_since_epoch());
  }
  if (!result.passed()) result.course = last_seconds_.take();
  return result;
}

}  // namespace nao::ci
