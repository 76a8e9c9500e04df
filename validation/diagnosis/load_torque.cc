#include "validation/diagnosis/load_torque.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "validation/diagnosis/inverse_dynamics.h"
#include "validation/diagnosis/smooth_motion.h"

namespace nao::validation {
namespace {

using Eigen::VectorXd;

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
  const Hinges hinges(plan, reportDelays(model, effects, catalogue), measured, bandwidth);
  InverseDynamics seen(plan);
  const double gain = measured.angle_sd.size() > 0 ? accelerationGain(measured.dt, bandwidth) : 0;
  LoadTorque found;
  found.load.reference = hinges.of(joint).angle;
  const auto rows = static_cast<std::size_t>(measured.angle.rows());
  for (std::size_t k = 0; k < rows; ++k) {
    const VectorXd q = hinges.angles(k), u = hinges.rates(k);
    seen.move(q, u);
    const VectorXd row = seen.coupling(joint);
    const double inertia = seen.share(joint, row);
    const double own = inertia * hinges.of(joint).acceleration[k];
    found.load.inertia.push_back(inertia);
    found.load.torque.push_back(row.dot(hinges.accelerations(k)) - own +
                                seen.share(joint, seen.bias()));
    found.load.slope.push_back(seen.slope(joint, q, u));
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
