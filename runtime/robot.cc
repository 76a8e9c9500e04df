#include "runtime/robot.h"

#include <utility>

#include "walk_engine/zmp_gait.h"

namespace nao::runtime {
namespace {

constexpr char kDrivenReason[] = "a LoLA client drives the robot's body";

motion::MotionEngine makeEngine(const std::shared_ptr<const RobotModel>& model) {
  auto gait = model->feet.size() == 2 ? walk::makeZmpGait(model) : nullptr;
  return {model, std::move(gait)};
}

}  // namespace

Robot::Robot(std::shared_ptr<const RobotModel> model)
    : model_(std::move(model)),
      ports_(std::make_shared<motion::RobotPorts>()),
      at_start_(makeEngine(model_)),
      motion_(at_start_) {
  publish();
}

void Robot::acceptRequests() {
  const auto requests = ports_->requests.drain();
  if (requests.empty() && unsent_.empty()) return;
  for (const motion::MotionRequest& request : requests) accept(request, Input::Place::Between);
  publish();
}

JointCommand Robot::tick(const SensorFrame& frame) {
  const bool drove = drive_.drives();
  const auto body = ports_->body.get();
  if (drive_.update(body.get(), frame.time) && told_) told_(Input::Place::Cycle, *body);
  if (drive_.drives() && !drove) powerCycle(motion::MotionOutcome::Kind::Failed, kDrivenReason);
  for (const motion::MotionRequest& request : ports_->requests.drain()) {
    accept(request, Input::Place::Cycle);
  }
  JointCommand command = motion_.update(frame);
  if (drive_.drives()) command = drive_.drive(*model_, frame);
  ports_->publish(std::make_shared<const SensorFrame>(frame));
  publish();
  return command;
}

void Robot::accept(const motion::MotionRequest& request, Input::Place place) {
  if (told_) told_(place, request);
  last_accepted_ = request.id;
  if (drive_.drives()) {
    unsent_.push_back({request.id, motion::MotionOutcome::Kind::Failed, kDrivenReason});
    return;
  }
  open_.insert(request.id);
  motion_.accept(request);
}

void Robot::restart() {
  acceptRequests();
  drive_.release();
  powerCycle(motion::MotionOutcome::Kind::Killed, "the robot was restarted");
  publish();
}

void Robot::powerCycle(motion::MotionOutcome::Kind kind, const char* reason) {
  endOpen(kind, reason);
  motion_ = at_start_;
}

Robot::Snapshot Robot::snapshot() const {
  Snapshot snapshot{motion_, drive_, ports_->sensors.get()};
  snapshot.motion.forgetCallers();
  return snapshot;
}

void Robot::restore(const Snapshot& snapshot) {
  for (const motion::MotionRequest& request : ports_->requests.drain()) {
    open_.insert(request.id);
    last_accepted_ = request.id;
  }
  endOpen(motion::MotionOutcome::Kind::Failed, motion::kSetBackReason);
  ++set_back_;
  motion_ = snapshot.motion;
  drive_.restore(snapshot.drive);
  ports_->publish(snapshot.sensors);
  publish();
}

void Robot::endOpen(motion::MotionOutcome::Kind kind, const char* reason) {
  for (const motion::RequestId id : open_) unsent_.push_back({id, kind, reason});
  open_.clear();
}

void Robot::publish() {
  motion::MotionState state = motion_.state();
  state.last_accepted = last_accepted_;
  state.set_back = set_back_;
  state.driven = drive_.drives();
  if (state.driven) {
    state.command = drive_.given();
    state.stiffness = state.command.stiffness;
  }
  ports_->state.publish(std::move(state));
  for (motion::MotionOutcome& outcome : motion_.takeOutcomes()) {
    open_.erase(outcome.id);
    unsent_.push_back(std::move(outcome));
  }
  std::size_t sent = 0;
  while (sent < unsent_.size() && ports_->outcomes.post(unsent_[sent])) ++sent;
  unsent_.erase(unsent_.begin(), unsent_.begin() + static_cast<std::ptrdiff_t>(sent));
}

}  // namespace nao::runtime
