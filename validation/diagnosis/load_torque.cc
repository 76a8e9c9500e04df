#include "validation/diagnosis/load_torque.h"

#include <algorithm>
#include <cmath>

#include "core/world_model.h"
#include "sim/tree_dynamics.h"
#include "validation/diagnosis/smooth_motion.h"

namespace nao::validation {
namespace {

using Eigen::VectorXd;

constexpr double kTurn = 1e-3;  // [rad] to either side, for the slope; gravity is smooth

sim::BodyPlan planOf(const RobotModel& model, const std::vector<EffectSetting>& effects,
                     const sim::EffectCatalogue& catalogue) {
  sim::EffectChain chain(catalogue, effects, model, model.cycle, 1, model.name);
  sim::BodyPlan plan(model, WorldModel());
  chain.alterPlan(plan);
  return plan;
}

// By how much later than it was measured each joint's angle is reported [s].
std::vector<double> delaysOf(const RobotModel& model, const std::vector<EffectSetting>& effects,
                             const sim::EffectCatalogue& catalogue) {
  std::vector<double> delay(model.jointCount());
  const sim::EffectType* type = catalogue.find("sensor_delay");
  if (type == nullptr) return delay;
  for (const EffectSetting& effect : effects) {
    if (effect.name != type->name) continue;
    const auto given = effect.parameters.find("delay");
    const double by =
        given == effect.parameters.end() ? type->parameters.front().nominal : given->second;
    for (std::size_t j = 0; j < delay.size(); ++j) {
      const bool acts =
          effect.joints.empty() ||
          std::find(effect.joints.begin(), effect.joints.end(), toJoint(j)) != effect.joints.end();
      if (acts) delay[j] += by;
    }
  }
  return delay;
}

// All hinges of a robot along a measured run.
class Hinges {
 public:
  Hinges(const sim::BodyPlan& plan, const std::vector<double>& delays,
         const MeasuredMotion& measured, double bandwidth) {
    const RobotModel& model = plan.model;
    for (std::size_t j = 0; j < model.jointCount(); ++j) {
      const VectorXd column = measured.angle.col(static_cast<Eigen::Index>(j));
      const std::vector<double> samples(column.data(), column.data() + column.size());
      joints_.push_back(model.actuators[j].coordinates.empty()
                            ? SmoothMotion()
                            : smoothed(samples, measured.dt, bandwidth, delays[j]));
      for (double& angle : joints_.back().angle) angle += plan.joint_zero[j];
    }
    for (const Coordinate& c : model.coordinates) joint_of_.push_back(index(c.joint));
  }

  const SmoothMotion& of(Joint joint) const { return joints_[index(joint)]; }
  /// Row `k` by coordinate.
  VectorXd angles(std::size_t k) const { return pick(&SmoothMotion::angle, k); }
  VectorXd rates(std::size_t k) const { return pick(&SmoothMotion::rate, k); }
  VectorXd accelerations(std::size_t k) const { return pick(&SmoothMotion::acceleration, k); }

 private:
  VectorXd pick(std::vector<double> SmoothMotion::*what, std::size_t k) const {
    VectorXd all(static_cast<Eigen::Index>(joint_of_.size()));
    for (std::size_t c = 0; c < joint_of_.size(); ++c) {
      all[static_cast<Eigen::Index>(c)] = (joints_[joint_of_[c]].*what)[k];
    }
    return all;
  }

  std::vector<SmoothMotion> joints_;
  std::vector<std::size_t> joint_of_;  // by coordinate
};

// Inverse dynamics seen from one motor: all its hinges turn as one.
class SeenFrom {
 public:
  SeenFrom(const sim::BodyPlan& plan, Joint joint)
      : dynamics_(plan.model),
        inertia_(dynamics_.parents()),
        gravity_(plan.gravity),
        own_(plan.model.actuators[index(joint)].coordinates) {
    dynamics_.setDamping(plan.linear_damping, plan.angular_damping);
  }

  void move(const VectorXd& q, const VectorXd& u) {
    dynamics_.setState({q, u});
    dynamics_.calcBias(gravity_, bias_);
    dynamics_.calcMassMatrix(inertia_);
  }

  double bias() const { return sumOf(bias_); }

  // The row of the mass matrix that belongs to the motor, by coordinate.
  VectorXd row() const {
    VectorXd row = VectorXd::Zero(inertia_.size());
    for (const int own : own_) {
      for (int i = 0; i < inertia_.size(); ++i) row[i] += entry(own, i);
    }
    return row;
  }

  double sumOf(const VectorXd& by_coordinate) const {
    double sum = 0;
    for (const int c : own_) sum += by_coordinate[c];
    return sum;
  }

  // The bias with the motor's hinges turned by `angle`.
  double biasBeside(VectorXd q, const VectorXd& u, double angle) {
    for (const int c : own_) q[c] += angle;
    dynamics_.setState({q, u});
    dynamics_.calcBias(gravity_, bias_);
    return bias();
  }

 private:
  // Two hinges of different limbs have no entry in common: the tree holds those of one chain only.
  double entry(int a, int b) const {
    const int leaf = std::max(a, b), other = std::min(a, b);
    const int* chain = inertia_.chain(leaf);
    const bool related =
        std::find(chain, chain + inertia_.depth(leaf), other) != chain + inertia_.depth(leaf);
    return related ? inertia_.at(leaf, other) : 0;
  }

  sim::TreeDynamics dynamics_;
  sim::TreeMatrix inertia_;
  double gravity_;
  const std::vector<int>& own_;
  VectorXd bias_;
};

// [rad/s^2] of the acceleration that smoothed() makes of samples of SD 1 rad.
double accelerationGain(double dt, double bandwidth) {
  std::vector<double> pulse(41);
  pulse[20] = 1;
  double squares = 0;
  for (const double a : smoothed(pulse, dt, bandwidth).acceleration) squares += a * a;
  return std::sqrt(squares);
}

}  // namespace

LoadTorque calcLoadTorque(const RobotModel& model, const std::vector<EffectSetting>& effects,
                          const MeasuredMotion& measured, Joint joint, double bandwidth,
                          const sim::EffectCatalogue& catalogue) {
  if (!model.fixed_base) throw InputError("load torques: expected a robot with a fixed base");
  const sim::BodyPlan plan = planOf(model, effects, catalogue);
  const Hinges hinges(plan, delaysOf(model, effects, catalogue), measured, bandwidth);
  SeenFrom seen(plan, joint);
  const double gain = measured.angle_sd.size() > 0 ? accelerationGain(measured.dt, bandwidth) : 0;
  LoadTorque found;
  found.load.reference = hinges.of(joint).angle;
  const auto rows = static_cast<std::size_t>(measured.angle.rows());
  for (std::size_t k = 0; k < rows; ++k) {
    const VectorXd q = hinges.angles(k), u = hinges.rates(k);
    seen.move(q, u);
    const VectorXd row = seen.row();
    const double inertia = seen.sumOf(row);
    const double own = inertia * hinges.of(joint).acceleration[k];
    found.load.inertia.push_back(inertia);
    found.load.torque.push_back(row.dot(hinges.accelerations(k)) - own + seen.bias());
    found.load.slope.push_back((seen.biasBeside(q, u, kTurn) - seen.biasBeside(q, u, -kTurn)) /
                               (2 * kTurn));
    double variance = 0;
    for (std::size_t c = 0; gain > 0 && c < model.coordinates.size(); ++c) {
      const Joint other = model.coordinates[c].joint;
      if (other == joint) continue;
      const double by = row[static_cast<Eigen::Index>(c)] * gain *
                        measured.angle_sd[static_cast<Eigen::Index>(index(other))];
      variance += by * by;
    }
    found.sd.push_back(std::sqrt(variance));
  }
  return found;
}

}  // namespace nao::validation
