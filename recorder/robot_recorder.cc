#include "recorder/robot_recorder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/check.h"
#include "recorder/recorded_run.h"
#include "validation/log/standard_motions.h"

namespace nao::recorder {
namespace {

using rpc::Value;
using validation::LogRun;
using validation::LogSet;

constexpr double kBefore = 0.1;    // [s] of rows before a motion is asked for, to find its edge in
constexpr double kKeyStep = 0.02;  // [s] between keys of a motion: ALMotion's own cycle
// [s] that a motion holds its first pose: to take in some thousand keys keeps client and robot busy
// longer than a row lasts, and no row of the motion itself shall be missing.
constexpr double kHold = 0.4;

std::vector<std::size_t> findMoving(const RobotModel& model,
                                    const std::vector<std::string>& names) {
  std::vector<std::size_t> moving;
  for (const std::string& name : names) {
    const auto joint = model.findJoint(name);
    if (!joint) throw InputError("--joints " + name + ": " + model.name + " has no such joint");
    moving.push_back(index(*joint));
  }
  for (std::size_t j = 0; names.empty() && j < model.jointCount(); ++j) {
    if (!model.actuators[j].coordinates.empty()) moving.push_back(j);
  }
  return moving;
}

Value number(double x) { return static_cast<float>(x); }

Value textsOf(const std::vector<std::string>& texts) {
  return Value::listOf("s", std::vector<Value>(texts.begin(), texts.end()));
}

}  // namespace

RobotRecorder::RobotRecorder(daemon::QiClient& client, std::shared_ptr<const RobotModel> model,
                             const std::vector<std::string>& moving)
    : client_(client),
      model_(std::move(model)),
      moving_(findMoving(*model_, moving)),
      rows_(client, *model_) {}

void RobotRecorder::wakeUp() { rows_.await(client_.begin("ALMotion", "wakeUp")); }

std::vector<std::string> RobotRecorder::moving() const {
  std::vector<std::string> names;
  for (const std::size_t j : moving_) names.push_back(model_->actuators[j].name);
  return names;
}

RobotRecorder::Arguments RobotRecorder::glideToRest() const {
  const JointArray<double> rest = validation::standardRest(*model_);
  std::vector<Value> angles, times;
  for (const std::size_t j : moving_) {
    angles.push_back(number(rest[j]));
    times.push_back(number(kGlide));
  }
  return {textsOf(moving()), Value::listOf("f", std::move(angles)),
          Value::listOf("f", std::move(times)), true};
}

// Of a motion that begins after kHold.
RobotRecorder::Arguments RobotRecorder::interpolation(const Angles& angles_at,
                                                      double duration) const {
  const auto keys = static_cast<int>(std::lround((kHold + duration) / kKeyStep));
  std::vector<std::vector<Value>> angles(moving_.size());
  std::vector<Value> times;
  for (int k = 1; k <= keys; ++k) {
    const JointArray<double> all = angles_at(std::max(0.0, k * kKeyStep - kHold));
    for (std::size_t i = 0; i < moving_.size(); ++i) angles[i].push_back(number(all[moving_[i]]));
    times.push_back(number(k * kKeyStep));
  }
  std::vector<Value> angle_lists, time_lists;
  for (auto& list : angles) {
    angle_lists.push_back(Value::listOf("f", std::move(list)));
    time_lists.push_back(Value::listOf("f", times));
  }
  return {textsOf(moving()), Value::listOf("[f]", std::move(angle_lists)),
          Value::listOf("[f]", std::move(time_lists)), true};
}

// Rows while a call of ALMotion is under way. Before it begins there must be some, to find its edge
// in.
void RobotRecorder::record(LogRun& run, const char* method, const Arguments& arguments,
                           double duration) {
  LogRun rest;
  rows_.addUntil(rest, kRest);
  rows_.addUntil(run, kBefore);
  const daemon::QiClient::Ticket ticket = client_.begin("ALMotion", method, arguments);
  rows_.addUntil(run, run.t.back() + duration);
  rows_.await(ticket);
  startAtCommand(run);
}

LogRun RobotRecorder::play(std::size_t motion, int repeat) {
  const auto& standard = validation::standardMotions()[motion];
  const auto angles = [&](double t) { return validation::standardAngles(*model_, motion, t); };
  const double duration = validation::kStandardMotionTime;
  LogRun run = makeRun(standard.name, standard.split, repeat, *model_);
  run.start_pose = validation::kStandardRestPose;
  rows_.await(client_.begin("ALMotion", "angleInterpolation", glideToRest()));
  record(run, "angleInterpolation", interpolation(angles, duration), kHold + duration);
  return run;
}

LogRun RobotRecorder::play(const validation::FloorMotion& motion, int repeat) {
  LogRun run = makeRun(motion.name, motion.split, repeat, *model_);
  run.start_pose = "StandInit";
  rows_.await(client_.begin("ALRobotPosture", "goToPosture", {run.start_pose, 0.5F}));
  if (const auto& walk = motion.walk) {
    record(run, "moveTo", {number(walk->x), number(walk->y), number(walk->theta)}, motion.duration);
    return run;
  }
  const auto angles = [&](double t) { return validation::calcFloorAngles(*model_, motion, t); };
  record(run, "angleInterpolation", interpolation(angles, motion.duration),
         kHold + motion.duration);
  return run;
}

LogRun RobotRecorder::watch(double seconds) {
  LogRun run = makeRun("watch", validation::Split::Fit, 0, *model_);
  rows_.addUntil(run, seconds);
  return run;
}

LogSet RobotRecorder::describe(const std::string& name) const {
  LogSet set = makeSet(name, *model_, 1 / toSeconds(model_->cycle), "executed");
  set.source = "recorded over NaoQi";
  for (const Actuator& actuator : model_->actuators) {
    set.joints.emplace_back();
    set.joints.back().name = actuator.name;
  }
  return set;
}

}  // namespace nao::recorder
