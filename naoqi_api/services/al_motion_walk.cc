#include "naoqi_api/services/al_motion_walk.h"

#include <algorithm>
#include <cmath>

#include "naoqi_api/services/al_motion_move_config.h"
#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"

namespace nao::services {
namespace {

std::vector<float> asFloats(const Pose2& pose) {
  return {static_cast<float>(pose.x), static_cast<float>(pose.y), static_cast<float>(pose.theta)};
}

rpc::Value asList(const Pose2& pose) {
  return rpc::Value::list(
      {static_cast<float>(pose.x), static_cast<float>(pose.y), static_cast<float>(pose.theta)});
}

Pose2 readPose(const rpc::Value& value) {
  const auto numbers = value.to<std::vector<double>>();
  if (numbers.size() != 3) throw rpc::CallError("expected [x, y, theta], got " + value.print());
  return {finite(numbers[0]), finite(numbers[1]), finite(numbers[2])};
}

// [x, y, theta] or a list of those.
std::vector<Pose2> readPath(const rpc::Value& value) {
  const auto* items = value.findItems();
  if (items == nullptr || items->empty()) {
    throw rpc::CallError("expected [x, y, theta] or a list of those, got " + value.print());
  }
  if (!items->front().isList()) return {readPose(value)};
  std::vector<Pose2> path;
  for (const rpc::Value& item : *items) path.push_back(readPose(item));
  return path;
}

motion::MoveToward towards(float x, float y, float theta, const motion::GaitConfig& config) {
  const auto fraction = [](float part) { return std::clamp(finite(part), -1.0, 1.0); };
  return {fraction(x), fraction(y), fraction(theta), config};
}

motion::GaitConfig atFrequency(float frequency) {
  motion::GaitConfig config;
  config.max_step_frequency = std::clamp(finite(frequency), 0.0, 1.0);
  return config;
}

}  // namespace

void AlMotionWalk::move(float x, float y, float theta) {
  link_.post(motion::Move{{finite(x), finite(y), finite(theta)}, {}});
}

void AlMotionWalk::moveWith(float x, float y, float theta, const rpc::Value& config) {
  link_.post(motion::Move{{finite(x), finite(y), finite(theta)}, readMoveConfig(config)});
}

void AlMotionWalk::moveToward(float x, float y, float theta) {
  link_.post(towards(x, y, theta, {}));
}

void AlMotionWalk::moveTowardWith(float x, float y, float theta, const rpc::Value& config) {
  link_.post(towards(x, y, theta, readMoveConfig(config)));
}

void AlMotionWalk::setWalkTargetVelocity(float x, float y, float theta, float frequency) {
  link_.post(towards(x, y, theta, atFrequency(frequency)));
}

void AlMotionWalk::setWalkTargetVelocityWith(float x, float y, float theta, float frequency,
                                             const rpc::Value& config) {
  link_.post(towards(x, y, theta, readMoveConfig(config, atFrequency(frequency))));
}

void AlMotionWalk::setWalkTargetVelocityWithBoth(float x, float y, float theta, float frequency,
                                                 const rpc::Value& left, const rpc::Value& right) {
  const auto config = readMoveConfig(right, readMoveConfig(left, atFrequency(frequency)));
  link_.post(towards(x, y, theta, config));
}

rpc::Pending<void> AlMotionWalk::moveTo(float x, float y, float theta) {
  return link_.postAndWait(motion::MoveTo{{finite(x), finite(y), finite(theta)}, {}, {}});
}

rpc::Pending<void> AlMotionWalk::moveToIn(float x, float y, float theta, float time) {
  return link_.postAndWait(motion::MoveTo{{finite(x), finite(y), finite(theta)}, finite(time), {}});
}

rpc::Pending<void> AlMotionWalk::moveToWith(float x, float y, float theta,
                                            const rpc::Value& config) {
  return link_.postAndWait(
      motion::MoveTo{{finite(x), finite(y), finite(theta)}, {}, readMoveConfig(config)});
}

rpc::Pending<void> AlMotionWalk::moveToInWith(float x, float y, float theta, float time,
                                              const rpc::Value& config) {
  return link_.postAndWait(
      motion::MoveTo{{finite(x), finite(y), finite(theta)}, finite(time), readMoveConfig(config)});
}

rpc::Pending<void> AlMotionWalk::movePath(const rpc::Value& points) {
  return movePathWith(points, rpc::Value::list({}));
}

rpc::Pending<void> AlMotionWalk::movePathWith(const rpc::Value& points, const rpc::Value& config) {
  rpc::Pending<void> done;
  walkOn(readPath(points), 0, readMoveConfig(config), done);
  return done;
}

// Every point is given as seen from the one before; each stretch is asked for when the robot stands
// at the end of that.
void AlMotionWalk::walkOn(const std::vector<Pose2>& path, std::size_t next,
                          const motion::GaitConfig& config, const rpc::Pending<void>& done) {
  const auto stretch = link_.outcomeOf(link_.post(motion::MoveTo{path[next], {}, config}));
  done.onCancel(stretch.canceler());
  stretch.whenDone([this, path, next, config, done](const auto& outcome) {
    using Kind = motion::MotionOutcome::Kind;
    if (outcome.isCanceled()) return done.cancelNow();
    if (outcome.value->kind == Kind::Failed) return done.fail(outcome.value->reason);
    if (outcome.value->kind == Kind::Killed || next + 1 == path.size()) return done.resolve();
    try {
      walkOn(path, next + 1, config, done);
    } catch (const rpc::CallError& error) {
      done.fail(error.what());
    }
  });
}

rpc::Pending<void> AlMotionWalk::moveInit() { return link_.postAndWait(motion::MoveInit{}); }

rpc::Pending<void> AlMotionWalk::waitUntilMoveIsFinished() {
  return link_.until([](const motion::MotionState& state) { return !state.move_active; });
}

rpc::Pending<bool> AlMotionWalk::moveIsActive() {
  return link_.whenSettled([this] { return link_.state()->move_active; });
}

rpc::Pending<void> AlMotionWalk::stopMove() { return link_.postAndWait(motion::StopMove{}); }

void AlMotionWalk::killMove() { link_.post(motion::KillMove{}); }

rpc::Pending<std::vector<float>> AlMotionWalk::getRobotPosition(bool use_sensors) {
  return link_.whenSettled([this, use_sensors] {
    return asFloats(use_sensors ? sensedPosition() : link_.state()->position);
  });
}

// The foot that bears more is where it was commanded to be; from there the joints tell.
Pose2 AlMotionWalk::sensedPosition() {
  const auto state = link_.state();
  const RobotModel& model = link_.model();
  if (model.feet.size() != 2 || model.feet[0].outline.empty()) return state->position;
  const auto sensors = link_.sensors();
  const bool is_left = sensors->feet[0].total >= sensors->feet[1].total;
  const Foot foot = is_left ? Foot::Left : Foot::Right;
  const auto foot_in_robot = [&](const JointArray<double>& angle) {
    kinematics_.update(angle);
    const Pose X_RS = kinematics_.calcRobotFrame().inverse() * kinematics_.calcSole(foot);
    const Vec3 ahead = X_RS.linear().col(0);
    return Pose2{X_RS.translation().x(), X_RS.translation().y(), std::atan2(ahead.y(), ahead.x())};
  };
  const Pose2 place = compose(state->position, foot_in_robot(state->command.angle));
  return compose(place, relativeTo(foot_in_robot(sensors->angle), Pose2{}));
}

rpc::Pending<std::vector<float>> AlMotionWalk::getNextRobotPosition() {
  return link_.whenSettled([this] { return asFloats(link_.state()->next_position); });
}

rpc::Pending<std::vector<float>> AlMotionWalk::getRobotVelocity() {
  return link_.whenSettled([this] {
    const motion::Velocity2 velocity = link_.state()->velocity;
    return asFloats({velocity.x, velocity.y, velocity.theta});
  });
}

rpc::Pending<rpc::Value> AlMotionWalk::getFootSteps() {
  return link_.whenSettled([this] {
    const auto state = link_.state();
    // Where the feet are: in the robot frame by the commanded joints, and on the floor by odometry.
    kinematics_.update(state->command.angle);
    const Pose X_RT = kinematics_.calcRobotFrame().inverse();
    std::vector<rpc::Value> feet;
    for (const Foot foot : {Foot::Left, Foot::Right}) {
      if (link_.model().feet.empty()) break;
      const Pose X_RS = X_RT * kinematics_.calcSole(foot);
      const Pose2 in_robot{X_RS.translation().x(), X_RS.translation().y(),
                           rpyOf(X_RS.linear()).z()};
      feet.push_back(asList(compose(state->position, in_robot)));
    }
    // The step under way can no longer change, those after it can.
    std::vector<rpc::Value> unchangeable;
    std::vector<rpc::Value> changeable;
    for (const motion::Footstep& step : state->footsteps) {
      auto& steps = unchangeable.empty() ? unchangeable : changeable;
      steps.push_back(rpc::Value::list({step.foot == Foot::Left ? "LLeg" : "RLeg",
                                        static_cast<float>(toSeconds(step.lands - state->time)),
                                        asList(step.place)}));
    }
    return rpc::Value::list({rpc::Value::list(std::move(feet)),
                             rpc::Value::list(std::move(unchangeable)),
                             rpc::Value::list(std::move(changeable))});
  });
}

rpc::Value AlMotionWalk::getMoveConfig(const std::string& which) { return listMoveConfig(which); }

}  // namespace nao::services
