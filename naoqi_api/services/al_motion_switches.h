#pragma once

#include <map>
#include <string>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The switches of ALMotion. Those of the arms' swing, of breath and idle postures, the collision
/// protection, push recovery, the fall manager, smart stiffness and the walk's protections act; the
/// others belong to reflexes that are not simulated: they are remembered and told again, so that
/// programs that set and check them run.
class AlMotionSwitches {
 public:
  explicit AlMotionSwitches(RobotLink& link) : link_(link) {}
  void declare(rpc::Service& service);

 private:
  void declareArms(rpc::Service& service);
  void declareReflexes(rpc::Service& service);
  void declareIdle(rpc::Service& service);

  /// Two methods, set<name>Enabled(bool) and get<name>Enabled(), on one remembered switch.
  void declareSwitch(rpc::Service& service, const std::string& name, bool at_first,
                     std::uint32_t set_uid, std::uint32_t get_uid);

  void setMoveArmsEnabled(bool left, bool right);
  bool getMoveArmsEnabled(const std::string& chain);
  rpc::Value getWalkArmsEnabled();

  bool setCollisionProtectionEnabled(const std::string& chain, bool enable);
  bool getCollisionProtectionEnabled(const std::string& chain);
  std::string isCollision(const std::string& chain);
  void setPushRecoveryEnabled(bool enable);
  bool getPushRecoveryEnabled() { return walk_feedback_.feedback.steps; }
  void setFallManagerEnabled(bool enable);
  bool getFallManagerEnabled() { return fall_manager_; }
  void setSmartStiffnessEnabled(bool enable);
  bool getSmartStiffnessEnabled() { return smart_stiffness_; }

  void setIdle(const std::string& chain, motion::SetIdle::Mode mode);
  void setBreathEnabled(const std::string& chain, bool enable);
  bool getBreathEnabled(const std::string& chain);
  void setIdlePostureEnabled(const std::string& chain, bool enable);
  bool getIdlePostureEnabled(const std::string& chain);
  void setBreathConfig(const rpc::Value& config);
  rpc::Value getBreathConfig();
  void setMotionConfig(const rpc::Value& config);
  void keepConfig(const std::string& name, const std::string& value);
  std::string getMotionConfig(const std::string& name);
  void setEnableNotifications(bool enable) { notifications_ = enable; }
  bool areNotificationsEnabled() { return notifications_; }

  RobotLink& link_;
  motion::SetMoveArms arms_;
  motion::SetCollisionProtection collision_protection_;
  motion::SetWalkProtection walk_protection_;
  motion::SetWalkFeedback walk_feedback_;
  bool fall_manager_ = true;
  bool smart_stiffness_ = true;
  std::map<std::string, bool> breath_;        // by chain; off at first
  std::map<std::string, bool> idle_posture_;  // by chain; off at first
  motion::SetBreath breath_config_;
  std::map<std::string, std::string> other_config_;  // that changes nothing
  bool notifications_ = true;
};

}  // namespace nao::services
