#include "naoqi_api/services/ball_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nao::services {
namespace {

using rpc::Value;

constexpr int kRate = 10;  // [1/s] pictures; free
constexpr std::chrono::milliseconds kPeriod{50};
constexpr std::chrono::milliseconds kForget{500};  // free
constexpr double kGain = 0.6;                      // of the way to the ball, each picture; free
constexpr double kFraction = 0.25;                 // of top speed; free

Value asList(const Pose& pose) {
  std::vector<Value> list;
  for (int i = 0; i < 3; ++i) list.emplace_back(static_cast<float>(pose.translation()[i]));
  const Vec3 rpy = rpyOf(pose.linear());
  for (int i = 0; i < 3; ++i) list.emplace_back(static_cast<float>(rpy[i]));
  return Value::list(std::move(list));
}

}  // namespace

BallWatch::BallWatch(const ServiceContext& context, std::shared_ptr<camera::ImageFeed> images)
    : context_(context), images_(std::move(images)), kinematics_(context.link.sharedModel()) {}

BallWatch::~BallWatch() {
  if (subscription_ != 0) images_->unsubscribe(subscription_);
}

void BallWatch::want(const std::string& who, bool wanted) {
  if (wanted) {
    wanting_.insert(who);
  } else {
    wanting_.erase(who);
  }
  const bool on = !wanting_.empty();
  if (on && subscription_ == 0 && !context_.link.model().cameras.empty()) {
    use(0);
  } else if (!on && subscription_ != 0) {
    images_->unsubscribe(std::exchange(subscription_, 0));
    seen_ = false;
  }
  if (on && !looking_) look();
}

void BallWatch::use(int camera) {
  if (subscription_ != 0) images_->unsubscribe(subscription_);
  camera_ = camera;
  used_since_ = context_.link.now();
  subscription_ = images_->subscribe({camera, {320, 240}, camera::ColorSpace::kRGB, kRate});
}

// The other camera, of two, when this one has shown nothing for a while.
void BallWatch::changeCamera() {
  const bool is_fresh = context_.link.now() - used_since_ < kForget;
  if (context_.link.model().cameras.size() == 2 && !is_fresh && isOld()) use(1 - camera_);
}

bool BallWatch::isOld() const { return context_.link.now() - last_seen_ > kForget; }

bool BallWatch::takeNews() { return std::exchange(news_, false); }

void BallWatch::look() {
  looking_ = subscription_ != 0;
  if (!looking_) return;
  context_.later(kPeriod, [weak = weak_from_this()] {
    if (const auto self = weak.lock()) self->look();
  });
  changeCamera();
  const auto image = images_->latest(subscription_);
  if (!image || image->time == last_image_) return;
  last_image_ = image->time;
  const auto ball = findRedBall(*image);
  if (!ball) return;
  const CameraModel& camera = context_.link.model().cameras[static_cast<std::size_t>(camera_)];
  const double yaw = std::atan(2 * (0.5 - ball->x) * std::tan(camera.hfov / 2));
  const double pitch = std::atan(2 * (ball->y - 0.5) * std::tan(camera.vfov / 2));
  const double size = 2 * ball->diameter * std::tan(camera.hfov / 2);  // at a distance of 1
  const double ahead = diameter_ / size;
  kinematics_.update(context_.link.sensors()->angle);
  const Pose X_TC = kinematics_.calcPose({camera.body, camera.X_BC});  // x ahead, y left, z up
  p_TB_T_ = X_TC * Vec3(ahead, ahead * std::tan(yaw), -ahead * std::tan(pitch));
  seen_ = news_ = true;
  last_seen_ = image->time;
  tell(*ball, X_TC, image->time);
  if (following_) turnHead(yaw, pitch);
}

// [[seconds, microseconds], [yaw, pitch, width, height], camera in torso, camera in robot, camera]
void BallWatch::tell(const SeenBall& ball, const Pose& X_TC, SimTime time) const {
  const CameraModel& camera = context_.link.model().cameras[static_cast<std::size_t>(camera_)];
  const auto taken = context_.store().now() - (context_.link.now() - time);  // the picture
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(taken);
  const auto rest = std::chrono::duration_cast<std::chrono::microseconds>(taken - seconds);
  const auto size = static_cast<float>(ball.diameter * camera.hfov);
  const Pose X_RT = kinematics_.calcRobotFrame().inverse();
  context_.store().raiseEvent(
      "redBallDetected",
      Value::list({Value::list({static_cast<int>(seconds.count()), static_cast<int>(rest.count())}),
                   Value::list({static_cast<float>((0.5 - ball.x) * camera.hfov),
                                static_cast<float>((ball.y - 0.5) * camera.vfov), size, size}),
                   asList(X_TC), asList(X_RT * X_TC), camera_}));
}

void BallWatch::turnHead(double yaw, double pitch) const {
  const RobotModel& model = context_.link.model();
  const auto head_yaw = model.findJoint("HeadYaw");
  const auto head_pitch = model.findJoint("HeadPitch");
  if (!head_yaw || !head_pitch) return;
  const auto& angle = context_.link.sensors()->angle;
  try {
    context_.link.post(
        motion::SetAngles{{*head_yaw, *head_pitch},
                          {angle[*head_yaw] + kGain * yaw, angle[*head_pitch] + kGain * pitch},
                          {kFraction, kFraction}});
  } catch (const rpc::CallError&) {
    return;  // the robot is busy; the next picture comes soon
  }
}

}  // namespace nao::services
