#include "validation/suspended.h"

#include <algorithm>
#include <map>

#include "core/check.h"
#include "validation/stiff_limb.h"

namespace nao::validation {
namespace {

// The limb of each body: the child of the root that it hangs on; 0 for the root.
std::vector<std::size_t> limbsOf(const RobotModel& model) {
  std::vector<std::size_t> limb(model.bodies.size());
  for (std::size_t b = 1; b < model.bodies.size(); ++b) {
    const auto parent = static_cast<std::size_t>(model.bodies[b].parent);
    limb[b] = parent == 0 ? b : limb[parent];
  }
  return limb;
}

std::vector<bool> keptLimbs(const RobotModel& model, const std::vector<std::size_t>& limb,
                            const std::vector<std::string>& names) {
  std::vector<bool> kept(model.bodies.size());
  for (const std::string& name : names) {
    const auto joint = model.findJoint(name);
    if (!joint) throw InputError("expected a joint of " + model.name + ", found '" + name + "'");
    for (const int c : model.actuators[index(*joint)].coordinates) {
      kept[limb[static_cast<std::size_t>(c) + 1]] = true;
    }
  }
  return kept;
}

// And those with which they share motors.
std::vector<bool> withSharers(const RobotModel& model, const std::vector<std::size_t>& limb,
                              std::vector<bool> kept) {
  for (bool grown = true; grown;) {
    grown = false;
    for (const Actuator& motor : model.actuators) {
      const auto& hinges = motor.coordinates;
      const auto holds = [&](int c) -> bool { return kept[limb[static_cast<std::size_t>(c) + 1]]; };
      if (!std::any_of(hinges.begin(), hinges.end(), holds)) continue;
      for (const int c : hinges) {
        grown = grown || !holds(c);
        kept[limb[static_cast<std::size_t>(c) + 1]] = true;
      }
    }
  }
  return kept;
}

// Hinges of a limb that is kept for its motor's sake. What a thigh in full swing does to the other
// leg, hip and knee give way to: stiff from the hip on it would cost 0.2 mrad and 0.012 A of the
// swinging hip, from the knee on a third of the current; with all six nothing but processor time.
constexpr int kGiving = 4;

struct Kept {
  std::vector<bool> whole;  // limbs
  std::vector<bool> stiff;  // limbs that end in one solid in a pose; none: empty
  JointArray<double> pose{};
};

class Cutter {
 public:
  Cutter(const RobotModel& model, const Kept& kept) : model_(model) {
    keepBodies(kept, limbsOf(model));
    keepMotors();
    keepEffects(model.effects, cut_.effects);
    keepEffects(model.variation, cut_.variation);
    keepEffects(model.noise, cut_.noise);
    cut_.start_sd = model.start_sd;
    keepLimits();
    keepPostures();
  }

  RobotModel take() { return std::move(cut_); }

 private:
  // From the torso.
  int hingesTo(std::size_t b) const {
    const int parent = model_.bodies[b].parent;
    return parent < 0 ? 0 : 1 + hingesTo(static_cast<std::size_t>(parent));
  }

  void keepBodies(const Kept& kept, const std::vector<std::size_t>& limb) {
    cut_.name = model_.name;
    cut_.body_type = model_.body_type;
    cut_.version = model_.version;
    cut_.cycle = model_.cycle;
    cut_.fixed_base = true;
    cut_.battery = model_.battery;
    cut_.gyro_axes = model_.gyro_axes;
    cut_.p_BoImu = model_.p_BoImu;
    cut_.aliases = model_.aliases;
    bodies_[0] = 0;
    cut_.bodies.push_back(model_.bodies[0]);
    for (std::size_t b = 1; b < model_.bodies.size(); ++b) {
      const int beyond = kept.stiff.empty() || !kept.stiff[limb[b]] ? 1 : hingesTo(b) - kGiving;
      if (!kept.whole[limb[b]] && beyond > 0) continue;
      const bool stiff = beyond == 0;
      bodies_[static_cast<int>(b)] = static_cast<int>(cut_.bodies.size());
      cut_.bodies.push_back(stiff ? stiffened(model_, b, kept.pose) : model_.bodies[b]);
      cut_.bodies.back().parent = bodies_.at(model_.bodies[b].parent);
      cut_.coordinates.push_back(model_.coordinates[b - 1]);
    }
  }

  void keepMotors() {
    for (std::size_t j = 0; j < model_.jointCount(); ++j) {
      Actuator motor = model_.actuators[j];
      std::vector<int> hinges;
      for (const int c : motor.coordinates) {
        if (bodies_.count(c + 1) > 0) hinges.push_back(bodies_.at(c + 1) - 1);
      }
      if (hinges.empty()) continue;
      motor.coordinates = hinges;
      joints_[toJoint(j)] = toJoint(cut_.actuators.size());
      cut_.actuators.push_back(std::move(motor));
    }
    for (Coordinate& c : cut_.coordinates) c.joint = joints_.at(c.joint);
  }

  void keepEffects(const std::vector<EffectSetting>& from, std::vector<EffectSetting>& to) {
    for (EffectSetting setting : from) {
      const bool all = setting.joints.empty();
      std::vector<Joint> kept;
      for (const Joint j : setting.joints) {
        if (joints_.count(j) > 0) kept.push_back(joints_.at(j));
      }
      setting.joints = std::move(kept);
      if (all || !setting.joints.empty()) to.push_back(std::move(setting));
    }
  }

  void keepLimits() {
    for (CoupledLimit limit : model_.coupled_limits) {
      if (joints_.count(limit.driver) == 0 || joints_.count(limit.limited) == 0) continue;
      limit.driver = joints_.at(limit.driver);
      limit.limited = joints_.at(limit.limited);
      cut_.coupled_limits.push_back(std::move(limit));
    }
  }

  void keepPostures() {
    cut_.start_posture = model_.start_posture;
    for (const Posture& whole : model_.postures) {
      Posture posture{whole.name, whole.family, JointArray<double>(cut_.jointCount())};
      for (const auto& [from, to] : joints_) posture.angle[to] = whole.angle[from];
      cut_.postures.push_back(std::move(posture));
    }
  }

  const RobotModel& model_;
  RobotModel cut_;
  std::map<int, int> bodies_;  // of the whole robot -> of the cut one
  std::map<Joint, Joint> joints_;
};

}  // namespace

RobotModel stripped(const RobotModel& model) {
  RobotModel bare = model;
  bare.feet.clear();
  bare.contact_spheres.clear();
  bare.no_collision.clear();
  for (Body& body : bare.bodies) {
    body.collisions.clear();
    body.visuals.clear();
  }
  return bare;
}

RobotModel cutLimbs(const RobotModel& model, const std::vector<std::string>& joints) {
  if (!model.fixed_base) {
    throw InputError("limbs can be cut from a robot with a fixed base only: suspend " + model.name);
  }
  const std::vector<std::size_t> limb = limbsOf(model);
  return Cutter(model, {withSharers(model, limb, keptLimbs(model, limb, joints)), {}}).take();
}

RobotModel cutLimbOf(const RobotModel& model, const std::string& joint,
                     const JointArray<double>& pose) {
  if (!model.fixed_base) return cutLimbs(model, {joint});  // says what is wrong
  const std::vector<std::size_t> limb = limbsOf(model);
  const std::vector<bool> whole = keptLimbs(model, limb, {joint});
  std::vector<bool> stiff = withSharers(model, limb, whole);
  for (std::size_t b = 0; b < stiff.size(); ++b) stiff[b] = stiff[b] && !whole[b];
  return Cutter(model, {whole, stiff, pose}).take();
}

}  // namespace nao::validation
