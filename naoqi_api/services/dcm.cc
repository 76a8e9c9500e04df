#include "naoqi_api/services/dcm.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/dcm_commands.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/preferences.h"

namespace nao::services {
namespace {

using motion::DirectCommands;
using rpc::Argument;
using rpc::CallError;
using rpc::Pending;
using rpc::Value;
using std::chrono::milliseconds;

constexpr char kDevices[] = "Device/SubDeviceList/";
const std::string kRobotConfig = "RobotConfig/";
constexpr std::size_t kMostAliases = 1024;
constexpr std::size_t kDeepest = 512;  // commands an actuator

std::string withoutFolder(const std::string& name) {
  const std::string folder = kDevices;
  return name.rfind(folder, 0) == 0 ? name.substr(folder.size()) : name;
}

// "HeadYaw" of "HeadYaw/Position/Actuator/Value".
std::optional<std::string> deviceOf(const std::string& name, const std::string& end) {
  if (name.size() <= end.size() || name.compare(name.size() - end.size(), end.size(), end) != 0) {
    return std::nullopt;
  }
  return name.substr(0, name.size() - end.size());
}

class Dcm : public std::enable_shared_from_this<Dcm> {
 public:
  Dcm(ServiceContext context, std::shared_ptr<LedBoard> board)
      : context_(std::move(context)),
        board_(std::move(board)),
        preferences_(std::make_shared<Preferences>(
            context_, "preferences/" + context_.robot_name + ".dcm.jsonl")) {
    tellPreferences();
  }

  void declare(rpc::Service& service);

 private:
  // An actuator is a motor, lights, or a key of memory that a command only writes.
  struct Actuator {
    std::optional<Joint> joint;
    DirectCommands::Quantity quantity = DirectCommands::Quantity::Angle;
    std::vector<std::size_t> lights;
    std::string key;
  };
  // A command that waits for its time in here.
  struct Planned {
    std::int32_t time = 0;
    std::shared_ptr<bool> alive;
  };

  std::int32_t now() const {
    const auto ms =
        std::chrono::duration_cast<milliseconds>(context_.link.now().time_since_epoch());
    return static_cast<std::int32_t>(ms.count() & 0x7fffffff);
  }

  std::optional<Actuator> findActuator(const std::string& name) const {
    const std::string bare = withoutFolder(name);
    for (const auto& [end, quantity] :
         {std::pair("/Position/Actuator/Value", DirectCommands::Quantity::Angle),
          std::pair("/Hardness/Actuator/Value", DirectCommands::Quantity::Stiffness)}) {
      const auto device = deviceOf(bare, end);
      if (!device) continue;
      const auto joint = context_.link.model().findJoint(*device);
      if (joint) return Actuator{joint, quantity, {}, {}};
    }
    if (const auto device = deviceOf(bare, "/Actuator/Value")) {
      const auto light = std::find(board_->names().begin(), board_->names().end(), *device);
      if (light != board_->names().end()) {
        const auto number = static_cast<std::size_t>(light - board_->names().begin());
        return Actuator{{}, {}, {number}, {}};
      }
      const std::string key = kDevices + bare;
      if (context_.memory.read(key)) return Actuator{{}, {}, {}, key};
    }
    return std::nullopt;
  }

  Pending<void> send(const DcmCommands& commands);
  std::vector<Actuator> actuatorsOf(const std::string& name) const;
  void plan(const Actuator& actuator, const std::vector<DcmCommand>& track,
            DirectCommands::Merge merge);
  void write(const Actuator& actuator, float value, double fade);

  void tellPreferences() const;
  std::int32_t changePreference(const std::string& action, const std::string& target,
                                const std::string& key, const Value& value);
  Value createAlias(const Value& alias);
  Pending<void> setFast(const std::string& alias, std::int32_t time,
                        const std::vector<float>& values);

  ServiceContext context_;
  std::shared_ptr<LedBoard> board_;
  std::shared_ptr<Preferences> preferences_;  // of the boards
  std::map<std::string, std::vector<std::string>> aliases_;
  std::map<std::string, std::vector<Planned>> planned_;  // by light or key
};

std::vector<Dcm::Actuator> Dcm::actuatorsOf(const std::string& name) const {
  const auto alias = aliases_.find(name);
  const std::vector<std::string> names =
      alias == aliases_.end() ? std::vector<std::string>{name} : alias->second;
  std::vector<Actuator> actuators;
  for (const std::string& device : names) {
    if (const auto actuator = findActuator(device)) {
      actuators.push_back(*actuator);
    } else if (alias == aliases_.end()) {
      throw CallError("unknown actuator or alias: " + device);
    } else {
      actuators.emplace_back();  // of an alias, an unknown name takes its place
    }
  }
  return actuators;
}

Pending<void> Dcm::send(const DcmCommands& commands) {
  const auto actuators = actuatorsOf(commands.name);
  if (commands.tracks.size() != 1 && commands.tracks.size() != actuators.size()) {
    throw CallError("expected commands for " + std::to_string(actuators.size()) +
                    " actuators, got them for " + std::to_string(commands.tracks.size()));
  }
  DirectCommands request;
  request.merge = commands.merge;
  for (std::size_t i = 0; i < actuators.size(); ++i) {
    const auto& track = commands.tracks.size() == 1 ? commands.tracks[0] : commands.tracks[i];
    if (track.size() > kDeepest) throw CallError("more than 512 commands for one actuator");
    if (!actuators[i].joint) {
      plan(actuators[i], track, commands.merge);
      continue;
    }
    DirectCommands::Track points{*actuators[i].joint, actuators[i].quantity, {}};
    const bool is_stiffness = points.quantity == DirectCommands::Quantity::Stiffness;
    for (const DcmCommand& command : track) {
      const double value = is_stiffness ? std::clamp(command.value, -1.0F, 1.0F) : command.value;
      points.points.push_back({SimTime(milliseconds(command.time)), value});
    }
    request.tracks.push_back(std::move(points));
  }
  if (!request.tracks.empty()) return context_.link.postAndWait(std::move(request));
  Pending<void> done;
  done.resolve();
  return done;
}

// Lights and keys: one timer per command.
void Dcm::plan(const Actuator& actuator, const std::vector<DcmCommand>& track,
               DirectCommands::Merge merge) {
  if (track.empty() || (actuator.lights.empty() && actuator.key.empty())) return;
  const std::string name =
      actuator.key.empty() ? board_->names().at(actuator.lights.front()) : actuator.key;
  auto& waiting = planned_[name];
  const auto over = [&](const Planned& planned) {
    const bool dropped =
        merge == DirectCommands::Merge::ClearAll ||
        (merge == DirectCommands::Merge::ClearAfter && planned.time >= track.front().time) ||
        (merge == DirectCommands::Merge::ClearBefore && planned.time <= track.back().time);
    if (dropped) *planned.alive = false;
    return dropped || planned.time < now();
  };
  waiting.erase(std::remove_if(waiting.begin(), waiting.end(), over), waiting.end());
  if (waiting.size() + track.size() > kDeepest) {
    throw CallError("more than 512 commands wait for one actuator");
  }
  std::int32_t begin = now();
  for (const DcmCommand& command : track) {
    const auto alive = std::make_shared<bool>(true);
    waiting.push_back({command.time, alive});
    const double fade = std::max(0.0, 1.0 * command.time - begin) / 1000.0;
    const double start = actuator.lights.empty() ? command.time : begin;  // keys do not fade
    const double delay = std::max(0.0, start - now()) / 1000.0;
    context_.later(fromSeconds(delay),
                   [weak = weak_from_this(), alive, actuator, value = command.value, fade] {
                     const auto self = weak.lock();
                     if (self && *alive) self->write(actuator, value, fade);
                   });
    begin = std::max(begin, command.time);
  }
}

void Dcm::write(const Actuator& actuator, float value, double fade) {
  if (!actuator.lights.empty()) {
    board_->fade(actuator.lights, value, fade);
  } else {
    context_.store().insert(actuator.key, value);
  }
}

// What was kept when the daemon last ended.
void Dcm::tellPreferences() const {
  for (const auto& [target, values] : preferences_->domains()) {
    for (const auto& [key, value] : values) {
      context_.store().insert(kRobotConfig + target + "/" + key, value);
    }
  }
}

std::int32_t Dcm::changePreference(const std::string& action, const std::string& target,
                                   const std::string& key, const Value& value) {
  const std::string name = kRobotConfig + target + "/" + key;
  if (action == "Add") {
    context_.store().demandRoom(name, value);
    preferences_->set(target, key, value);
    context_.store().insert(name, value);
  } else if (action == "Remove") {
    preferences_->remove(target, key);
    context_.store().remove(name);
  } else if (action == "Save") {
    preferences_->save();
  } else {
    throw CallError("unknown action: " + action + ", expected Add, Remove or Save");
  }
  return 0;
}

Value Dcm::createAlias(const Value& alias) {
  const auto* items = alias.findItems();
  if (!items || items->size() != 2) throw CallError("expected [alias, [actuator, ...]]");
  const std::string name = (*items)[0].to<std::string>();
  auto devices = (*items)[1].to<std::vector<std::string>>();
  if (aliases_.size() >= kMostAliases && aliases_.count(name) == 0) {
    throw CallError("too many aliases");
  }
  for (std::string& device : devices) {
    if (!findActuator(device)) device.clear();
  }
  aliases_[name] = devices;
  return Value::list({name, rpc::toValue(devices)});
}

Pending<void> Dcm::setFast(const std::string& alias, std::int32_t time,
                           const std::vector<float>& values) {
  DcmCommands commands{alias, DirectCommands::Merge::ClearAll, {}};
  for (const float value : values) commands.tracks.push_back({{value, time}});
  return send(commands);
}

void Dcm::declare(rpc::Service& service) {
  addFunction(
      service, "getTime",
      [this](std::int32_t offset) {
        return static_cast<std::int32_t>(std::int64_t{now()} + offset);  // wraps, as the clock
      },
      "The time of the clock that commands are given in [ms].",
      Argument{"offset", "[ms] is added."});
  addFunction(
      service, "getPrefix",
      [] {
        return Value::list({"Device/SubDeviceList/", "Device/DeviceList/"});
      },
      "What may be left out before the name of an actuator.");
  addFunction(
      service, "set", [this](const Value& commands) { return send(readDcmSet(commands)); },
      "Timed commands to an actuator, or the same to all of an alias.",
      Argument{"commands", "[name, ClearAll|Merge|ClearAfter|ClearBefore, [[value, time], ...]]"});
  addFunction(
      service, "createAlias", [this](const Value& alias) { return createAlias(alias); },
      "Names a list of actuators; returns it with \"\" in place of unknown ones.",
      Argument{"alias", "[alias, [actuator, ...]]"});
  addFunction(
      service, "setAlias",
      [this](const Value& commands) { return send(readDcmSetAlias(commands)); },
      "Timed commands to each actuator of an alias.",
      Argument{"commands",
               "[alias, update type, \"time-separate\", 0, [time, ...], [[value, ...], ...]] or "
               "[alias, update type, \"time-mixed\", [[[value, time], ...], ...]]"});
  addFunction(
      service, "setAlias",
      [this](const std::string& alias, std::int32_t time, const std::vector<float>& values) {
        return setFast(alias, time, values);
      },
      "One value for each actuator of an alias; what waited for them is forgotten.",
      Argument{"alias", "Its name."}, Argument{"time", "[ms]"}, Argument{"values", "One each."});
  addFunction(
      service, "calibration", [](const Value&) {}, "Has no effect: there is nothing to calibrate.",
      Argument{"calibration", "Ignored."})
      .answering(rpc::Answer::Simplified);
  addFunction(
      service, "special", [](const std::string&) {}, "Has no effect: there are no boards.",
      Argument{"command", "Ignored."})
      .answering(rpc::Answer::Simplified);
  addFunction(
      service, "preferences",
      [this](const std::string& action, const std::string& target, const std::string& key,
             const Value& value) { return changePreference(action, target, key, value); },
      "Changes what the boards keep about the robot, the keys RobotConfig/... of ALMemory; 0. It "
      "outlives the daemon if there is a --data-dir.",
      Argument{"action", "Add, Remove, or Save: writes it now."},
      Argument{"target", "Such as Head or Body."}, Argument{"key", "What follows in the key."},
      Argument{"value", "Its value."})
      .answering(rpc::Answer::Simplified);
}

}  // namespace

std::shared_ptr<rpc::Service> makeDcm(const ServiceContext& context,
                                      const std::shared_ptr<LedBoard>& board) {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("DCM", "Timed commands straight to the actuators."));
  const auto dcm = std::make_shared<Dcm>(context, board);
  dcm->declare(*service);
  service->owning(dcm);
  return service;
}

}  // namespace nao::services
