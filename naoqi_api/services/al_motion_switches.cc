#include "naoqi_api/services/al_motion_switches.h"

#include "motion/idle.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;

const Argument kEnable{"pEnable", "True: on, false: off."};

// A switch of one chain of the robot, or of Arms, Legs, Body, which are all of theirs.
class ChainSwitch {
 public:
  explicit ChainSwitch(const RobotModel& model) : model_(model) {}

  std::vector<std::string> chains(const std::string& name) const {
    const auto all = model_.groups.find("Chains");
    if (all == model_.groups.end()) throw rpc::CallError("unknown chain name: " + name);
    std::vector<std::string> found;
    for (const std::string& chain : all->second) {
      const bool is_one = name == chain || name == "Body" || name == "All" ||
                          (name == "Arms" && chain.find("Arm") != std::string::npos) ||
                          (name == "Legs" && chain.find("Leg") != std::string::npos);
      if (is_one) found.push_back(chain);
    }
    if (found.empty()) throw rpc::CallError("unknown chain name: " + name);
    return found;
  }

  void set(std::map<std::string, bool>& switches, const std::string& name, bool enable) const {
    for (const std::string& chain : chains(name)) switches[chain] = enable;
  }

  bool get(const std::map<std::string, bool>& switches, const std::string& name,
           bool at_first) const {
    for (const std::string& chain : chains(name)) {
      const auto found = switches.find(chain);
      if (!(found == switches.end() ? at_first : found->second)) return false;
    }
    return true;
  }

 private:
  const RobotModel& model_;
};

}  // namespace

void AlMotionSwitches::declare(rpc::Service& service) {
  declareArms(service);
  declareReflexes(service);
  declareDistances(service);
  declareIdle(service);
}

void AlMotionSwitches::declareArms(rpc::Service& service) {
  using Self = AlMotionSwitches;
  const Argument left{"leftArmEnabled", "Whether the left arm swings in a walk."};
  const Argument right{"rightArmEnabled", "Whether the right arm swings in a walk."};
  addMethod(service, "getWalkArmsEnabled", this, &Self::getWalkArmsEnabled,
            "[left, right]: whether the arms swing in a walk.")
      .at(185);
  addMethod(service, "setWalkArmsEnabled", this, &Self::setMoveArmsEnabled,
            "Whether the arms swing in a walk.", left, right)
      .at(186);
  addMethod(service, "getMoveArmsEnabled", this, &Self::getMoveArmsEnabled,
            "Whether an arm swings in a walk.", Argument{"chainName", "LArm, RArm or Arms."})
      .at(187);
  addMethod(service, "setMoveArmsEnabled", this, &Self::setMoveArmsEnabled,
            "Whether the arms swing in a walk.", left, right)
      .at(188);
}

void AlMotionSwitches::declareReflexes(rpc::Service& service) {
  using Self = AlMotionSwitches;
  const Argument chain{"pChainName", "Name of the chain."};
  addMethod(service, "setCollisionProtectionEnabled", this, &Self::setCollisionProtectionEnabled,
            "Remembers whether a chain is to avoid the body.", chain, kEnable)
      .at(227);
  addMethod(service, "getCollisionProtectionEnabled", this, &Self::getCollisionProtectionEnabled,
            "Whether a chain is to avoid the body.", chain)
      .at(228);
  addMethod(service, "setExternalCollisionProtectionEnabled", this,
            &Self::setExternalCollisionProtectionEnabled,
            "Remembers whether a chain or the walk is to avoid obstacles.",
            Argument{"pName", "A chain, Arms, Move or All."}, kEnable)
      .at(229);
  addMethod(service, "getExternalCollisionProtectionEnabled", this,
            &Self::getExternalCollisionProtectionEnabled,
            "Whether a chain or the walk is to avoid obstacles.",
            Argument{"pName", "A chain, Arms, Move or All."})
      .at(232);
  addMethod(service, "isCollision", this, &Self::isCollision,
            "Whether a chain touches the body; always none, since nobody looks.", chain)
      .at(237);
  declareSwitch(service, "FallManager", true, 245, 246);
  declareSwitch(service, "PushRecovery", true, 247, 249);
  declareSwitch(service, "SmartStiffness", true, 250, 251);
  declareSwitch(service, "DiagnosisEffect", true, 252, 253);
}

void AlMotionSwitches::declareDistances(rpc::Service& service) {
  using Self = AlMotionSwitches;
  const Argument distance{"securityDistance", "Distance [m]."};
  addMethod(service, "setOrthogonalSecurityDistance", this, &Self::setOrthogonalSecurityDistance,
            "Remembers the distance to keep from an obstacle ahead.", distance)
      .at(233);
  addMethod(service, "getOrthogonalSecurityDistance", this, &Self::getOrthogonalSecurityDistance,
            "The distance to keep from an obstacle ahead [m].")
      .at(234);
  addMethod(service, "setTangentialSecurityDistance", this, &Self::setTangentialSecurityDistance,
            "Remembers the distance to keep from an obstacle beside.", distance)
      .at(235);
  addMethod(service, "getTangentialSecurityDistance", this, &Self::getTangentialSecurityDistance,
            "The distance to keep from an obstacle beside [m].")
      .at(236);
}

void AlMotionSwitches::declareIdle(rpc::Service& service) {
  using Self = AlMotionSwitches;
  const Argument chain{"pChain", "Name of a chain, Arms, Legs or Body."};
  const Argument enable{"pIsEnabled", kEnable.meaning};
  addMethod(service, "setMotionConfig", this, &Self::setMotionConfig,
            "Accepts the configuration of protections that are not simulated.",
            Argument{"config", "[[name, value], ...]."})
      .at(267);
  addMethod(service, "setBreathEnabled", this, &Self::setBreathEnabled,
            "Whether a chain breathes while nobody commands it and the robot stands.", chain,
            enable)
      .at(277);
  addMethod(service, "getBreathEnabled", this, &Self::getBreathEnabled,
            "Whether a chain breathes while nobody commands it.", chain)
      .at(278);
  addMethod(service, "setBreathConfig", this, &Self::setBreathConfig,
            "How to breathe; the amplitude is held to what the frequency allows.",
            Argument{"pConfig", "[['Bpm', 5 to 30], ['Amplitude', 0 to 1]], either or both."})
      .at(279);
  addMethod(service, "getBreathConfig", this, &Self::getBreathConfig,
            "[['Bpm', value], ['Amplitude', value]].")
      .at(280);
  addMethod(service, "setIdlePostureEnabled", this, &Self::setIdlePostureEnabled,
            "Whether a chain returns to the pose it has now while nobody commands it.", chain,
            enable)
      .at(281);
  addMethod(service, "getIdlePostureEnabled", this, &Self::getIdlePostureEnabled,
            "Whether a chain returns to a pose while nobody commands it.", chain)
      .at(282);
  addMethod(service, "setEnableNotifications", this, &Self::setEnableNotifications,
            "Remembers whether to notify.", Argument{"enable", kEnable.meaning})
      .at(291);
  addMethod(service, "areNotificationsEnabled", this, &Self::areNotificationsEnabled,
            "Whether to notify.")
      .at(292);
}

void AlMotionSwitches::declareSwitch(rpc::Service& service, const std::string& name, bool at_first,
                                     std::uint32_t set_uid, std::uint32_t get_uid) {
  const auto value = std::make_shared<bool>(at_first);
  service
      .method("set" + name + "Enabled",
              std::function<void(bool)>([value](bool on) { *value = on; }),
              "Remembers whether " + name + " is to be on.", kEnable)
      .at(set_uid);
  service
      .method("get" + name + "Enabled", std::function<bool()>([value] { return *value; }),
              "Whether " + name + " is to be on.")
      .at(get_uid);
}

void AlMotionSwitches::setMoveArmsEnabled(bool left, bool right) {
  link_.post(motion::SetMoveArms{left, right});
  arms_ = {left, right};
}

bool AlMotionSwitches::getMoveArmsEnabled(const std::string& chain) {
  if (chain == "LArm") return arms_.left;
  if (chain == "RArm") return arms_.right;
  if (chain == "Arms") return arms_.left && arms_.right;
  throw rpc::CallError("expected LArm, RArm or Arms, got " + chain);
}

rpc::Value AlMotionSwitches::getWalkArmsEnabled() {
  return rpc::Value::list({arms_.left, arms_.right});
}

bool AlMotionSwitches::setCollisionProtectionEnabled(const std::string& chain, bool enable) {
  ChainSwitch(link_.model()).set(collision_protection_, chain, enable);
  return true;
}

bool AlMotionSwitches::getCollisionProtectionEnabled(const std::string& chain) {
  return ChainSwitch(link_.model()).get(collision_protection_, chain, true);
}

std::string AlMotionSwitches::isCollision(const std::string& chain) {
  ChainSwitch(link_.model()).chains(chain);
  return "none";
}

void AlMotionSwitches::setExternalCollisionProtectionEnabled(const std::string& name, bool enable) {
  if (name == "Move" || name == "All") external_collision_protection_["Move"] = enable;
  if (name != "Move") ChainSwitch(link_.model()).set(external_collision_protection_, name, enable);
}

bool AlMotionSwitches::getExternalCollisionProtectionEnabled(const std::string& name) {
  const auto move = external_collision_protection_.find("Move");
  const bool move_on = move == external_collision_protection_.end() || move->second;
  if (name == "Move" || (name == "All" && !move_on)) return move_on;
  return ChainSwitch(link_.model()).get(external_collision_protection_, name, true);
}

void AlMotionSwitches::setIdle(const std::string& name, motion::SetIdle::Mode mode) {
  motion::SetIdle request;
  request.mode = mode;
  for (const std::string& chain : ChainSwitch(link_.model()).chains(name)) {
    for (const std::string& member : link_.model().groups.at(chain)) {
      const auto joint = link_.model().findJoint(member);
      if (joint) request.joints.push_back(*joint);
    }
  }
  link_.post(request);
}

// A chain has one idle mode: who enables one of the two ends the other.
void AlMotionSwitches::setBreathEnabled(const std::string& chain, bool enable) {
  using Mode = motion::SetIdle::Mode;
  setIdle(chain, enable ? Mode::Breath : Mode::Nothing);
  ChainSwitch(link_.model()).set(breath_, chain, enable);
  ChainSwitch(link_.model()).set(idle_posture_, chain, false);
}

bool AlMotionSwitches::getBreathEnabled(const std::string& chain) {
  return ChainSwitch(link_.model()).get(breath_, chain, false);
}

void AlMotionSwitches::setIdlePostureEnabled(const std::string& chain, bool enable) {
  using Mode = motion::SetIdle::Mode;
  setIdle(chain, enable ? Mode::Posture : Mode::Nothing);
  ChainSwitch(link_.model()).set(idle_posture_, chain, enable);
  ChainSwitch(link_.model()).set(breath_, chain, false);
}

bool AlMotionSwitches::getIdlePostureEnabled(const std::string& chain) {
  return ChainSwitch(link_.model()).get(idle_posture_, chain, false);
}

void AlMotionSwitches::setBreathConfig(const rpc::Value& config) {
  const char* const kExpected = "expected [['Bpm', 5 to 30], ['Amplitude', 0 to 1]]";
  motion::SetBreath wanted = breath_config_;
  const auto* pairs = config.findItems();
  if (pairs == nullptr) throw rpc::CallError(kExpected);
  for (const rpc::Value& pair : *pairs) {
    const auto* items = pair.findItems();
    if (items == nullptr || items->size() != 2) throw rpc::CallError(kExpected);
    const std::string name = (*items)[0].to<std::string>();
    const double value = (*items)[1].to<double>();
    if (name == "Bpm" && value >= 5 && value <= 30) {
      wanted.beats_per_minute = value;
    } else if (name == "Amplitude" && value >= 0 && value <= 1) {
      wanted.amplitude = value;
    } else {
      throw rpc::CallError(kExpected);
    }
  }
  wanted = motion::clipToStable(wanted);
  link_.post(wanted);
  breath_config_ = wanted;
}

rpc::Value AlMotionSwitches::getBreathConfig() {
  return rpc::Value::list({rpc::Value::list({"Bpm", breath_config_.beats_per_minute}),
                           rpc::Value::list({"Amplitude", breath_config_.amplitude})});
}

void AlMotionSwitches::setMotionConfig(const rpc::Value& config) {
  if (config.findItems() == nullptr) throw rpc::CallError("expected [[name, value], ...]");
}

}  // namespace nao::services
