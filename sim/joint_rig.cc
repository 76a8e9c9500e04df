#include "sim/joint_rig.h"

#include <algorithm>

#include "core/check.h"
#include "sim/effects/coupled_stop.h"
#include "sim/joint_rig_run.h"

namespace nao::sim {
namespace {

bool isOneOf(const std::string& name, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* n) { return name == n; });
}

// All hinges that the motor turns, as one hinge whose range fits all of them.
Coordinate mergedHinge(const RobotModel& model, const Actuator& actuator) {
  Coordinate hinge = model.coordinates[static_cast<std::size_t>(actuator.coordinates.front())];
  for (const int c : actuator.coordinates) {
    const Coordinate& other = model.coordinates[static_cast<std::size_t>(c)];
    hinge.lower = std::max(hinge.lower, other.lower);
    hinge.upper = std::min(hinge.upper, other.upper);
  }
  return hinge;
}

constexpr double kFar = 1e3;  // [rad] the range of a hinge that only moves as it is told

void addJoint(const RobotModel& model, Joint joint, RobotModel& cut) {
  Actuator actuator = model.actuators[index(joint)];
  Coordinate hinge = mergedHinge(model, actuator);
  if (!cut.actuators.empty()) {
    hinge.lower = -kFar;
    hinge.upper = kFar;
  }
  const auto first = static_cast<std::size_t>(actuator.coordinates.front());
  hinge.joint = toJoint(cut.actuators.size());
  Body link = model.bodies[first + 1];
  link.parent = 0;
  link.visuals.clear();
  link.collisions.clear();
  actuator.coordinates = {static_cast<int>(cut.coordinates.size())};
  cut.bodies.push_back(std::move(link));
  cut.coordinates.push_back(std::move(hinge));
  cut.actuators.push_back(std::move(actuator));
}

}  // namespace

JointReach reachOf(const EffectType& type) {
  if (isOneOf(type.name, {"link_mass", "link_com", "payload", "gravity_scale", "ground_tilt",
                          "linear_damping", "angular_damping", "mass_spread"})) {
    return JointReach::Load;
  }
  const bool elsewhere =
      isOneOf(type.name, {"ground_friction", "ground_compliance", "floor_friction", "start_pose",
                          "fsr_gain", "fsr_threshold"}) ||
      type.acts == Acts::OnImu || type.name.rfind("imu_", 0) == 0;
  return elsewhere ? JointReach::None : JointReach::Rig;
}

bool actsOnJoint(const EffectType& type) { return reachOf(type) != JointReach::None; }

JointRig::JointRig(const RobotModel& model, Joint joint, Duration row, Duration step,
                   const std::vector<std::string>& others)
    : step_(step) {
  if (model.actuators[index(joint)].coordinates.empty()) {
    throw InputError(model.actuators[index(joint)].name + ": expected a joint with a hinge");
  }
  if (step <= Duration::zero() || row % step != Duration::zero()) {
    throw InputError("--step: expected a divisor of the time between two rows");
  }
  cut_.name = model.name;
  cut_.cycle = row;
  cut_.fixed_base = true;
  cut_.bodies.push_back(
      Body{"base", -1, Pose::Identity(), Vec3::UnitZ(), 1, Vec3::Zero(), Mat3::Identity(), {}, {}});
  std::vector<Joint> joints{joint};
  for (const std::string& name : others) {
    const auto found = model.findJoint(name);
    if (found && *found != joint) joints.push_back(*found);
  }
  for (const Joint one : joints) {
    if (!kept_.emplace(one, toJoint(kept_.size())).second) continue;
    addJoint(model, one, cut_);
  }
  for (CoupledLimit limit : model.coupled_limits) {
    const auto driver = kept_.find(limit.driver);
    if (limit.limited != joint || driver == kept_.end()) continue;
    limit.driver = driver->second;
    limit.limited = toJoint(0);
    cut_.coupled_limits.push_back(std::move(limit));
  }
  keepCoupling(model, joint);
}

// Without a limit of its own: whom an effect may couple it to.
void JointRig::keepCoupling(const RobotModel& model, Joint joint) {
  const std::optional<Joint> other = findCoupledTo(model, joint);
  if (!cut_.coupled_limits.empty() || !other || kept_.count(*other) == 0) return;
  cut_.coupled_limits.push_back({kept_.at(*other), toJoint(0), {}, false, false});
}

std::vector<EffectSetting> JointRig::cut(const std::vector<EffectSetting>& settings,
                                         const EffectCatalogue& catalogue) const {
  std::vector<EffectSetting> mapped;
  for (const EffectSetting& setting : settings) {
    const EffectType* type = catalogue.find(setting.name);
    if (type && reachOf(*type) != JointReach::Rig) continue;
    EffectSetting one = setting;
    one.joints.clear();
    for (const Joint j : setting.joints) {
      if (const auto at = kept_.find(j); at != kept_.end()) one.joints.push_back(at->second);
    }
    const bool meant = setting.joints.empty() || std::find(one.joints.begin(), one.joints.end(),
                                                           toJoint(0)) != one.joints.end();
    if (meant) mapped.push_back(std::move(one));
  }
  return mapped;
}

JointSignals JointRig::run(const std::vector<EffectSetting>& effects, const JointOrders& orders,
                           const JointLoad& load, const RigChance& chance, Duration settle,
                           const EffectCatalogue& catalogue) const {
  const std::size_t rows = orders.angle.size();
  NAO_CHECK(rows > 0 && load.per_row > 0 && (row() / step_) % load.per_row == 0);
  const std::size_t values = (rows - 1) * static_cast<std::size_t>(load.per_row) + 1;
  NAO_CHECK(load.inertia.size() == values && load.torque.size() == values &&
            load.reference.size() == values && load.slope.size() == values);
  NAO_CHECK(orders.stiffness.empty() || orders.stiffness.size() == rows);
  EffectChain chain(catalogue, cut(effects, catalogue), cut_, step_, chance.stream, cut_.name,
                    chance.pair);
  JointRigRun run(cut_, step_, chain, orders, load, chance);
  return run.all(settle);
}

}  // namespace nao::sim
