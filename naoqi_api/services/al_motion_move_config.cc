#include "naoqi_api/services/al_motion_move_config.h"

#include <algorithm>

#include "naoqi_api/call_error.h"
#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"

namespace nao::services {
namespace {

struct Entry {
  const char* name;
  double motion::GaitConfig::*member;
  double min;
  double max;
};

// Names and ranges: ALMotion's documentation of walk control, 1.14 and 2.1.
constexpr Entry kEntries[] = {
    {"MaxStepX", &motion::GaitConfig::max_step_x, 0.001, 0.080},
    {"MinStepX", &motion::GaitConfig::min_step_x, -0.040, -0.001},
    {"MaxStepY", &motion::GaitConfig::max_step_y, 0.101, 0.160},
    {"MaxStepTheta", &motion::GaitConfig::max_step_theta, 0.001, 0.524},
    {"MaxStepFrequency", &motion::GaitConfig::max_step_frequency, 0, 1},
    {"StepHeight", &motion::GaitConfig::step_height, 0.005, 0.040},
    {"TorsoWx", &motion::GaitConfig::torso_wx, -0.122, 0.122},
    {"TorsoWy", &motion::GaitConfig::torso_wy, -0.122, 0.122},
};

const Entry& findEntry(std::string name) {
  for (const std::string side : {"Left", "Right"}) {
    if (name.rfind(side, 0) == 0) name.erase(0, side.size());
  }
  if (name == "Frequency") name = "MaxStepFrequency";
  for (const Entry& entry : kEntries) {
    if (name == entry.name) return entry;
  }
  throw rpc::CallError("unknown name in the move configuration: " + name);
}

}  // namespace

motion::GaitConfig readMoveConfig(const rpc::Value& pairs, motion::GaitConfig config) {
  const auto* items = pairs.findItems();
  if (items == nullptr) throw rpc::CallError("expected a move configuration [[name, value], ...]");
  if (items->size() == 2 && items->front().isString()) {
    return readMoveConfig(rpc::Value::list({pairs}), config);
  }
  for (const rpc::Value& pair : *items) {
    const auto* parts = pair.findItems();
    const bool fits = parts != nullptr && parts->size() == 2 && (*parts)[0].isString();
    const auto number = fits ? (*parts)[1].findNumber() : std::nullopt;
    if (!number) throw rpc::CallError("expected [name, value], got " + pair.print());
    const Entry& entry = findEntry(*(*parts)[0].findText());
    config.*entry.member = std::clamp(finite(*number), entry.min, entry.max);
  }
  return config;
}

rpc::Value listMoveConfig(const std::string& which) {
  if (which != "Max" && which != "Min" && which != "Default") {
    throw rpc::CallError("expected Max, Min or Default, got " + which);
  }
  const motion::GaitConfig defaults;
  std::vector<rpc::Value> pairs;
  for (const Entry& entry : kEntries) {
    const double value = which == "Max"   ? entry.max
                         : which == "Min" ? entry.min
                                          : defaults.*entry.member;
    pairs.push_back(rpc::Value::list({entry.name, static_cast<float>(value)}));
  }
  return rpc::Value::list(std::move(pairs));
}

}  // namespace nao::services
