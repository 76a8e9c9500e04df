#include "app/robot_recorder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

#include "core/check.h"
#include "naoqi_api/call_error.h"
#include "validation/log/memory_columns.h"
#include "validation/log/standard_motions.h"

namespace nao::app {
namespace {

using rpc::Value;
using validation::LogRun;
using validation::LogSet;

constexpr double kGlide = 3;       // [s] to the first pose: slow enough for any joint's way
constexpr double kRest = 1;        // [s] before a motion: ten times what a joint takes to settle
constexpr double kBefore = 0.1;    // [s] of rows before a motion is asked for, to find its edge in
constexpr double kKeyStep = 0.02;  // [s] between keys of a motion: ALMotion's own cycle
constexpr const char* kClock = "DCM/Time";  // [ms], wraps at 2^31

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

Value namesOf(const RobotModel& model, const std::vector<std::size_t>& joints) {
  std::vector<Value> names;
  for (const std::size_t j : joints) names.emplace_back(model.actuators[j].name);
  return Value::listOf("s", std::move(names));
}

// From the row before any command changes on, that row at time 0.
void startAtCommand(LogRun& run) {
  constexpr double kChange = 2e-4;  // [rad] beyond what float32 does to a constant
  std::size_t first = run.t.size();
  for (const auto& [name, values] : run.columns) {
    if (name.rfind("cmd.", 0) != 0) continue;
    for (std::size_t i = 1; i < first; ++i) {
      if (std::abs(values[i] - values.front()) > kChange) first = i;
    }
  }
  if (first == run.t.size()) return;
  const double zero = run.t[first - 1];
  const auto cut = static_cast<std::ptrdiff_t>(first - 1);
  run.t.erase(run.t.begin(), run.t.begin() + cut);
  for (double& t : run.t) t -= zero;
  for (auto& [name, values] : run.columns) values.erase(values.begin(), values.begin() + cut);
}

LogRun makeRun(const std::string& motion, validation::Split split, int repeat,
               const RobotModel& model) {
  LogRun run;
  run.motion = motion;
  run.split = split;
  run.repeat = repeat;
  run.file = "run_" + motion + "_" + std::to_string(repeat) + ".csv";
  run.robot_id = model.name;
  return run;
}

}  // namespace

RobotRecorder::RobotRecorder(daemon::QiClient& client, std::shared_ptr<const RobotModel> model,
                             const std::vector<std::string>& moving)
    : client_(client), model_(std::move(model)), moving_(findMoving(*model_, moving)) {
  findSources();
}

void RobotRecorder::findSources() {
  const Value names = client_.call("ALMemory", "getDataList", {Value("Device/SubDeviceList/")});
  std::vector<Value> keys{Value(kClock)};
  for (const Value& name : *names.findItems()) {
    const auto column = validation::findMemoryColumn(*name.findText());
    if (!column) continue;
    const std::string joint = validation::findColumnJoint(column->column);
    if (!joint.empty()) {
      const auto ours = model_->findJoint(joint);
      if (!ours || model_->actuators[index(*ours)].name != joint) continue;
    }
    const bool known = std::any_of(sources_.begin(), sources_.end(), [&](const Source& other) {
      return other.column == column->column;  // of NAOqi's two names for one value
    });
    if (known) continue;
    sources_.push_back({*name.findText(), column->column, column->scale});
    keys.push_back(name);
  }
  keys_ = Value::listOf("s", std::move(keys));
}

void RobotRecorder::ask(const char* method, const std::vector<Value>& arguments) {
  try {
    client_.call("ALMotion", method, arguments);
  } catch (const rpc::CallError& error) {
    std::fprintf(stderr, "ALMotion.%s: %s\n", method, error.what());
  }
}

void RobotRecorder::prepare() {
  ask("setFallManagerEnabled", {false});
  ask("setCollisionProtectionEnabled", {"Arms", false});
  ask("setSmartStiffnessEnabled", {false});
  ask("setStiffnesses", {namesOf(*model_, moving_), 1.0F});
}

// One row, once the robot's clock has gone on; returns the time within the run.
double RobotRecorder::poll(LogRun& run) {
  for (;;) {
    const Value values = client_.call("ALMemory", "getListData", {keys_});
    const std::vector<Value>& items = *values.findItems();
    const double now = items.front().findNumber().value_or(0) / 1000;
    if (run.t.empty()) begun_ = now;
    const double t = now - begun_;
    if (!run.t.empty() && t <= run.t.back()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      continue;
    }
    run.t.push_back(t);
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const auto number = items[i + 1].findNumber();
      const double value = number ? sources_[i].scale * *number : validation::kUnknown;
      run.columns[sources_[i].column].push_back(value);
    }
    return t;
  }
}

void RobotRecorder::glideToRest() {
  const JointArray<double> rest = validation::standardRest(*model_);
  std::vector<Value> angles, times;
  for (const std::size_t j : moving_) {
    angles.emplace_back(static_cast<float>(rest[j]));
    times.emplace_back(static_cast<float>(kGlide));
  }
  client_.call("ALMotion", "angleInterpolation",
               {namesOf(*model_, moving_), Value::listOf("f", std::move(angles)),
                Value::listOf("f", std::move(times)), true});
}

daemon::QiClient::Ticket RobotRecorder::begin(const Angles& angles_at, double duration) {
  const auto keys = static_cast<int>(duration / kKeyStep);
  std::vector<std::vector<Value>> angles(moving_.size());
  std::vector<Value> times;
  for (int k = 1; k <= keys; ++k) {
    const JointArray<double> all = angles_at(k * kKeyStep);
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      angles[i].emplace_back(static_cast<float>(all[moving_[i]]));
    }
    times.emplace_back(static_cast<float>(k * kKeyStep));
  }
  std::vector<Value> angle_lists, time_lists;
  for (auto& list : angles) {
    angle_lists.push_back(Value::listOf("f", std::move(list)));
    time_lists.push_back(Value::listOf("f", times));
  }
  return client_.begin("ALMotion", "angleInterpolation",
                       {namesOf(*model_, moving_), Value::listOf("[f]", std::move(angle_lists)),
                        Value::listOf("[f]", std::move(time_lists)), true});
}

// Rows while a motion is under way. Before it begins there must be some, to find its edge in.
void RobotRecorder::record(LogRun& run, const daemon::QiClient::Ticket& ticket, double duration) {
  const double end = run.t.back() + duration;
  while (poll(run) < end) {
  }
  client_.finish(ticket);
  startAtCommand(run);
}

LogRun RobotRecorder::play(std::size_t motion, int repeat) {
  const auto& standard = validation::standardMotions()[motion];
  LogRun run = makeRun(standard.name, standard.split, repeat, *model_);
  run.start_pose = validation::kStandardRestPose;
  glideToRest();
  watch(kRest);
  while (poll(run) < kBefore) {
  }
  const double duration = validation::kStandardMotionTime;
  const auto angles = [&](double t) { return validation::standardAngles(*model_, motion, t); };
  record(run, begin(angles, duration), duration);
  return run;
}

LogRun RobotRecorder::play(const validation::FloorMotion& motion, int repeat) {
  LogRun run = makeRun(motion.name, motion.split, repeat, *model_);
  run.start_pose = "StandInit";
  client_.call("ALRobotPosture", "goToPosture", {"StandInit", 0.5F});
  watch(kRest);
  while (poll(run) < kBefore) {
  }
  const auto angles = [&](double t) { return validation::calcFloorAngles(*model_, motion, t); };
  if (!motion.walk) {
    record(run, begin(angles, motion.duration), motion.duration);
    return run;
  }
  const auto number = [](double x) { return Value(static_cast<float>(x)); };
  const std::vector<Value> target{number(motion.walk->x), number(motion.walk->y),
                                  number(motion.walk->theta)};
  record(run, client_.begin("ALMotion", "moveTo", target), motion.duration);
  return run;
}

LogRun RobotRecorder::watch(double seconds) {
  LogRun run;
  run.motion = "watch";
  run.file = "run_watch_0.csv";
  run.robot_id = model_->name;
  while (poll(run) < seconds) {
  }
  return run;
}

LogSet RobotRecorder::describe(const std::string& name) const {
  LogSet set;
  set.name = name;
  set.source = "recorded over NaoQi";
  set.robot = model_->name;
  set.version = model_->version;
  set.rate = 1 / toSeconds(model_->cycle);
  set.clock = {"robot", "executed", "measured"};
  for (const Actuator& actuator : model_->actuators) {
    validation::LogJoint joint;
    joint.name = actuator.name;
    set.joints.push_back(joint);
  }
  return set;
}

}  // namespace nao::app
