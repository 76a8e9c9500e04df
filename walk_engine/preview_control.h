#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/archive.h"

namespace nao::walk {

/// Moves the centre of mass of a linear inverted pendulum so that the zero moment point follows a
/// reference known some way ahead. One axis; the state is the caller's. The law is
///   u = -Gi sum(p - p_ref) - Gx x - sum_j Gp_j p_ref(k + j),   p = x - (z / g) a,
/// the optimum of sum(Qe (p - p_ref)^2 + R u^2) over the jerk u with integral action (Kajita et
/// al., "Biped walking pattern generation by using preview control of zero-moment point", 2003).
/// Immutable after construction, which solves the Riccati equation by iteration.
class PreviewControl {
 public:
  struct State {
    double position = 0;      // [m]
    double velocity = 0;      // [m/s]
    double acceleration = 0;  // [m/s^2]
    double error_sum = 0;     // [m] of p - p_ref over the steps so far

    void archive(Archive& archive) { archive.value(*this); }
  };

  /// `com_height` [m] and `gravity` [m/s^2] of the pendulum, `dt` [s] between steps, `samples` of
  /// reference looked ahead.
  PreviewControl(double com_height, double gravity, double dt, int samples);

  int samples() const { return static_cast<int>(preview_gain_.size()); }
  double dt() const { return dt_; }
  double calcZmp(const State& state) const;  // [m]

  /// One step of `dt`. `zmp[0]` is the reference of now, `zmp[j]` that in j steps; samples() + 1
  /// of them.
  void step(const std::vector<double>& zmp, State& state) const;

 private:
  double dt_;
  double height_over_gravity_;
  double integral_gain_ = 0;
  Eigen::RowVector3d state_gain_ = Eigen::RowVector3d::Zero();
  std::vector<double> preview_gain_;
};

}  // namespace nao::walk
