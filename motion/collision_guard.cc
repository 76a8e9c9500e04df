#include "motion/collision_guard.h"

#include <algorithm>

#include "core/shape_distance.h"
#include "core/shape_gap.h"

namespace nao::motion {
namespace {

// Free choices: what isCollision calls near, and touching; the bisection leaves 1/256 of a step.
constexpr double kNear = 0.02;      // [m]
constexpr double kTouching = 1e-3;  // [m]
constexpr int kHalvings = 8;

}  // namespace

CollisionGuard::CollisionGuard(const RobotModel& model)
    : model_(model), X_TB_(model.bodies.size(), Pose::Identity()) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    for (const Shape& shape : model.bodies[i].collisions) {
      solids_.push_back({static_cast<int>(i), shape, boundingRadius(shape), Pose::Identity()});
    }
  }
  findArm("LArm", arms_[0]);
  findArm("RArm", arms_[1]);
}

void CollisionGuard::enable(std::size_t arm, bool on) {
  arms_[arm].enabled = on;
  if (!on) arms_[arm].held.reset();
}

void CollisionGuard::findArm(const char* group, Arm& arm) {
  const JointSet joints = jointsOfGroup(model_, group);
  for (std::size_t i = 0; i < model_.coordinates.size(); ++i) {
    const std::size_t joint = index(model_.coordinates[i].joint);
    if (!joints.test(joint)) continue;
    arm.joints.push_back(joint);
    arm.bodies.push_back(static_cast<int>(i + 1));
  }
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    const auto& bodies = arm.bodies;
    if (std::find(bodies.begin(), bodies.end(), solids_[i].body) != bodies.end()) {
      arm.solids.push_back(i);
    }
  }
  findPairs(arm);
}

void CollisionGuard::findPairs(Arm& arm) {
  const auto& never = model_.no_collision;
  for (const std::size_t mine : arm.solids) {
    for (std::size_t other = 0; other < solids_.size(); ++other) {
      if (std::find(arm.solids.begin(), arm.solids.end(), other) != arm.solids.end()) continue;
      const std::pair<int, int> bodies = std::minmax(solids_[mine].body, solids_[other].body);
      if (std::find(never.begin(), never.end(), bodies) == never.end()) {
        arm.pairs.push_back({mine, other});
      }
    }
  }
}

void CollisionGuard::placeBody(int body, const JointArray<double>& angle) {
  const auto i = static_cast<std::size_t>(body);
  const Body& link = model_.bodies[i];
  const double q = angle[model_.coordinates[i - 1].joint];
  X_TB_[i] =
      X_TB_[static_cast<std::size_t>(link.parent)] * link.X_PB * Eigen::AngleAxisd(q, link.axis);
}

void CollisionGuard::placeAll(const JointArray<double>& angle) {
  for (std::size_t i = 1; i < model_.bodies.size(); ++i) placeBody(static_cast<int>(i), angle);
  for (Solid& solid : solids_) {
    solid.X_TS = X_TB_[static_cast<std::size_t>(solid.body)] * solid.shape.X_BS;
  }
}

void CollisionGuard::placeArm(const Arm& arm, const JointArray<double>& angle) {
  for (const int body : arm.bodies) placeBody(body, angle);
  for (const std::size_t i : arm.solids) {
    solids_[i].X_TS = X_TB_[static_cast<std::size_t>(solids_[i].body)] * solids_[i].shape.X_BS;
  }
}

// Gaps above kNear are of no interest and may come out as kNear.
double CollisionGuard::leastGap(const Arm& arm) const {
  double least = kNear;
  for (const Pair& pair : arm.pairs) {
    const Solid& a = solids_[pair.mine];
    const Solid& b = solids_[pair.other];
    const double reach = a.radius + b.radius + least;
    const double apart = (a.X_TS.translation() - b.X_TS.translation()).squaredNorm();
    if (reach <= 0 || apart >= reach * reach) continue;
    least = std::min(least, calcShapeGap(a.shape, a.X_TS, b.shape, b.X_TS).distance);
  }
  return least;
}

double CollisionGuard::gapAt(const Arm& arm, const JointArray<double>& angle) {
  placeArm(arm, angle);
  return leastGap(arm);
}

void CollisionGuard::apply(const JointArray<double>& from, double dt, JointArray<double>& command) {
  if (arms_[0].pairs.empty() && arms_[1].pairs.empty()) return;
  // Both arms where they were, all else where it will be; then one arm after the other moves.
  JointArray<double> start = command;
  for (const Arm& arm : arms_) {
    for (const std::size_t joint : arm.joints) {
      if (arm.enabled) start[joint] = from[joint];
    }
  }
  placeAll(start);
  for (Arm& arm : arms_) {
    if (arm.enabled) guard(arm, start, dt, command);
    const double gap = leastGap(arm);
    arm.nearness = gap < kTouching ? Nearness::Collision
                   : gap < kNear   ? Nearness::Near
                                   : Nearness::None;
  }
}

void CollisionGuard::guard(Arm& arm, const JointArray<double>& from, double dt,
                           JointArray<double>& command) {
  const JointArray<double> wanted = command;
  for (const std::size_t joint : arm.joints) {
    const double most = model_.actuators[joint].max_velocity * dt;
    const double way = wanted[joint] - from[joint];
    if (arm.held.test(joint)) command[joint] = from[joint] + std::clamp(way, -most, most);
  }
  const double floor = std::min(0.0, leastGap(arm));
  if (gapAt(arm, command) < floor) {
    JointArray<double> angle = command;
    for (const std::size_t joint : arm.joints) angle[joint] = from[joint];
    for (const std::size_t joint : arm.joints) {
      const double way = command[joint] - from[joint];
      angle[joint] = from[joint] + freePart(arm, joint, way, floor, angle) * way;
    }
    command = angle;
    placeArm(arm, command);
  }
  for (const std::size_t joint : arm.joints) {
    arm.held.set(joint, command[joint] != wanted[joint]);
  }
}

// How much of a joint's way is free, 0 to 1, from where `angle` has it.
double CollisionGuard::freePart(const Arm& arm, std::size_t joint, double way, double floor,
                                JointArray<double>& angle) {
  if (way == 0) return 0;
  const double start = angle[joint];
  const auto is_free = [&](double part) {
    angle[joint] = start + part * way;
    return gapAt(arm, angle) >= floor;
  };
  double low = 0;
  double high = 1;
  if (is_free(high)) low = high;
  for (int i = 0; i < kHalvings && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    (is_free(middle) ? low : high) = middle;
  }
  angle[joint] = start;
  return low;
}

void CollisionGuard::archive(Archive& archive) {
  for (Arm& arm : arms_) {
    archive.value(arm.enabled);
    archive.value(arm.held);
    archive.value(arm.nearness);
  }
}

}  // namespace nao::motion
