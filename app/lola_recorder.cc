#include "app/lola_recorder.h"

#include <cmath>

#include "validation/log/lola_rows.h"
#include "validation/log/standard_motions.h"

namespace nao::app {
namespace {

constexpr double kCycle = 0.012;  // [s] of LoLA
constexpr double kGlide = 3;      // [s] to the first pose: slow enough for any joint's way
constexpr double kRest = 1;       // [s] before a motion: ten times what a joint takes to settle

int cycles(double seconds) { return static_cast<int>(std::lround(seconds / kCycle)); }

}  // namespace

LolaRecorder::LolaRecorder(daemon::LolaLink& link, std::shared_ptr<const RobotModel> model)
    : link_(link), model_(std::move(model)) {
  command_ = validation::readLolaAngles(link_.receive());
  link_.send(validation::encodeLolaCommand(command_, Angles(command_.size(), 1)));
}

// Hands and what the model does not have stay where they are.
LolaRecorder::Angles LolaRecorder::order(const JointArray<double>& angles) const {
  Angles ordered = command_;
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    const auto joint = model_->findJoint(validation::lolaJoints()[i]);
    if (!joint || model_->actuators[index(*joint)].coordinates.empty()) continue;
    ordered[i] = angles[*joint];
  }
  return ordered;
}

// Both frames, as they went by.
std::string LolaRecorder::exchange(const Angles& command) {
  const std::string answer = validation::encodeLolaCommand(command, Angles(command.size(), 1));
  const std::string sensors = link_.receive();
  link_.send(answer);
  command_ = command;
  return sensors + answer;
}

void LolaRecorder::glideTo(const Angles& goal) {
  const Angles from = command_;
  const int steps = cycles(kGlide);
  for (int k = 1; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    Angles way = from;
    for (std::size_t i = 0; i < way.size(); ++i) way[i] += part * (goal[i] - from[i]);
    exchange(way);
  }
  for (int k = 0; k < cycles(kRest); ++k) exchange(goal);
}

validation::LogRun LolaRecorder::play(std::size_t motion, int repeat) {
  glideTo(order(validation::standardRest(*model_)));
  std::string frames;
  for (int k = 0; k <= cycles(validation::kStandardMotionTime); ++k) {
    frames += exchange(order(validation::standardAngles(*model_, motion, k * kCycle)));
  }
  validation::LogRun run = validation::readLolaRows(frames, "LoLA");
  run.motion = validation::standardMotions()[motion].name;
  run.split = validation::standardMotions()[motion].split;
  run.repeat = repeat;
  run.file = "run_" + run.motion + "_" + std::to_string(repeat) + ".csv";
  run.robot_id = model_->name;
  run.start_pose = "rest of the standard motions";
  return run;
}

validation::LogSet LolaRecorder::describe(const std::string& name) const {
  validation::LogSet set;
  set.name = name;
  set.source = "recorded over LoLA";
  set.robot = model_->name;
  set.version = model_->version;
  set.rate = 1 / kCycle;
  set.clock = {"robot", "sent", "measured"};
  for (const std::string& joint : validation::lolaJoints()) {
    set.joints.emplace_back();
    set.joints.back().name = joint;
  }
  return set;
}

}  // namespace nao::app
