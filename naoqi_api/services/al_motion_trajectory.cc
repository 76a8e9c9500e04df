#include "naoqi_api/services/al_motion_trajectory.h"

#include <algorithm>
#include <cmath>

#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/finite.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Answer;
using rpc::Argument;
using rpc::CallError;
using rpc::Value;

constexpr std::size_t kMostPoints = 1000;
constexpr int kDeepest = 16;
constexpr double kArc = 0.35;  // [rad] of a circle walked straight; free

const std::vector<Value>& partsOf(const Value& value, std::size_t least) {
  const auto* parts = value.findItems();
  if (!parts || parts->size() < least || !parts->front().findText()) {
    throw CallError("expected [\"Line\", ...] or the like, got " + value.print());
  }
  return *parts;
}

Eigen::Vector2d readPoint(const Value& value) {
  const auto numbers = value.to<std::vector<double>>();
  if (numbers.size() != 2) throw CallError("expected [x, y], got " + value.print());
  return {finite(numbers[0]), finite(numbers[1])};
}

void appendLine(const Value& line, std::vector<Eigen::Vector2d>& points, int depth) {
  if (depth > kDeepest || points.size() > kMostPoints) throw CallError("the way is too long");
  const auto& parts = partsOf(line, 2);
  const std::string& kind = *parts[0].findText();
  const Eigen::Vector2d start = points.back();
  if (kind == "Composed") {
    for (std::size_t i = 1; i < parts.size(); ++i) appendLine(parts[i], points, depth + 1);
  } else if (kind == "Line") {
    points.push_back(start + readPoint(parts[1]));
  } else if (kind == "Circle" && parts.size() >= 3) {
    const Eigen::Vector2d centre = readPoint(parts[1]);
    const double angle = std::clamp(finite(parts[2].to<double>()), -100.0, 100.0);
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / kArc)));
    for (int i = 1; i <= pieces; ++i) {
      const Eigen::Rotation2Dd turned(angle * i / pieces);
      points.push_back(start + centre - turned * centre);
    }
  } else {
    throw CallError("expected Line, Circle or Composed, got " + line.print());
  }
}

// Each part begins where the one before has ended, as it then stands.
void appendWay(const Value& way, std::vector<Pose2>& poses, int depth) {
  if (depth > kDeepest || poses.size() > kMostPoints) throw CallError("the way is too long");
  const auto& parts = partsOf(way, 2);
  const std::string& kind = *parts[0].findText();
  const bool holds_ways =
      kind == "Composed" && parts[1].isList() && partsOf(parts[1], 1).front() == Value("Holonomic");
  if (holds_ways) {
    for (std::size_t i = 1; i < parts.size(); ++i) {
      if (parts[i].isList()) appendWay(parts[i], poses, depth + 1);
    }
    return;
  }
  const bool is_holonomic = kind == "Holonomic";
  if (is_holonomic && parts.size() < 4) {
    throw CallError("expected [\"Holonomic\", line, turn, seconds], got " + way.print());
  }
  std::vector<Eigen::Vector2d> points = {Eigen::Vector2d::Zero()};
  appendLine(is_holonomic ? parts[1] : way, points, depth + 1);
  const double turn = is_holonomic ? finite(parts[2].to<double>()) : 0;
  const Pose2 start = poses.empty() ? Pose2{} : poses.back();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(points.size() - 1);
    poses.push_back(compose(start, {points[i].x(), points[i].y(), part * turn}));
  }
}

Pose2 readPose(const Value& value) {
  const auto numbers = value.to<std::vector<double>>();
  if (numbers.size() != 3) throw CallError("expected [x, y, theta], got " + value.print());
  return {finite(numbers[0]), finite(numbers[1]), finite(numbers[2])};
}

// The same walk for a method that returns nothing.
rpc::Pending<void> withoutNumber(const rpc::Pending<int>& walked) {
  rpc::Pending<void> done;
  done.cancelsWith(walked);
  walked.whenDone([done](const auto& outcome) {
    if (outcome.isCanceled()) return done.cancelNow();
    if (outcome.error) return done.fail(*outcome.error);
    done.resolve();
  });
  return done;
}

const Argument kWay{
    "path",
    "[\"Line\", [x, y]], [\"Circle\", centre, angle], [\"Composed\", part, ...], or "
    "[\"Holonomic\", line, turn, seconds]."};

Value asList(const Pose2& pose) {
  return Value::list(
      {static_cast<float>(pose.x), static_cast<float>(pose.y), static_cast<float>(pose.theta)});
}

Value asList(const std::vector<Pose2>& poses) {
  std::vector<Value> list;
  for (const Pose2& pose : poses) list.push_back(asList(pose));
  return Value::list(std::move(list));
}

}  // namespace

std::vector<Pose2> readWay(const Value& way) {
  std::vector<Pose2> poses;
  appendWay(way, poses, 0);
  return poses;
}

rpc::Pending<int> AlMotionTrajectory::walk(rpc::Service& service, const Value& way,
                                           const Pose2& start, const Value& config) {
  points_.clear();
  for (const Pose2& point : readWay(way)) points_.push_back(compose(start, point));
  std::vector<Pose2> stretches;  // each as seen from the end of the one before
  Pose2 from = link_.state()->position;
  for (const Pose2& point : points_) {
    stretches.push_back(relativeTo(from, point));
    from = point;
  }
  const int id = ++id_;
  walking_ = true;
  rpc::Pending<int> done;
  const auto walked = service.call("moveTo", {asList(stretches), config}, {});
  done.cancelsWith(walked);
  walked.whenDone([this, id, done](const auto& outcome) {
    if (id == id_) walking_ = false;
    if (outcome.isCanceled()) return done.cancelNow();
    if (outcome.error) return done.fail(*outcome.error);
    done.resolve(id);
  });
  return done;
}

// The points from the nearest on.
std::vector<Pose2> AlMotionTrajectory::left() const {
  if (!walking_ || points_.empty()) return {};
  const Pose2 at = link_.state()->position;
  const auto distance = [&](const Pose2& point) {
    return std::hypot(point.x - at.x, point.y - at.y);
  };
  const auto nearest =
      std::min_element(points_.begin(), points_.end(),
                       [&](const Pose2& a, const Pose2& b) { return distance(a) < distance(b); });
  return {nearest, points_.end()};
}

void AlMotionTrajectory::declare(rpc::Service& service) {
  declareFollowing(service);
  declareMoving(service);
  declareTelling(service);
}

void AlMotionTrajectory::declareFollowing(rpc::Service& service) {
  const auto follow = [this, &service](const Value& path, const Value& config) {
    return withoutNumber(walk(service, path, link_.state()->position, config));
  };
  const auto follow_in_world = [this, &service](const Value& start, const Value& path,
                                                const Value& config) {
    return withoutNumber(walk(service, path, readPose(start), config));
  };
  const Argument config{"moveConfig", "[[name, value], ...]"};
  const char* const meaning = "Walks along a line and waits until the robot is there.";
  addFunction(service, "_followPath", follow, meaning, kWay, config).at(151);
  addFunction(
      service, "_followPath", [follow](const Value& path) { return follow(path, Value::list({})); },
      meaning, kWay)
      .at(152);
  const Argument start{"poseStart", "[x, y, theta] in the odometry's world where it begins."};
  addFunction(service, "_followPathInWorld", follow_in_world, meaning, start, kWay, config).at(153);
  addFunction(
      service, "_followPathInWorld",
      [follow_in_world](const Value& from, const Value& path) {
        return follow_in_world(from, path, Value::list({}));
      },
      meaning, start, kWay)
      .at(154);
  addFunction(
      service, "_setFollowPathSpeedFactor", [](float) {}, "Has no effect.",
      Argument{"speedFactor", "Ignored: steps take their own time."})
      .at(155)
      .answering(Answer::Simplified);
}

void AlMotionTrajectory::declareMoving(rpc::Service& service) {
  const auto along = [this, &service](const Value& path) {
    return walk(service, path, link_.state()->position, Value::list({}));
  };
  const char* const meaning = "Walks along a way; its number when the robot is there.";
  addFunction(service, "_moveAlong", along, meaning, kWay).at(156);
  addFunction(
      service, "_moveAlong", [along](const Value& path, float) { return along(path); }, meaning,
      kWay, Argument{"scaleFactor", "Changes nothing: steps take their own time."})
      .at(157)
      .answering(Answer::Simplified);
  addFunction(
      service, "_stopAndStitchMoveAlong", [this] { link_.post(motion::StopMove{}); },
      "Ends the walk with both feet on the ground.")
      .at(159);
}

void AlMotionTrajectory::declareTelling(rpc::Service& service) {
  addFunction(
      service, "_getTrajectoryId", [this] { return id_; }, "The number of the last way; 0 before.")
      .at(158);
  addFunction(
      service, "_getRemainingPath", [this](float) { return asList(left()); },
      "The corners still to come, in the world.",
      Argument{"sampleStep", "Changes nothing: the corners are told."})
      .at(160);
  addFunction(
      service, "_getRemainingTrajectory", [this](float, float) { return asList(left()); },
      "The corners still to come, in the world.",
      Argument{"timeStep", "Changes nothing: the corners are told."},
      Argument{"preview", "Changes nothing."})
      .at(161);
  addFunction(
      service, "_getTrajectoryCompletion",
      [this] {
        if (!walking_ || points_.empty()) return 1.0F;
        return 1.0F - static_cast<float>(left().size()) / static_cast<float>(points_.size());
      },
      "The part of the corners that is behind the robot: 0 to 1.")
      .at(162);
}

}  // namespace nao::services
