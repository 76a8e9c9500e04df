#pragma once

#include <vector>

#include "core/robot_model.h"
#include "sim/tree_matrix.h"

namespace nao::sim {

/// The mechanical stops at the ends of every hinge's range, stiff springs that only push back.
/// A coupled limit narrows the range of one joint by the angle that another has at the start of
/// the step. Full torque of the strongest Nao motor (8.4 N m) presses a stop in by 0.03 degrees.
class JointStops {
 public:
  JointStops(const RobotModel& model, int root_speeds);

  /// Starts a step of `h` [s] from angles `q` and rates `u`, both by coordinate.
  void prepare(const double* q, const double* u, double h);

  /// Adds the torques of the stops that are reached within the step.
  void addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs) const;

  /// Adds the torques at this very state, without a step.
  void addSmooth(const double* q, const double* u, Eigen::VectorXd& torque);

  /// After a solve: lets go of stops that would pull, and meets those that are reached after all.
  /// True if any changed.
  bool revise(const Eigen::VectorXd& du);

 private:
  struct Touch {
    int speed;
    double side;  // +1 at the lower end, -1 at the upper: where the stop pushes
    double room;  // [rad] from where the rate leads, to the stop
    double now;   // [N m]
    bool active;
    int changes;  // of mind within one step
  };
  void approach(std::size_t coordinate, double side, double room, double u);
  void narrow(const CoupledLimit& limit, const double* q);

  const RobotModel& model_;
  int root_speeds_;
  double h_ = 0;
  std::vector<double> lower_, upper_;  // [rad] by coordinate, of this step
  std::vector<Touch> touches_;
};

}  // namespace nao::sim
