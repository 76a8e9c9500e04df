#include "recorder/lola_recorder.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "recorder/recorded_run.h"
#include "validation/log/lola_rows.h"
#include "validation/log/standard_motions.h"

namespace nao::recorder {
namespace {

using validation::LogRun;
using validation::LogSet;

constexpr double kCycle = 0.012;  // [s] of LoLA

int cycles(double seconds) { return static_cast<int>(std::lround(seconds / kCycle)); }

void requireKnown(const RobotModel& model, const std::vector<std::string>& names) {
  const std::vector<std::string>& all = validation::lolaJoints();
  for (const std::string& name : names) {
    if (model.findJoint(name) && std::find(all.begin(), all.end(), name) != all.end()) continue;
    throw InputError("--joints " + name + ": LoLA and " + model.name + " have no such joint");
  }
}

}  // namespace

LolaRecorder::LolaRecorder(daemon::LolaLink& link, std::shared_ptr<const RobotModel> model,
                           const std::vector<std::string>& moving)
    : link_(link), model_(std::move(model)) {
  requireKnown(*model_, moving);
  const std::vector<std::string>& names = validation::lolaJoints();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool asked =
        moving.empty() || std::find(moving.begin(), moving.end(), names[i]) != moving.end();
    const auto joint = model_->findJoint(names[i]);
    if (!asked || !joint || model_->actuators[index(*joint)].coordinates.empty()) continue;
    moves_.push_back(*joint);
    slots_.push_back(i);
  }
  command_ = validation::readLolaAngles(link_.receive());
  link_.send(validation::encodeLolaCommand(command_, Angles(command_.size(), 1)));
}

// What does not move stays where it is.
LolaRecorder::Angles LolaRecorder::order(const JointArray<double>& angles) const {
  Angles ordered = command_;
  for (std::size_t i = 0; i < moves_.size(); ++i) ordered[slots_[i]] = angles[moves_[i]];
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

std::string LolaRecorder::hold(double seconds) {
  std::string frames;
  for (int k = 0; k < cycles(seconds); ++k) frames += exchange(command_);
  return frames;
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
  hold(kRest);
}

LogRun LolaRecorder::play(std::size_t motion, int repeat) {
  glideTo(order(validation::standardRest(*model_)));
  std::string frames;
  for (int k = 0; k <= cycles(validation::kStandardMotionTime); ++k) {
    frames += exchange(order(validation::standardAngles(*model_, motion, k * kCycle)));
  }
  const auto& standard = validation::standardMotions()[motion];
  LogRun run = makeRun(standard.name, standard.split, repeat, *model_);
  LogRun rows = validation::readLolaRows(frames, "LoLA");
  run.t = std::move(rows.t);
  run.columns = std::move(rows.columns);
  run.start_pose = validation::kStandardRestPose;
  return run;
}

LogRun LolaRecorder::watch(double seconds) {
  return validation::readLolaRows(hold(seconds), "LoLA");
}

LogSet LolaRecorder::describe(const std::string& name) const {
  LogSet set = makeSet(name, *model_, 1 / kCycle, "sent");
  set.source = "recorded over LoLA";
  for (const std::string& joint : validation::lolaJoints()) {
    set.joints.emplace_back();
    set.joints.back().name = joint;
  }
  return set;
}

}  // namespace nao::recorder
