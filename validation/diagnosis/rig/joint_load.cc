#include "validation/diagnosis/rig/joint_load.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "sim/hinge_run.h"
#include "validation/diagnosis/rig/inverse_dynamics.h"
#include "validation/diagnosis/rig/smooth_motion.h"
#include "validation/diagnosis/rig/yielding_inertia.h"

namespace nao::validation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<double> listOf(const VectorXd& column) {
  return {column.data(), column.data() + column.size()};
}

// Adds to the simulated motion what was measured beside it. Joints that nobody measured move as
// they are simulated: they did not rest while their neighbours pulled at them.
void correct(const RobotModel& model, const MeasuredMotion& measured,
             const std::vector<double>& delays, const LoadOptions& options,
             sim::HingeMotion& motion, MatrixXd& acceleration) {
  for (Index j = 0; j < measured.angle.cols(); ++j) {
    const std::vector<int>& hinges = model.actuators[static_cast<std::size_t>(j)].coordinates;
    const auto joint = static_cast<std::size_t>(j);
    const bool unknown = !measured.assumed.empty() && measured.assumed[joint];
    if (hinges.empty() || unknown) continue;
    const VectorXd beside = measured.angle.col(j) - motion.reported.col(j);
    const SmoothMotion smooth =
        smoothed(listOf(beside), measured.dt, options.bandwidth, delays[joint]);
    for (const int c : hinges) {
      motion.q.col(c) += spreadOut(smooth.angle, options.per_row);
      motion.u.col(c) += spreadOut(smooth.rate, options.per_row);
      acceleration.col(c) += spreadOut(smooth.acceleration, options.per_row);
    }
  }
}

MatrixXd accelerationsOf(const sim::HingeMotion& motion) {
  MatrixXd acceleration = MatrixXd::Zero(motion.u.rows(), motion.u.cols());
  for (Index i = 1; i + 1 < motion.u.rows(); ++i) {
    acceleration.row(i) = (motion.u.row(i + 1) - motion.u.row(i - 1)) / (2 * motion.dt);
  }
  return acceleration;
}

}  // namespace

VectorXd spreadOut(const std::vector<double>& rows, int per_row) {
  const auto last = static_cast<Index>(rows.size()) - 1;
  VectorXd values(last * per_row + 1);
  for (Index i = 0; i < values.size(); ++i) {
    const Index k = std::min(i / per_row, std::max<Index>(0, last - 1));
    const double part = static_cast<double>(i - k * per_row) / per_row;
    const double next = rows[static_cast<std::size_t>(std::min(k + 1, last))];
    const double here = rows[static_cast<std::size_t>(k)];
    values[i] = here + part * (next - here);
  }
  return values;
}

LimbMotion calcLimbMotion(const RobotModel& model, const std::vector<EffectSetting>& effects,
                          const std::vector<JointCommand>& orders, const MeasuredMotion& measured,
                          const LoadOptions& options, const sim::EffectCatalogue& catalogue) {
  sim::HingeMotion motion = sim::runHinges(
      model, effects, orders,
      {options.settle, options.step, options.per_row, options.seed, 0, options.inertia_every},
      catalogue);
  MatrixXd acceleration = accelerationsOf(motion);
  correct(model, measured, reportDelays(model, effects, catalogue), options, motion, acceleration);
  return {motion.dt, std::move(motion.q), std::move(motion.u), std::move(acceleration)};
}

sim::JointLoad loadAlong(const LimbMotion& motion, const RobotModel& model,
                         const std::vector<EffectSetting>& effects, Joint joint,
                         const LoadOptions& options, const sim::EffectCatalogue& catalogue) {
  const sim::BodyPlan plan = planOf(model, effects, catalogue);
  InverseDynamics dynamics(plan);
  const int own = model.actuators[index(joint)].coordinates.at(0);
  const Index values = motion.q.rows();
  VectorXd inertia(values), torque(values);
  std::vector<double> slope;
  for (Index i = 0; i < values; ++i) {
    const VectorXd q = motion.q.row(i), u = motion.u.row(i), a = motion.acceleration.row(i);
    dynamics.move(q, u);
    inertia[i] = dynamics.inertia(joint);
    torque[i] = dynamics.share(joint, dynamics.torque(a)) - inertia[i] * a[own];
    if (i % options.per_row == 0) slope.push_back(dynamics.slope(joint, q, u));
  }
  moveYieldToInertia(motion.dt, motion.acceleration.col(own), torque, inertia);
  sim::JointLoad load;
  load.per_row = options.per_row;
  load.inertia = listOf(inertia);
  load.torque = listOf(torque);
  load.reference = listOf(motion.q.col(own));
  load.slope = listOf(spreadOut(slope, options.per_row));
  for (const Joint other : options.others) {
    const Actuator& motor = model.actuators[index(other)];
    load.others[motor.name] = listOf(motion.q.col(motor.coordinates.at(0)));
  }
  return load;
}

sim::JointLoad calcJointLoad(const RobotModel& model, const std::vector<EffectSetting>& effects,
                             const std::vector<JointCommand>& orders,
                             const MeasuredMotion& measured, Joint joint,
                             const LoadOptions& options, const sim::EffectCatalogue& catalogue) {
  return loadAlong(calcLimbMotion(model, effects, orders, measured, options, catalogue), model,
                   effects, joint, options, catalogue);
}

}  // namespace nao::validation
