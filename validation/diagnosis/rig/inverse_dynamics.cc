#include "validation/diagnosis/rig/inverse_dynamics.h"

#include <algorithm>

#include "core/world_model.h"

namespace nao::validation {
namespace {

using Eigen::VectorXd;

constexpr double kTurn = 1e-3;  // [rad] to either side, for the slope; gravity is smooth

bool actsOn(const EffectSetting& effect, std::size_t joint) {
  const auto& joints = effect.joints;
  return joints.empty() || std::find(joints.begin(), joints.end(), toJoint(joint)) != joints.end();
}

}  // namespace

sim::BodyPlan planOf(const RobotModel& model, const std::vector<EffectSetting>& effects,
                     const sim::EffectCatalogue& catalogue) {
  sim::EffectChain chain(catalogue, effects, model, model.cycle, 1, model.name);
  sim::BodyPlan plan(model, WorldModel());
  chain.alterPlan(plan);
  return plan;
}

std::vector<double> reportDelays(const RobotModel& model, const std::vector<EffectSetting>& effects,
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
      if (actsOn(effect, j)) delay[j] += by;
    }
  }
  return delay;
}

InverseDynamics::InverseDynamics(const sim::BodyPlan& plan)
    : plan_(plan), dynamics_(plan.model), inertia_(dynamics_.parents()) {
  NAO_CHECK(plan.model.fixed_base);
  dynamics_.setDamping(plan.linear_damping, plan.angular_damping);
}

void InverseDynamics::move(const VectorXd& q, const VectorXd& u) {
  dynamics_.setState({q, u});
  dynamics_.calcBias(plan_.gravity, bias_);
  dynamics_.calcMassMatrix(inertia_);
}

VectorXd InverseDynamics::torque(const VectorXd& acceleration) const {
  VectorXd torque = bias_;
  for (int i = 0; i < inertia_.size(); ++i) {
    const int* chain = inertia_.chain(i);
    for (int d = 0; d < inertia_.depth(i); ++d) {
      const int j = chain[d];
      torque[i] += inertia_.at(i, j) * acceleration[j];
      if (j != i) torque[j] += inertia_.at(i, j) * acceleration[i];
    }
  }
  return torque;
}

bool InverseDynamics::related(int leaf, int other) const {
  const int* chain = inertia_.chain(leaf);
  const int* end = chain + inertia_.depth(leaf);
  return std::find(chain, end, other) != end;
}

double InverseDynamics::inertia(Joint joint) const {
  double sum = 0;
  for (const int a : hinges(joint)) {
    for (const int b : hinges(joint)) {
      const int leaf = std::max(a, b), other = std::min(a, b);
      if (related(leaf, other)) sum += inertia_.at(leaf, other);
    }
  }
  return sum;
}

double InverseDynamics::share(Joint joint, const VectorXd& torque) const {
  double sum = 0;
  for (const int c : hinges(joint)) sum += torque[c];
  return sum;
}

double InverseDynamics::slope(Joint joint, const VectorXd& q, const VectorXd& u) {
  return (biasBeside(joint, q, u, kTurn) - biasBeside(joint, q, u, -kTurn)) / (2 * kTurn);
}

double InverseDynamics::biasBeside(Joint joint, VectorXd q, const VectorXd& u, double angle) {
  for (const int c : hinges(joint)) q[c] += angle;
  dynamics_.setState({q, u});
  dynamics_.calcBias(plan_.gravity, bias_);
  return share(joint, bias_);
}

}  // namespace nao::validation
