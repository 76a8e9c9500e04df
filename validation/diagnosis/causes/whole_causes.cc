#include "validation/diagnosis/causes/whole_causes.h"

#include <algorithm>
#include <cmath>

#include "validation/merge_effects.h"

namespace nao::validation {
namespace {

constexpr double kFar = 1e9;  // of a parameter whose neutral value is as good as infinite

// Starts of a cause that are looked at: a whole robot costs more than a joint. Free choices.
constexpr std::size_t kStartsEverywhere = 3, kStartsSomewhere = 2;

// Of a stop that moves with another joint, unless what was measured tells where it may be
// (touching_stops.h): a hull's edges, from flat to steep, where either joint of an ankle may meet
// them.
const std::vector<double> kSlopes{0.4, -0.4, 1.5, -1.5};          // [rad/rad]
const std::vector<double> kEdges{0, -0.3, -0.6, -0.9, 0.3, 0.6};  // [rad]

// Of a leg's zero: it moves where every step lands, and so all that follow. A walk answers a gross
// error otherwise than so many times a small one.
const std::vector<double> kZeros{0.01, 0.05, -0.05};  // [rad]

// Of the torque of a joint or a limb: motors are strong, a leg may walk on with a tenth of it.
const std::vector<double> kWeak{-0.3, -0.6, -0.85};

// Of gains of what bears a robot, a joint's or those of many: with play in its gear a little more
// shows nothing.
const std::vector<double> kGains{0.2, -0.6}, kManyGains{0.2, -0.3};

using Ids = std::vector<const char*>;

// What one number for all joints can be wrong about.
const Ids kEverywhere{"coulomb_friction", "viscous_friction",  "load_friction", "torque_limit",
                      "voltage_sag.drop", "voltage_sag.slope", "kp_error",      "kd_error",
                      "servo_deadband",   "motor_inertia",     "backlash",      "gear_compliance",
                      "link_mass",        "gravity_scale",     "ground_tilt.x", "ground_tilt.y",
                      "command_latency",  "sensor_delay",      "command_hold",  "command_filter",
                      "rate_limit"};
const Ids kSide{"coulomb_friction", "viscous_friction", "torque_limit",   "kp_error",
                "backlash",         "link_mass",        "command_latency"};
const Ids kLegJoint{"encoder_offset", "kp_error",       "coulomb_friction", "backlash",
                    "torque_limit",   "servo_deadband", "viscous_friction"};
const Ids kArmJoint{"encoder_offset", "kp_error", "coulomb_friction"};
const Ids kHull{"coupled_stop.upper", "coupled_stop.lower"};
const Ids kStops{"joint_stop.upper", "joint_stop.lower"};

// Second numbers that are left to the joint: how the weight of a heavier link is spread, what
// friction goes with, how softly a gear gives way, how gently a command arrives; of robots on their
// feet also how slowly what sticks creeps, and how softly a dead band ends.
const Ids kOneNumber{"link_mass", "load_friction", "backlash", "gear_compliance", "rate_limit"};
const Ids kOneNumberOnFeet{"coulomb_friction", "servo_deadband"};
// But of all joints at once: what creeps, told as what sticks, leaves gains of arms to be found.
const std::string kCreeping = "coulomb_friction";

std::vector<Cause> reduced(std::vector<Cause> all, const Ids& ids) {
  for (Cause& cause : all) {
    for (const char* id : ids) {
      if (cause.id == id) cause.free.resize(1);
    }
  }
  return all;
}

const std::vector<Cause>& knownCauses(bool hangs) {
  static const std::vector<Cause> hanging = reduced(jointCauses(), kOneNumber);
  static const std::vector<Cause> standing = reduced(hanging, kOneNumberOnFeet);
  return hangs ? hanging : standing;
}

const Cause* find(const std::string& id, bool hangs) {
  const auto& all = knownCauses(hangs);
  const auto at =
      std::find_if(all.begin(), all.end(), [&](const Cause& cause) { return cause.id == id; });
  return at == all.end() ? nullptr : &*at;
}

// Units and bounds of the effect's parameters, as far as what the model has leaves room.
Cause bounded(Cause cause, const RobotModel& model, const std::vector<Joint>& joints) {
  const sim::EffectCatalogue& catalogue = sim::standardEffects();
  const sim::EffectType* type = catalogue.find(cause.effect);
  for (FreeNumber& number : cause.free) {
    for (const sim::Parameter& p : type->parameters) {
      if (p.name != number.parameter) continue;
      number.unit = p.unit;
      number.neutral = p.neutral;
      if (number.form == Form::Inverse) {
        number.upper = 1 / std::max(p.min, 1 / kFar);
        continue;
      }
      double most = 0;
      for (const Joint joint : joints) {
        const double has = presentDeviation(model, index(joint), cause.effect, p.name, catalogue);
        most = std::max(most, has);
      }
      number.lower = p.min - p.neutral - most;
      number.upper = p.max - p.neutral;
      if (number.smallest == 0) number.smallest = p.smallest;
    }
  }
  return cause;
}

// Whether two joints of a leg turn about the same axis: a hip's roll and an ankle's.
bool turnAlike(const RobotModel& model, Joint a, Joint b) {
  constexpr double kAlike = 0.9;
  const auto axisOf = [&](Joint joint) -> Vec3 {
    const std::vector<int>& turned = model.actuators[index(joint)].coordinates;
    if (turned.empty()) return Vec3::Zero();
    return model.bodies[static_cast<std::size_t>(turned.front()) + 1].axis;
  };
  return std::abs(axisOf(a).dot(axisOf(b))) > kAlike;
}

class Builder {
 public:
  Builder(const RobotModel& model, const std::vector<Joint>& measured)
      : model_(model), measured_(measured), hangs_(model.fixed_base) {}

  void add(const Cause& cause, const std::string& place, const std::vector<Joint>& joints) {
    all_.push_back(placedCause(cause, place, joints, model_, measured_));
    std::vector<FreeNumber>& numbers = all_.back().cause.free;
    if (cause.coupled) {
      numbers[0].starts = kSlopes;
      numbers[1].starts = kEdges;
      return;
    }
    std::vector<double>& starts = numbers[0].starts;
    const std::size_t most = joints.empty() ? kStartsEverywhere : kStartsSomewhere;
    if (starts.size() > most) starts.resize(most);
    if (cause.id == "torque_limit" && !joints.empty()) starts = kWeak;
    if (cause.id == "kp_error" && !hangs_) {
      starts = joints.size() == 1 ? kGains : kManyGains;
      all_.back().cause.gross = true;
    }
  }
  // Of each joint, never looked for.
  void addSpread(const Ids& ids, const std::vector<Joint>& joints) {
    for (const Joint joint : joints) {
      for (const char* id : ids) {
        const Cause* cause = find(id, hangs_);
        if (cause == nullptr) continue;
        all_.push_back(
            placedCause(*cause, model_.actuators[index(joint)].name, {joint}, model_, measured_));
        all_.back().cause.free[0].starts.clear();
      }
    }
  }
  // Of the joints that the robot walks on.
  void lookAtZeros(const std::vector<Joint>& joints) {
    for (PlacedCause& one : all_) {
      const bool ours = one.joints.size() == 1 &&
                        std::find(joints.begin(), joints.end(), one.joints[0]) != joints.end();
      if (one.cause.id != "encoder_offset" || !ours) continue;
      one.cause.gross = true;
      one.cause.free[0].starts = kZeros;
      for (const Joint other : joints) {
        if (other == one.joints[0] || !turnAlike(model_, one.joints[0], other)) continue;
        one.twins.push_back(model_.actuators[index(other)].name);
      }
    }
  }
  void add(const Ids& ids, const std::string& place, const std::vector<Joint>& joints) {
    for (const char* id : ids) {
      if (const Cause* cause = find(id, hangs_)) add(*cause, place, joints);
    }
  }
  // Two legs may share a joint: it is tried once.
  void addJoints(const Ids& ids, const std::vector<Joint>& joints) {
    for (const Joint joint : joints) {
      if (std::find(done_.begin(), done_.end(), joint) != done_.end()) continue;
      add(ids, model_.actuators[index(joint)].name, {joint});
      added_.push_back(joint);
    }
  }
  void endLimb() { done_.insert(done_.end(), added_.begin(), added_.end()); }
  std::vector<PlacedCause> take() { return std::move(all_); }

 private:
  const RobotModel& model_;
  const std::vector<Joint>& measured_;
  bool hangs_;
  std::vector<PlacedCause> all_;
  std::vector<Joint> added_, done_;
};

Cause worldCause(const char* id, const char* parameter, std::vector<double> starts,
                 const char* sentence, const char* separate) {
  Cause cause;
  cause.id = id;
  cause.effect = cause.id.substr(0, cause.id.find('.'));
  cause.free = {{parameter, std::move(starts), Form::Offset, "", 0, 0, 0, 0}};
  cause.scope = Scope::Robot;
  cause.linear = false;
  cause.sentence = sentence;
  cause.separate = separate;
  return cause;
}

// A clock ticks when it likes: where a log begins between two ticks tells no slope. Commands come
// every 10 ms, so that a clock of 7.5 ms knows three such places.
Cause withPhase(Cause hold) {
  FreeNumber phase;
  phase.parameter = "phase";
  phase.starts = {0, 0.0025, 0.005};
  phase.stays = true;
  hold.free.push_back(std::move(phase));
  return hold;
}

// Starts: free choices, from what a walk begins to feel to what lets it nearly fall.
void addWorld(Builder& builder) {
  builder.add(worldCause("ground_friction", "scale", {-0.7, -0.9},
                         "the ground holds the soles with {value} of the nominal friction",
                         "pull the standing robot sideways with a spring balance"),
              "robot", {});
  builder.add(worldCause("ground_compliance", "softness", {4, 20},
                         "the ground is {value} times as soft as nominal (a carpet)",
                         "the same walk on a hard floor"),
              "robot", {});
  builder.add(
      worldCause("payload", "mass", {0.3}, "the torso carries {value} more", "weigh the robot"),
      "robot", {});
}

Cause sensorCause(const std::string& effect, const std::string& parameter, double start,
                  const std::string& sentence, const char* separate) {
  Cause cause = worldCause((effect + "." + parameter).c_str(), parameter.c_str(), {start},
                           sentence.c_str(), separate);
  cause.linear = true;
  return cause;
}

void addEverywhere(Builder& builder, const std::string& id, bool hangs) {
  const Cause* cause = find(id, hangs || id == kCreeping);
  if (cause == nullptr) return;
  builder.add(id == "command_hold" && !hangs ? withPhase(*cause) : *cause, "robot", {});
}

const char* const kSixSides = "hold the robot still on its six sides";

// How a robot came to stand, of which a log says nothing, tilts its torso by a third of a degree,
// and so far apart units sit in equal robots: a degree is of interest.
constexpr double kLean = 0.006, kTurned = 0.0175;  // [rad]
constexpr double kGravity = 9.81;                  // [m/s^2]

Cause of(Cause cause, double spread, double smallest) {
  cause.spread = spread;
  cause.free[0].smallest = smallest;
  return cause;
}

// Readings are wrong by a constant, or as a part of themselves.
void addInertialUnit(Builder& builder) {
  const auto add = [&](const Cause& cause) { builder.add(cause, "robot", {}); };
  for (const char* axis : {"x", "y", "z"}) {
    const std::string about = axis;
    add(of(sensorCause("imu_bias", "acc_" + about, 0.5,
                       "the accelerometer reads {value} too much along " + about, kSixSides),
           0, kTurned * kGravity));
    add(sensorCause("imu_bias", "gyro_" + about, 0.02,
                    "the gyroscope reads {value} too much about " + about,
                    "read it while the robot rests"));
    add(of(sensorCause("imu_misalignment", about, 0.05,
                       "the inertial unit sits turned by {value} about " + about, kSixSides),
           kLean, kTurned));
  }
  add(sensorCause("imu_scale", "acc", 0.05, "the accelerometer exaggerates by {value}", kSixSides));
  add(sensorCause("imu_scale", "gyro", 0.1, "the gyroscope exaggerates by {value}",
                  "turn the robot by a known angle"));
  add(worldCause("imu_low_pass", "time", {0.02, 0.1},
                 "accelerometer and gyroscope are smoothed over {value}",
                 "knock at the chest of the resting robot"));
}

std::vector<Joint> among(const std::vector<Joint>& some, const std::vector<Joint>& measured) {
  std::vector<Joint> both;
  for (const Joint joint : some) {
    if (std::find(measured.begin(), measured.end(), joint) != measured.end() &&
        std::find(both.begin(), both.end(), joint) == both.end()) {
      both.push_back(joint);
    }
  }
  return both;
}

bool isLeg(const std::string& limb) { return limb.find("Leg") != std::string::npos; }

// Shells leave these less room the more the joint is bent that they hang on.
std::vector<Joint> hulled(const RobotModel& model, const std::vector<Joint>& joints) {
  std::vector<Joint> some;
  for (const Joint joint : joints) {
    const std::string& name = model.actuators[index(joint)].name;
    const bool limited =
        std::any_of(model.coupled_limits.begin(), model.coupled_limits.end(),
                    [&](const CoupledLimit& limit) { return limit.limited == joint; });
    const bool ankle = name.find("AnkleRoll") != std::string::npos;
    if (limited || ankle || name == "HeadPitch") some.push_back(joint);
  }
  return some;
}

// What hangs on the chain, all links at once: their mass and, by axis, where it is.
void addBaseParameters(Builder& builder, const std::string& limb,
                       const std::vector<Joint>& joints) {
  builder.add({"link_mass", "link_com.x", "link_com.y", "link_com.z"}, limb, joints);
}

// Joints that hang on a motor of these, but are not among them.
std::vector<Joint> turnedAlong(const RobotModel& model, const std::vector<Joint>& joints) {
  std::vector<Joint> whole, others;
  for (std::size_t j = 0; j < model.jointCount(); ++j) whole.push_back(toJoint(j));
  for (const std::string& limb : limbsOf(model, whole)) {
    const std::vector<Joint> all = jointsOf(model, limb, whole);
    const auto isShared = [&](Joint joint) {
      return model.actuators[index(joint)].coordinates.size() > 1 &&
             std::find(joints.begin(), joints.end(), joint) != joints.end();
    };
    if (std::none_of(all.begin(), all.end(), isShared)) continue;
    std::copy_if(all.begin(), all.end(), std::back_inserter(others), [&](Joint joint) {
      return std::find(joints.begin(), joints.end(), joint) == joints.end();
    });
  }
  return others;
}

}  // namespace

PlacedCause placedCause(const Cause& cause, const std::string& place,
                        const std::vector<Joint>& joints, const RobotModel& model,
                        const std::vector<Joint>& measured) {
  return {bounded(cause, model, joints.empty() ? measured : joints), place, joints};
}

EffectSetting PlacedCause::setting(const std::vector<double>& x) const {
  EffectSetting setting = settingOf(cause, x);
  setting.joints = joints;
  return setting;
}

std::string PlacedCause::sentence(const std::string& value) const {
  return cause.fill(place == "robot" ? "every joint" : place, value);
}

std::vector<std::string> limbsOf(const RobotModel& model, const std::vector<Joint>& measured) {
  std::vector<std::string> limbs;
  for (const char* limb : {"Head", "LArm", "RArm", "LLeg", "RLeg"}) {
    if (!jointsOf(model, limb, measured).empty()) limbs.emplace_back(limb);
  }
  if (limbs.empty()) limbs.emplace_back("Body");
  return limbs;
}

std::vector<Joint> jointsOf(const RobotModel& model, const std::string& limb,
                            const std::vector<Joint>& measured) {
  std::vector<Joint> joints;
  const auto group = model.groups.find(limb);
  if (group == model.groups.end()) return limb == "Body" ? measured : joints;
  for (const std::string& name : group->second) {
    if (const auto joint = model.findJoint(name)) joints.push_back(*joint);
  }
  return among(joints, measured);
}

std::vector<PlacedCause> robotCauses(const RobotModel& model, const std::vector<Joint>& measured) {
  Builder builder(model, measured);
  if (!model.fixed_base) addWorld(builder);
  for (const char* id : kEverywhere) addEverywhere(builder, id, model.fixed_base);
  addInertialUnit(builder);
  for (const std::string& limb : limbsOf(model, measured)) {
    const std::vector<Joint> joints = jointsOf(model, limb, measured);
    if (isLeg(limb)) builder.add(kSide, limb, joints);
    builder.addJoints(isLeg(limb) ? kLegJoint : kArmJoint, joints);
    if (isLeg(limb)) builder.lookAtZeros(joints);
    if (isLeg(limb)) builder.addJoints(kHull, hulled(model, joints));
    builder.endLimb();
  }
  return builder.take();
}

std::vector<PlacedCause> limbCauses(const RobotModel& model, const std::string& limb,
                                    const std::vector<Joint>& measured) {
  Builder builder(model, measured);
  const std::vector<Joint> joints = jointsOf(model, limb, measured);
  addBaseParameters(builder, limb, joints);
  builder.addJoints(kHull, hulled(model, joints));
  builder.addJoints(kStops, joints);
  builder.addJoints(kLegJoint, joints);
  builder.add({"kp_error", "coulomb_friction", "torque_limit", "command_latency", "command_hold",
               "command_filter", "rate_limit"},
              limb, joints);
  builder.addSpread({"kd_error", "motor_inertia", "link_mass"}, joints);
  builder.addSpread({"link_mass"}, turnedAlong(model, joints));
  return builder.take();
}

}  // namespace nao::validation
