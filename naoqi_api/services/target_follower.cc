#include "naoqi_api/services/target_follower.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nao::services {
namespace {

constexpr std::chrono::milliseconds kPeriod{100};

// Free: quick, and slow enough that a walk stands soon.
constexpr double kGain = 0.6;       // [1/s] of the way that is left
constexpr double kTopSpeed = 0.06;  // [m/s]
constexpr double kTopTurn = 0.4;    // [rad/s]

constexpr double kPointFraction = 0.3;      // of the arm's top speed
constexpr double kLookFraction = 0.25;      // of the head's
constexpr std::chrono::seconds kForget{1};  // what an event told
constexpr int kSearchLooks = 12;            // looks at one place while nothing is seen

double limited(double speed, double top) { return std::clamp(speed, -top, top); }

}  // namespace

void TargetFollower::track(const std::string& name) {
  if (targets.count(name) == 0) throw rpc::CallError("unknown target: " + name);
  event_.reset();
  begin(name);
}

void TargetFollower::trackEvent(const std::string& event) {
  if (event.empty()) throw rpc::CallError("expected the name of an event");
  told_at_.reset();
  event_ = context_.store().listen(
      event, [weak = weak_from_this()](const auto& /*key*/, const rpc::Value& value) {
        if (const auto self = weak.lock()) self->hear(value);
      });
  begin(event);
}

void TargetFollower::begin(const std::string& target) {
  const bool is_change = active_ != target;
  active_ = target;
  seen_ = reached_ = false;
  const bool is_ball = !event_ && target == "RedBall";
  watch_->want("ALTracker", is_ball);
  watch_->follow(is_ball && mode != "WholeBody");
  if (is_change) tell("ActiveTargetChanged");
  if (!looking_) look();
}

// What is no place tells nothing.
void TargetFollower::hear(const rpc::Value& value) {
  const auto* items = value.findItems();
  if (!items || items->size() < 3) return;
  Vec3 place;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = (*items)[i].findNumber();
    if (!number || !std::isfinite(*number)) return;
    place[static_cast<Eigen::Index>(i)] = *number;
  }
  p_told_R_ = place;
  told_at_ = context_.link.now();
}

void TargetFollower::stop() {
  if (active_.empty()) return;
  stand();
  releaseBody();
  active_.clear();
  event_.reset();
  watch_->want("ALTracker", false);
  watch_->follow(false);
  tell("ActiveTargetChanged");
}

bool TargetFollower::sees() const {
  if (event_) return told_at_ && context_.link.now() - *told_at_ <= kForget;
  return active_ == "RedBall" && watch_->sees() && watch_->position().norm() <= farthest;
}

Vec3 TargetFollower::targetInTorso() { return event_ ? inTorso(p_told_R_, 2) : watch_->position(); }

void TargetFollower::tell(const char* event) const {
  context_.store().raiseEvent(std::string("ALTracker/") + event, active_);
}

void TargetFollower::look() {
  looking_ = !active_.empty();
  if (!looking_) return;
  context_.later(kPeriod, [weak = weak_from_this()] {
    if (const auto self = weak.lock()) self->look();
  });
  const bool sees_now = sees();
  if (sees_now != seen_) tell(sees_now ? "TargetDetected" : "TargetLost");
  seen_ = sees_now;
  if (sees_now) {
    searched_ = 0;
    follow(targetInTorso());
  } else {
    stand();
    if (searches) search();
  }
}

void TargetFollower::follow(const Vec3& p_T) {
  if (effector != "None") pointAt(effector, p_T, 0, kPointFraction);
  kinematics_.update(context_.link.sensors()->angle);
  const Vec3 p_R = kinematics_.calcRobotFrame().inverse() * p_T;
  const double bearing = std::atan2(p_R.y(), p_R.x());
  if (mode != "WholeBody") releaseBody();
  if (mode == "WholeBody") {
    leadHead(p_R);
  } else if (event_) {
    lookAt(p_T, 0, kLookFraction);
  }
  if (mode == "Move") {
    walkTo(p_R);
  } else if (mode == "BodyRotation") {
    const bool is_ahead = std::abs(bearing) < relative[5];
    if (is_ahead) return stand();
    walking_ = true;
    post(motion::Move{{0, 0, limited(kGain * bearing, kTopTurn)}, {}});
  }
}

// All joints help the head to look there, and keep the robot over its feet.
void TargetFollower::leadHead(const Vec3& p_R) {
  const auto neck = motion::findEffector(context_.link.model(), "HeadYaw");
  if (!neck || context_.link.model().feet.empty()) return;
  if (!std::exchange(body_helps_, true)) {
    watch_->follow(false);
    post(motion::WbEnable{true});
    post(motion::WbFootState{motion::FootState::Fixed, motion::Feet::Both});
    post(motion::WbBalance{true, motion::Feet::Both});
    post(motion::WbEffector{"Head", true});
  }
  const Vec3 p_NR =
      p_R - kinematics_.calcRobotFrame().inverse() * kinematics_.calcPose(*neck).translation();
  const double pitch = std::atan2(-p_NR.z(), std::hypot(p_NR.x(), p_NR.y()));
  post(motion::WbEffectorTarget{"Head", Vec3(0, pitch, std::atan2(p_NR.y(), p_NR.x()))});
}

void TargetFollower::releaseBody() {
  if (!std::exchange(body_helps_, false)) return;
  post(motion::WbEffector{"Head", false});
  post(motion::WbEnable{false});
  watch_->follow(!event_ && active_ == "RedBall");
}

// To where the target is `relative` away: [x, y, turn] of the robot as seen from the target, and
// how far off each may be.
void TargetFollower::walkTo(const Vec3& p_R) {
  const double x = p_R.x() + relative[0];
  const double y = p_R.y() + relative[1];
  const double turn = std::atan2(p_R.y(), p_R.x()) + relative[2];
  const bool there =
      std::abs(x) < relative[3] && std::abs(y) < relative[4] && std::abs(turn) < relative[5];
  if (there != reached_ && there) tell("TargetReached");
  reached_ = there;
  if (there) return stand();
  walking_ = true;
  post(motion::Move{{limited(kGain * x, kTopSpeed), limited(kGain * y, kTopSpeed / 2),
                     limited(kGain * turn, kTopTurn)},
                    {}});
}

void TargetFollower::stand() {
  if (!walking_) return;
  walking_ = false;
  post(motion::StopMove{});
}

// Left and right, level and down.
void TargetFollower::search() {
  if (searched_++ % kSearchLooks != 0) return;
  const int place = searched_ / kSearchLooks % 4;
  const double side = place % 2 == 0 ? 1 : -1;
  lookAt({1, side, place < 2 ? 0.4 : 0.0}, 2, kPointFraction);
}

Vec3 TargetFollower::inTorso(const Vec3& place, int frame) {
  if (frame < 0 || frame > 2) {
    throw rpc::CallError("unknown frame " + std::to_string(frame) +
                         ": 0 is the torso's, 1 the world's, 2 the robot's");
  }
  kinematics_.update(context_.link.sensors()->angle);
  if (frame == 0) return place;
  Vec3 p_R = place;
  if (frame == 1) {
    const Pose2 at = context_.link.state()->position;
    p_R = rotationFromRpy(0, 0, -at.theta) * (place - Vec3(at.x, at.y, 0));
  }
  return kinematics_.calcRobotFrame() * p_R;
}

std::optional<Vec3> TargetFollower::targetIn(int frame) {
  inTorso(Vec3::Zero(), frame);  // checks the frame, and takes the joints in
  if (!sees()) return std::nullopt;
  const Vec3 p_T = targetInTorso();
  if (frame == 0) return p_T;
  const Vec3 p_R = kinematics_.calcRobotFrame().inverse() * p_T;
  if (frame == 2) return p_R;
  const Pose2 at = context_.link.state()->position;
  return Vec3(rotationFromRpy(0, 0, at.theta) * p_R) + Vec3(at.x, at.y, 0);
}

std::vector<float> TargetFollower::robotPosition() const {
  const Pose2 at = context_.link.state()->position;
  return {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.theta)};
}

void TargetFollower::lookAt(Vec3 place, int frame, double fraction) {
  const RobotModel& model = context_.link.model();
  const auto yaw = model.findJoint("HeadYaw");
  const auto pitch = model.findJoint("HeadPitch");
  if (!yaw || !pitch) throw rpc::CallError("this robot has no head to turn");
  place = inTorso(place, frame);
  if (const auto neck = motion::findEffector(model, "HeadYaw")) {
    place -= kinematics_.calcPose(*neck).translation();
  }
  post(motion::SetAngles{
      {*yaw, *pitch},
      {std::atan2(place.y(), place.x()), std::atan2(-place.z(), std::hypot(place.x(), place.y()))},
      {fraction, fraction},
      false});
}

// The arm is stretched; its shoulder pitch is 0 ahead, its roll positive to the left.
void TargetFollower::pointAt(const std::string& arm, Vec3 place, int frame, double fraction) {
  place = inTorso(place, frame);
  const std::string side = arm == "Arms"   ? (place.y() > 0 ? "L" : "R")
                           : arm == "LArm" ? "L"
                           : arm == "RArm" ? "R"
                                           : "";
  if (side.empty()) throw rpc::CallError("expected LArm, RArm or Arms, got " + arm);
  const RobotModel& model = context_.link.model();
  const auto shoulder = motion::findEffector(model, side + "ShoulderPitch");
  if (!shoulder) throw rpc::CallError("this robot has no arm to point with");
  const Vec3 way = (place - kinematics_.calcPose(*shoulder).translation()).normalized();
  motion::SetAngles request;
  for (const auto& [name, angle] :
       {std::pair("ShoulderPitch", std::atan2(-way.z(), way.x())),
        std::pair("ShoulderRoll", std::asin(std::clamp(way.y(), -1.0, 1.0))),
        std::pair("ElbowRoll", 0.0)}) {
    const auto joint = model.findJoint(side + name);
    if (!joint) continue;
    request.joints.push_back(*joint);
    request.angles.push_back(angle);
    request.fraction.push_back(fraction);
  }
  post(std::move(request));
}

void TargetFollower::post(motion::MotionAction action) const {
  try {
    context_.link.post(std::move(action));
  } catch (const rpc::CallError&) {
    return;  // the robot is busy; the next look comes soon
  }
}

}  // namespace nao::services
