#include "tests/hidden/hideout.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/check.h"
#include "core/random.h"
#include "tests/hidden/laws/laws.h"
#include "validation/merge_effects.h"

namespace nao::hidden {
namespace {

// Deviations below count for nobody: the effect's own size of interest, with a margin so that a
// right estimate with its interval lies outside.
constexpr double kMargin = 1.5;

Hideout way(const std::string& cause, const std::string& law, const std::string& parameter,
            double start, double most) {
  Hideout hideout;
  hideout.cause = cause;
  hideout.law = law;
  hideout.parameter = parameter;
  hideout.start = start;
  hideout.most = most;
  return hideout;
}

Hideout own(const std::string& effect, const std::string& parameter, double start, double most) {
  return way(effect, effect, parameter, start, most);
}
Hideout part(const std::string& effect, const std::string& parameter, double start, double most) {
  return way(effect + "." + parameter, effect, parameter, start, most);
}

Hideout everywhere(Hideout hideout) {
  hideout.whole_robot = true;
  return hideout;
}
Hideout from(double neutral, Hideout hideout) {
  hideout.neutral = neutral;
  return hideout;
}
Hideout atLeast(double least, Hideout hideout) {
  hideout.least = least;
  return hideout;
}
Hideout inverse(Hideout hideout) {
  hideout.inverse = true;
  return atLeast(0.03, hideout);  // [s/rad] as a limit of 33 rad/s: no motor of a Nao is faster
}
Hideout shaped(std::map<std::string, double> shape, Hideout hideout) {
  hideout.shape = std::move(shape);
  return hideout;
}
Hideout only(const std::string& joints, Hideout hideout) {
  hideout.needs = joints;
  return hideout;
}
Hideout otherNumber(Hideout hideout) {
  hideout.comparable = false;
  return hideout;
}

Hideout at(std::vector<std::string> places, Hideout hideout) {
  hideout.places = std::move(places);
  return hideout;
}

// Of sensors that nothing else shows.
Hideout read(Hideout hideout, std::vector<std::string> columns) {
  hideout.columns = std::move(columns);
  return hideout;
}
Hideout readByBoard(const Hideout& hideout) {
  return read(hideout, {"imu.acc.x", "imu.acc.y", "imu.acc.z", "imu.gyr.x", "imu.gyr.y"});
}

Hideout stranger(const std::string& law, double start, double most,
                 std::vector<std::string> features, std::map<std::string, double> shape = {}) {
  Hideout hideout = way("", law, "size", start, most);
  hideout.features = std::move(features);
  hideout.shape = std::move(shape);
  return hideout;
}

// "voltage_sag" of "voltage_sag.drop".
std::string effectOf(const std::string& cause) { return cause.substr(0, cause.find('.')); }

double smallestOf(const Hideout& hideout) {
  const sim::EffectType* type = sim::standardEffects().find(effectOf(hideout.cause));
  if (type == nullptr) return 0;
  for (const sim::Parameter& parameter : type->parameters) {
    if (parameter.name == hideout.parameter) return kMargin * parameter.smallest;
  }
  return kMargin * type->parameters.front().smallest;  // of a law that calls its number otherwise
}

// Leaves out what this version of the simulator does not have.
std::vector<Hideout> known(std::vector<Hideout> all) {
  const auto missing = [](const Hideout& hideout) {
    const bool law = hiddenEffects().find(hideout.law) != nullptr;
    const bool cause =
        hideout.cause.empty() || sim::standardEffects().find(effectOf(hideout.cause)) != nullptr;
    return !law || !cause;
  };
  all.erase(std::remove_if(all.begin(), all.end(), missing), all.end());
  for (Hideout& hideout : all) {
    if (hideout.least == 0) hideout.least = smallestOf(hideout);
  }
  return all;
}

}  // namespace

std::vector<Hideout> catalogueHideouts() {
  return known({
      own("coulomb_friction", "torque", 0.1, 3),
      own("viscous_friction", "coefficient", 0.1, 5),
      shaped({{"speed", 0.2}}, own("stribeck_friction", "torque", 0.2, 3)),
      own("load_friction", "share", 0.2, 0.85),
      own("friction_asymmetry", "torque", 0.15, 3),
      own("friction_asymmetry", "torque", -0.15, -3),
      own("torque_bias", "torque", 0.15, 3),
      own("torque_bias", "torque", -0.15, -3),
      from(1, own("torque_limit", "part", -0.4, -0.97)),
      everywhere(part("voltage_sag", "drop", 0.25, 0.85)),
      everywhere(atLeast(0.01, part("voltage_sag", "slope", 0.05, 0.1))),  // 3 % on the mean of 6 s
      shaped({{"time", 3}}, own("thermal_derating", "part", 0.6, 1)),
      own("kp_error", "part", 0.3, 3),
      own("kp_error", "part", -0.3, -0.9),
      own("kd_error", "part", 0.5, 9),
      own("kd_error", "part", -0.4, -0.9),
      own("integral_gain", "gain", 10, 100),
      own("servo_deadband", "width", 0.01, 0.1),
      own("duty_root", "part", 0.5, 1),
      own("motor_inertia", "part", 0.5, 8),
      own("backlash", "width", 0.02, 0.2),
      own("gear_compliance", "compliance", 0.005, 0.5),
      own("cable_spring", "stiffness", 0.4, 10),
      shaped({{"per_turn", 8}}, own("cogging", "torque", 0.2, 3)),
      part("joint_stop", "upper", -0.2, -1.5),
      part("joint_stop", "lower", 0.2, 1.5),
      only("AnkleRoll", part("coupled_stop", "upper", -0.1, -1)),
      only("AnkleRoll", part("coupled_stop", "lower", 0.1, 1)),
      own("encoder_offset", "angle", 0.012, 0.2),
      own("encoder_offset", "angle", -0.012, -0.2),
      own("link_mass", "part", 0.3, 5),
      part("link_com", "x", 0.02, 0.2),
      part("link_com", "y", 0.02, 0.2),
      part("link_com", "z", 0.02, 0.2),
      everywhere(from(1, own("gravity_scale", "scale", 0.3, 3))),
      everywhere(part("ground_tilt", "x", 0.1, 0.55)),
      everywhere(part("ground_tilt", "y", 0.1, 0.55)),
      everywhere(own("command_latency", "delay", 0.01, 0.2)),
      own("command_latency", "delay", 0.01, 0.2),
      everywhere(own("sensor_delay", "delay", 0.01, 0.2)),
      everywhere(own("command_hold", "interval", 0.04, 0.5)),
      everywhere(own("command_filter", "time", 0.02, 0.5)),
      own("command_filter", "time", 0.02, 0.5),
      inverse(own("rate_limit", "rate", 0.3, 5)),
      own("encoder_quantum", "quantum", 0.015, 0.1),
  });
}

std::vector<Hideout> likenessHideouts() {
  return known({
      way("coulomb_friction", "hidden_smooth_coulomb", "torque", 0.1, 3),
      way("viscous_friction", "hidden_viscous_with_square", "coefficient", 0.1, 5),
      shaped({{"speed", 0.2}},
             otherNumber(way("stribeck_friction", "hidden_lorentz_stribeck", "torque", 0.2, 3))),
      otherNumber(way("load_friction", "hidden_motor_load_friction", "share", 0.2, 0.85)),
      way("friction_asymmetry", "hidden_smooth_asymmetry", "torque", 0.15, 3),
      way("friction_asymmetry", "hidden_smooth_asymmetry", "torque", -0.15, -3),
      otherNumber(way("backlash", "hidden_soft_play", "width", 0.02, 0.2)),
      way("gear_compliance", "hidden_dry_compliance", "compliance", 0.005, 0.5),
      way("encoder_offset", "hidden_shifted_encoder", "angle", 0.012, 0.2),
      way("encoder_offset", "hidden_shifted_encoder", "angle", -0.012, -0.2),
      way("link_mass", "hidden_dense_core", "part", 0.3, 5),
      otherNumber(way("link_mass", "hidden_tied_ball", "mass", 0.1, 3)),
      everywhere(way("command_latency", "hidden_message_latency", "delay", 0.01, 0.2)),
      way("command_latency", "hidden_message_latency", "delay", 0.01, 0.2),
      everywhere(way("command_hold", "hidden_clocked_hold", "interval", 0.04, 0.5)),
      everywhere(way("sensor_delay", "hidden_late_reading", "delay", 0.01, 0.2)),
      everywhere(way("command_filter", "hidden_two_pole_filter", "time", 0.02, 0.5)),
      inverse(way("rate_limit", "hidden_eased_rate_limit", "rate", 0.3, 5)),
      otherNumber(way("servo_deadband", "hidden_smooth_deadband", "width", 0.01, 0.1)),
      everywhere(otherNumber(way("voltage_sag.drop", "hidden_resistive_sag", "drop", 0.25, 0.75))),
  });
}

std::vector<Hideout> strangerHideouts() {
  const std::vector<std::string> by_place{"sgn v", "q sgn v", "sgn v with sin and cos of",
                                          "sgn v near q ="};
  return known({
      stranger("hidden_rough_patch", 0.15, 3, by_place),
      stranger("hidden_quadratic_drag", 0.05, 5, {"v|v|"}),
      stranger("hidden_periodic_torque", 0.15, 3, {"1.6 Hz", "1.7 Hz", "1.8 Hz"}),
      stranger("hidden_sticky_spot", 0.5, 5, by_place),
      stranger("hidden_detent", 0.3, 5, {"q", "sin and cos of"}),
      stranger("hidden_torque_step", 0.2, 3, {"t", "1"}),
      stranger("hidden_hardening_spring", 1, 30, {"q", "sin and cos of"}),
      stranger("hidden_speed_band", 0.3, 5, {"sgn v", "v", "v|v|", "sgn v near |v| ="}),
      stranger("hidden_pulsing_friction", 0.3, 5, {"sgn v", "sgn v with sin and cos of 0.5 Hz"}),
      stranger("hidden_one_sided_gain", 0.4, 5, {"e", "|e|"}),
      stranger("hidden_drifting_gain", 0.15, 5, {"t e"}),
      stranger("hidden_command_hysteresis", 0.03, 0.4, {"sgn v"}),
      stranger("hidden_eccentric_encoder", 0.03, 0.25, {"misreading by sin and cos of"}),
  });
}

std::vector<Hideout> limbHideouts() {
  const std::vector<std::string> limb{"LLeg"}, ankle{"LAnkleRoll"}, shared{"LHipYawPitch"};
  return known({
      at(ankle, shaped({{"place", -0.3}}, part("coupled_stop", "upper", -0.5, -5))),
      at(ankle, shaped({{"place", -0.3}}, part("coupled_stop", "lower", -0.5, -5))),
      at(limb, own("link_mass", "part", 0.2, 3)),
      at(limb, way("link_mass", "hidden_dense_core", "part", 0.3, 5)),
      at(limb, part("link_com", "x", 0.01, 0.1)),
      at(limb, part("link_com", "x", -0.01, -0.1)),
      at(limb, part("link_com", "y", 0.01, 0.1)),
      at(limb, own("command_latency", "delay", 0.01, 0.2)),
      at(limb, from(1, own("torque_limit", "part", -0.4, -0.97))),
      at(shared, way("backlash", "hidden_soft_play", "width", 0.04, 0.3)),
      at(shared, way("coulomb_friction", "hidden_smooth_coulomb", "torque", 0.1, 3)),
      at(shared, own("kp_error", "part", -0.3, -0.9)),
      at({"LKneePitch", "LHipPitch"}, own("kp_error", "part", -0.3, -0.9)),
      at({"LAnklePitch", "LHipRoll"},
         way("encoder_offset", "hidden_shifted_encoder", "angle", 0.012, 0.2)),
  });
}

std::vector<Hideout> robotHideouts() {
  const std::vector<std::string> robot{"robot"}, pitches{"LKneePitch", "RHipPitch", "RAnklePitch"},
      rolls{"LHipRoll", "RAnkleRoll"};
  const auto all = [&](const Hideout& hideout) { return at(robot, everywhere(hideout)); };
  return known({
      all(from(1, own("ground_friction", "scale", -0.7, -0.97))),
      all(part("ground_tilt", "x", 0.03, 0.15)),
      all(part("ground_tilt", "y", -0.03, -0.15)),
      all(own("payload", "mass", 0.3, 2)),
      all(own("command_latency", "delay", 0.02, 0.2)),
      all(way("command_latency", "hidden_message_latency", "delay", 0.02, 0.2)),
      all(way("command_hold", "hidden_clocked_hold", "interval", 0.06, 0.3)),
      all(way("coulomb_friction", "hidden_smooth_coulomb", "torque", 0.3, 3)),
      all(part("voltage_sag", "drop", 0.3, 0.85)),
      at(pitches, from(1, own("torque_limit", "part", -0.6, -0.97))),
      at(pitches, own("kp_error", "part", -0.3, -0.9)),
      at(rolls, own("kp_error", "part", -0.3, -0.9)),
      at(pitches, way("encoder_offset", "hidden_shifted_encoder", "angle", 0.03, 0.2)),
      at(rolls, way("encoder_offset", "hidden_shifted_encoder", "angle", -0.03, -0.2)),
      at({"LLeg", "RLeg"}, own("kp_error", "part", -0.3, -0.9)),
      at({"LLeg", "RLeg"}, own("command_latency", "delay", 0.02, 0.2)),
      all(readByBoard(part("imu_bias", "acc_y", 0.2, 3))),
      all(readByBoard(part("imu_bias", "gyro_y", -0.02, -0.5))),
      all(readByBoard(part("imu_scale", "gyro", 0.1, 1))),
      all(readByBoard(way("imu_misalignment.y", "hidden_turned_board", "y", 0.05, 0.5))),
      all(readByBoard(otherNumber(way("imu_low_pass", "hidden_averaging_board", "time", 0.1, 1)))),
  });
}

Hideout hullHideout() {
  return at({"RAnkleRoll"},
            otherNumber(way("coupled_stop.upper", "hidden_ankle_hull", "inset", 0, 0)));
}

std::vector<Hideout> mujocoHideouts() {
  std::vector<Hideout> all{
      way("coulomb_friction", "mujoco_friction_loss", "torque", 0.1, 3),
      way("viscous_friction", "mujoco_damping", "coefficient", 0.1, 5),
      way("motor_inertia", "mujoco_armature", "part", 0.5, 8),
      way("joint_stop.upper", "mujoco_range", "upper", -0.2, -1.5),
      way("joint_stop.lower", "mujoco_range", "lower", 0.2, 1.5),
      way("command_latency", "mujoco_delay", "delay", 0.01, 0.2),
      everywhere(way("command_latency", "mujoco_delay", "delay", 0.01, 0.2)),
      everywhere(way("sensor_delay", "mujoco_late_report", "delay", 0.01, 0.2)),
      way("command_filter", "mujoco_filter", "time", 0.02, 0.5),
      way("kp_error", "mujoco_gain", "part", 0.3, 3),
      way("kp_error", "mujoco_gain", "part", -0.3, -0.9),
      way("kd_error", "mujoco_derivative", "part", 0.5, 9),
      way("torque_limit", "mujoco_weakness", "part", -0.4, -0.97),
      way("backlash", "mujoco_play", "width", 0.02, 0.2),
      way("encoder_offset", "mujoco_turned_encoder", "angle", 0.012, 0.2),
      way("encoder_offset", "mujoco_turned_encoder", "angle", -0.012, -0.2),
      way("cable_spring", "mujoco_spring", "stiffness", 0.4, 10),
      way("torque_bias", "mujoco_bias", "torque", -0.15, -3),
      way("link_mass", "mujoco_mass", "part", 0.3, 5),
      everywhere(way("gravity_scale", "mujoco_gravity", "part", 0.3, 3)),
      everywhere(way("ground_tilt.x", "mujoco_tilt", "x", 0.1, 0.55)),
      everywhere(way("ground_tilt.y", "mujoco_tilt", "y", 0.1, 0.55)),
  };
  for (Hideout& hideout : all) {
    hideout.least = smallestOf(hideout);
    hideout.comparable = false;
  }
  return all;
}

EffectSetting settingAt(const Hideout& hideout, double deviation, const RobotModel& model,
                        const std::string& joint) {
  // What a law has beside the hidden number does nothing; left out it would be switched on.
  const bool ours = hiddenEffects().find(hideout.law) != nullptr;
  EffectSetting setting = ours ? validation::neutralSetting(hideout.law, hiddenEffects())
                               : EffectSetting{hideout.law, {}, {}, ""};
  for (const auto& [name, value] : hideout.shape) setting.parameters[name] = value;
  setting.parameters[hideout.parameter] =
      hideout.inverse ? 1 / std::max(1e-4, deviation) : hideout.neutral + deviation;
  const auto limb = model.groups.find(joint);
  if (!hideout.whole_robot && limb != model.groups.end()) {
    for (const std::string& name : limb->second) {
      if (const auto one = model.findJoint(name)) setting.joints.push_back(*one);
    }
  } else if (!hideout.whole_robot) {
    const auto found = model.findJoint(joint);
    NAO_CHECK(found.has_value());
    setting.joints = {*found};
  }
  return setting;
}

std::string drawnPlace(const Hideout& hideout, std::uint64_t seed) {
  NAO_CHECK(!hideout.places.empty());
  const double at = Random(seed, "place").uniform() * static_cast<double>(hideout.places.size());
  return hideout.places[static_cast<std::size_t>(at)];
}

bool looksAlike(const std::string& cause, const std::string& other) {
  // A late command and a late report shift angles and currents alike.
  static const std::vector<std::set<std::string>> kFamilies{{"command_latency", "sensor_delay"}};
  if (cause == other) return true;
  return std::any_of(kFamilies.begin(), kFamilies.end(), [&](const std::set<std::string>& family) {
    return family.count(cause) > 0 && family.count(other) > 0;
  });
}

}  // namespace nao::hidden
