#include "naoqi_api/services/al_motion_switches.h"

#include <algorithm>

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

motion::SetMoveArms armsOf(const std::string& chain) {
  if (chain == "LArm") return {true, false};
  if (chain == "RArm") return {false, true};
  if (chain == "Arms") return {true, true};
  throw rpc::CallError("expected LArm, RArm or Arms, got " + chain);
}

// Null for a name that is accepted without effect.
bool* protectionOf(const std::string& name, motion::SetWalkProtection& protection) {
  if (name == "ENABLE_FOOT_CONTACT_PROTECTION") return &protection.foot_contact;
  if (name == "ENABLE_STIFFNESS_PROTECTION") return &protection.stiffness;
  return nullptr;
}

}  // namespace

void AlMotionSwitches::declare(rpc::Service& service) {
  declareArms(service);
  declareReflexes(service);
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
  // As NAOqi 1.12 called them.
  addMethod(service, "getWalkArmsEnable", this, &Self::getWalkArmsEnabled,
            "[left, right]: whether the arms swing in a walk.");
  addMethod(service, "setWalkArmsEnable", this, &Self::setMoveArmsEnabled,
            "Whether the arms swing in a walk.", left, right);
}

void AlMotionSwitches::declareReflexes(rpc::Service& service) {
  using Self = AlMotionSwitches;
  const Argument chain{"pChainName", "Name of the chain."};
  addMethod(service, "setCollisionProtectionEnabled", this, &Self::setCollisionProtectionEnabled,
            "Whether an arm keeps out of the body; true.", chain, kEnable)
      .at(227);
  addMethod(service, "getCollisionProtectionEnabled", this, &Self::getCollisionProtectionEnabled,
            "Whether an arm keeps out of the body.", Argument{"pChainName", "LArm, RArm or Arms."})
      .at(228);
  addMethod(service, "isCollision", this, &Self::isCollision,
            "How near an arm's command is to the body: none, near (20 mm) or collision (1 mm).",
            chain)
      .at(237);
  addMethod(service, "setFallManagerEnabled", this, &Self::setFallManagerEnabled,
            "Whether a fall ends in a protective pose and limp joints.", kEnable)
      .at(245);
  addMethod(service, "getFallManagerEnabled", this, &Self::getFallManagerEnabled,
            "Whether a fall ends in a protective pose and limp joints.")
      .at(246);
  addMethod(service, "setPushRecoveryEnabled", this, &Self::setPushRecoveryEnabled,
            "Whether a walk steps where it catches a push.", kEnable)
      .at(247);
  addMethod(service, "getPushRecoveryEnabled", this, &Self::getPushRecoveryEnabled,
            "Whether a walk steps where it catches a push.")
      .at(249);
  addMethod(service, "setSmartStiffnessEnabled", this, &Self::setSmartStiffnessEnabled,
            "Whether a robot that holds still is no stiffer than it needs.", kEnable)
      .at(250);
  addMethod(service, "getSmartStiffnessEnabled", this, &Self::getSmartStiffnessEnabled,
            "Whether a robot that holds still is no stiffer than it needs.")
      .at(251);
  declareSwitch(service, "DiagnosisEffect", true, 252, 253);
}

void AlMotionSwitches::declareIdle(rpc::Service& service) {
  using Self = AlMotionSwitches;
  const Argument chain{"pChain", "Name of a chain, Arms, Legs or Body."};
  const Argument enable{"pIsEnabled", kEnable.meaning};
  addMethod(
      service, "setMotionConfig", this, &Self::setMotionConfig,
      "ENABLE_FOOT_CONTACT_PROTECTION and ENABLE_STIFFNESS_PROTECTION of the walk; other names "
      "are accepted without effect.",
      Argument{"config", "[[name, value], ...]."})
      .at(267);
  addMethod(service, "_getMotionConfig", this, &Self::getMotionConfig,
            "What setMotionConfig was told of a name, as text: True or False of the walk's "
            "protections; nothing if it was not told.",
            Argument{"pName", "Such as ENABLE_STIFFNESS_PROTECTION."})
      .at(304);
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

void AlMotionSwitches::setPushRecoveryEnabled(bool enable) {
  auto changed = walk_feedback_;
  changed.feedback.steps = enable;
  link_.post(changed);
  walk_feedback_ = changed;
}

bool AlMotionSwitches::setCollisionProtectionEnabled(const std::string& chain, bool enable) {
  const motion::SetMoveArms arms = armsOf(chain);
  motion::SetCollisionProtection changed = collision_protection_;
  if (arms.left) changed.left = enable;
  if (arms.right) changed.right = enable;
  link_.post(changed);
  collision_protection_ = changed;
  return true;
}

bool AlMotionSwitches::getCollisionProtectionEnabled(const std::string& chain) {
  const motion::SetMoveArms arms = armsOf(chain);
  return (!arms.left || collision_protection_.left) && (!arms.right || collision_protection_.right);
}

std::string AlMotionSwitches::isCollision(const std::string& chain) {
  const motion::SetMoveArms arms = chain == "Body" ? motion::SetMoveArms{} : armsOf(chain);
  const auto state = link_.state();
  motion::Nearness worst = motion::Nearness::None;
  if (arms.left) worst = std::max(worst, state->arms[0]);
  if (arms.right) worst = std::max(worst, state->arms[1]);
  if (worst == motion::Nearness::Collision) return "collision";
  return worst == motion::Nearness::Near ? "near" : "none";
}

void AlMotionSwitches::setFallManagerEnabled(bool enable) {
  link_.post(motion::SetFallManager{enable});
  fall_manager_ = enable;
}

void AlMotionSwitches::setSmartStiffnessEnabled(bool enable) {
  link_.post(motion::SetSmartStiffness{enable});
  smart_stiffness_ = enable;
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
  const auto* items = config.findItems();
  if (items == nullptr) throw rpc::CallError("expected [[name, value], ...]");
  if (items->size() == 2 && items->front().isString()) {
    return setMotionConfig(rpc::Value::list({config}));
  }
  motion::SetWalkProtection changed = walk_protection_;
  for (const rpc::Value& pair : *items) {
    const auto* parts = pair.findItems();
    const bool fits = parts != nullptr && parts->size() == 2 && (*parts)[0].isString();
    if (!fits) throw rpc::CallError("expected [name, value], got " + pair.print());
    const std::string& name = *(*parts)[0].findText();
    bool* member = protectionOf(name, changed);
    if (member == nullptr) {
      keepConfig(name, (*parts)[1].print());
      continue;
    }
    const auto number = (*parts)[1].findNumber();
    if (!number) throw rpc::CallError("expected true or false, got " + pair.print());
    *member = *number != 0;
  }
  link_.post(changed);
  walk_protection_ = changed;
}

void AlMotionSwitches::keepConfig(const std::string& name, const std::string& value) {
  constexpr std::size_t kMost = 256;
  constexpr std::size_t kLongest = 1024;
  const bool has_room = other_config_.size() < kMost || other_config_.count(name) > 0;
  if (has_room && name.size() + value.size() <= kLongest) other_config_[name] = value;
}

std::string AlMotionSwitches::getMotionConfig(const std::string& name) {
  motion::SetWalkProtection now = walk_protection_;
  if (const bool* member = protectionOf(name, now)) return *member ? "True" : "False";
  const auto other = other_config_.find(name);
  return other == other_config_.end() ? "" : other->second;
}

}  // namespace nao::services
