#include "runtime/replayer.h"

#include "core/check.h"
#include "core/overloaded.h"

namespace nao::runtime {

Replayer::Replayer(const Recording& recording, const RunStart& start)
    : recording_(recording), simulation_(start.makeSimulation()) {
  simulation_.watch(*this);
}

bool Replayer::isDue() const {
  return input_ < recording_.inputs.size() && recording_.inputs[input_].elapsed <= elapsed_;
}

void Replayer::takeInputs() {
  while (isDue()) carryOut(recording_.inputs[input_++]);
}

// What was taken over between two steps is so again; what came in a robot's cycle waits in its
// ports, whose cycle is next.
void Replayer::carryOut(const Recording::TimedInput& next) {
  Robot& robot = simulation_.robot(next.input.robot);
  motion::RobotPorts& ports = *robot.ports();
  std::visit(Overloaded{[&](const motion::MotionRequest& request) {
                          NAO_CHECK(ports.requests.post(request));
                          if (next.input.place == Input::Place::Between) robot.acceptRequests();
                        },
                        [&](const LedOrder& order) { NAO_CHECK(ports.leds.post(order)); },
                        [&](const BodyCommand& command) { ports.body.publish(command); },
                        [&](const WorldRequest& request) { simulation_.apply(request); }},
             next.input.content);
  ports.outcomes.drain();  // nobody waits for them
}

bool Replayer::step() {
  if (elapsed_ >= recording_.length()) return false;
  takeInputs();
  if (!simulation_.world().healthy()) return false;
  simulation_.advanceTo(simulation_.now() + simulation_.stepSize());
  return true;
}

void Replayer::advanceTo(Duration elapsed) {
  while (elapsed_ < elapsed && step()) {
  }
}

void Replayer::finish() {
  takeInputs();
  compare();
}

void Replayer::stepped(const Simulation& simulation) {
  elapsed_ += simulation.stepSize();
  compare();
}

void Replayer::compare() {
  const auto& states = recording_.states;
  while (state_ < states.size() && states[state_].elapsed <= elapsed_) {
    const Recording::State& state = states[state_];
    if (state.elapsed == elapsed_ && state.inputs > input_) return;  // after those
    ++state_;
    if (departure_) continue;
    if (simulation_.hash() == state.hash && simulation_.now() == state.time) {
      ++met_;
    } else {
      departure_ = state;
    }
  }
}

}  // namespace nao::runtime
