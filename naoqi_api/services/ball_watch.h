#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "camera/image_feed.h"
#include "motion/kinematics.h"
#include "naoqi_api/services/ball_finder.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// Looks for a red ball in the pictures of one of the robot's cameras while somebody wants it, in
/// those of the other when it finds none; raises redBallDetected and turns the head if told to.
/// Lives in a shared_ptr. I/O thread.
class BallWatch : public std::enable_shared_from_this<BallWatch> {
 public:
  BallWatch(const ServiceContext& context, std::shared_ptr<camera::ImageFeed> images);
  ~BallWatch();

  /// Whether `who` wants it.
  void want(const std::string& who, bool wanted);
  bool isWanted(const std::string& who) const { return wanting_.count(who) > 0; }

  /// Whether the head follows the ball.
  void follow(bool on) { following_ = on; }
  bool follows() const { return following_; }

  void setDiameter(double diameter) { diameter_ = diameter; }  // [m]

  /// Where the ball was seen last, in T [m]; zero before.
  const Vec3& position() const { return p_TB_T_; }
  /// Seen in one of the last pictures.
  bool sees() const { return seen_ && !isOld(); }
  /// Seen since this was asked last.
  bool takeNews();

 private:
  void look();
  void use(int camera);
  void changeCamera();
  void turnHead(double yaw, double pitch) const;
  void tell(const SeenBall& ball, const Pose& X_TC, SimTime time) const;
  bool isOld() const;

  ServiceContext context_;
  std::shared_ptr<camera::ImageFeed> images_;
  motion::Kinematics kinematics_;
  std::set<std::string> wanting_;
  std::uint64_t subscription_ = 0;
  int camera_ = 0;        // the one in the forehead, or the one below
  SimTime used_since_{};  // the camera
  bool looking_ = false;
  bool following_ = false;
  bool seen_ = false;
  bool news_ = false;
  double diameter_ = 0.06;  // [m] Aldebaran's red ball
  SimTime last_image_{};
  SimTime last_seen_{};
  Vec3 p_TB_T_ = Vec3::Zero();
};

}  // namespace nao::services
