#include "recorder/memory_rows.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "core/check.h"
#include "naoqi_api/call_error.h"
#include "validation/log/memory_columns.h"

namespace nao::recorder {
namespace {

using rpc::Value;
using validation::LogRun;

constexpr const char* kClock = "DCM/Time";             // [ms]
constexpr std::int64_t kWrap = std::int64_t{1} << 31;  // [ms] where it begins anew

bool knows(const RobotModel& model, const std::string& joint) {
  const auto ours = model.findJoint(joint);
  return ours && model.actuators[index(*ours)].name == joint;
}

}  // namespace

MemoryRows::MemoryRows(daemon::QiClient& client, const RobotModel& model, int patience)
    : client_(client), patience_(patience) {
  findSources(model);
  findSimulation(model);
}

void MemoryRows::findSources(const RobotModel& model) {
  const Value names = client_.call("ALMemory", "getDataList", {Value("Device/SubDeviceList/")});
  std::vector<Value> keys{Value(kClock)};
  for (const Value& name : *names.findItems()) {
    const auto column = validation::findMemoryColumn(*name.findText());
    if (!column) continue;
    const std::string joint = validation::findColumnJoint(column->column);
    if (!joint.empty() && !knows(model, joint)) continue;
    const bool known = std::any_of(sources_.begin(), sources_.end(), [&](const Source& other) {
      return other.column == column->column;  // of NAOqi's two names for one value
    });
    if (known) continue;
    sources_.push_back({column->column, column->scale});
    keys.push_back(name);
  }
  keys_ = Value::listOf("s", std::move(keys));
}

void MemoryRows::findSimulation(const RobotModel& model) {
  try {
    if (client_.call("UsarSim", "isPaused").findNumber().value_or(0) == 0) return;
    const double step = client_.call("UsarSim", "stepSize").findNumber().value_or(0);
    steps_ = std::max<std::int64_t>(1, std::llround(toSeconds(model.cycle) / step));
  } catch (const rpc::CallError&) {
    return;  // a real robot
  }
}

// Whether the robot's clock differs from when it was read last.
bool MemoryRows::goOn(const Value& clock) {
  const auto read = std::llround(clock.findNumber().value_or(0));
  const std::int64_t step = clock_ < 0 ? 0 : (read - clock_ + kWrap) % kWrap;
  if (step > kWrap / 2) {
    throw InputError(std::string(kClock) + ": expected the robot's clock to go on, it went back " +
                     std::to_string(kWrap - step) + " ms");
  }
  const bool first = clock_ < 0;
  clock_ = read;
  now_ += step;
  return first || step > 0;
}

std::vector<Value> MemoryRows::readNext() {
  for (int i = 0; i < patience_; ++i) {
    if (steps_ > 0) client_.call("UsarSim", "step", {steps_});
    const Value values = client_.call("ALMemory", "getListData", {keys_});
    if (goOn(values.findItems()->front())) return *values.findItems();
    if (steps_ == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  throw InputError(std::string(kClock) + ": expected the robot's clock to go on, it stands at " +
                   std::to_string(clock_) + " ms");
}

double MemoryRows::add(LogRun& run) {
  const std::vector<Value> values = readNext();
  if (run.t.empty()) begun_ = now_;
  run.t.push_back(1e-3 * static_cast<double>(now_ - begun_));
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const auto number = values[i + 1].findNumber();
    const double value = number ? sources_[i].scale * *number : validation::kUnknown;
    run.columns[sources_[i].column].push_back(value);
  }
  return run.t.back();
}

void MemoryRows::addUntil(LogRun& run, double t) {
  while (add(run) < t) {
  }
}

Value MemoryRows::await(const daemon::QiClient::Ticket& ticket) {
  while (!client_.isAnswered(ticket)) readNext();
  return client_.finish(ticket);
}

}  // namespace nao::recorder
