#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/kinematics.h"
#include "naoqi_api/services/ball_watch.h"

namespace nao::services {

/// What follows a target as ALTracker was told: the head always, in its mode WholeBody with the
/// help of all joints, in BodyRotation and Move with the feet, with an effector an arm. A target is
/// a red ball that is seen, or a place that an event of ALMemory tells. Raises ALTracker's events.
/// Lives in a shared_ptr. I/O thread.
class TargetFollower : public std::enable_shared_from_this<TargetFollower> {
 public:
  TargetFollower(const ServiceContext& context, std::shared_ptr<BallWatch> watch)
      : context_(context), watch_(std::move(watch)), kinematics_(context.link.sharedModel()) {}

  std::map<std::string, rpc::Value> targets;  // that are known, and their parameters
  std::string mode = "Head";                  // WholeBody, BodyRotation, Move
  std::string effector = "None";              // LArm, RArm, Arms
  std::vector<float> relative = {0, 0, 0, 0.1F, 0.1F, 0.3F};  // where to stand: see setRelative
  double farthest = 3;                                        // [m] a target is seen
  bool searches = false;                                      // with the head, while it sees none

  const std::string& active() const { return active_; }
  /// @throws CallError if the target is not known.
  void track(const std::string& name);
  /// Follows the places that an event's values begin with: x, y, z in the robot's frame [m].
  void trackEvent(const std::string& event);
  void stop();
  bool sees() const;

  /// In NaoQi's frames: 0 torso, 1 world (odometry), 2 robot. Nothing if it is not seen.
  std::optional<Vec3> targetIn(int frame);

  /// By odometry: x, y [m], theta [rad].
  std::vector<float> robotPosition() const;

  void lookAt(Vec3 place, int frame, double fraction);
  void pointAt(const std::string& arm, Vec3 place, int frame, double fraction);

 private:
  void begin(const std::string& target);
  void hear(const rpc::Value& value);
  Vec3 targetInTorso();
  void look();
  void leadHead(const Vec3& p_R);
  void releaseBody();
  void tell(const char* event) const;
  void follow(const Vec3& p_T);
  void walkTo(const Vec3& p_R);
  void stand();
  void search();
  Vec3 inTorso(const Vec3& place, int frame);
  void post(motion::MotionAction action) const;

  ServiceContext context_;
  std::shared_ptr<BallWatch> watch_;
  motion::Kinematics kinematics_;
  std::string active_;
  std::shared_ptr<void> event_;   // keeps listening to one
  Vec3 p_told_R_ = Vec3::Zero();  // [m] what it told last
  std::optional<SimTime> told_at_;
  bool body_helps_ = false;  // whole-body control of the head is on
  bool looking_ = false;
  bool seen_ = false;
  bool reached_ = false;
  bool walking_ = false;
  int searched_ = 0;  // looks without a target
};

}  // namespace nao::services
