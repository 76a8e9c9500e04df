#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/robot_model.h"

namespace nao::sim {

/// Hinges of one motor move alike: a Nao's two HipYawPitch, the phalanges of a hand. The impulses
/// between them that make it so are found by one more solve per tie with the factors at hand;
/// each tie's answer is freed of the ties before it, so that all hold at once.
class HingeTies {
 public:
  HingeTies(const RobotModel& model, int root_speeds) {
    for (const Actuator& actuator : model.actuators) {
      for (std::size_t i = 1; i < actuator.coordinates.size(); ++i) {
        const int first = root_speeds + actuator.coordinates.front();
        ties_.push_back({first, root_speeds + actuator.coordinates[i], {}, 0});
      }
    }
  }

  /// Changes `x`, the solution of A x = f, so that x[a] - x[b] = wanted(a, b) for every two tied
  /// speeds; `solve` puts the solution y of A y = c into c.
  template <class Solve, class Wanted>
  void hold(const Solve& solve, const Wanted& wanted, Eigen::VectorXd& x) {
    for (std::size_t k = 0; k < ties_.size(); ++k) {
      Tie& tie = ties_[k];
      tie.answer.setZero(x.size());
      tie.answer[tie.a] = 1;
      tie.answer[tie.b] = -1;
      solve(tie.answer);
      for (std::size_t j = 0; j < k; ++j) {
        const Tie& held = ties_[j];
        tie.answer -= gapOf(held, tie.answer) / held.give * held.answer;
      }
      tie.give = gapOf(tie, tie.answer);
      x -= (gapOf(tie, x) - wanted(tie.a, tie.b)) / tie.give * tie.answer;
    }
  }

 private:
  struct Tie {
    int a, b;                // speeds
    Eigen::VectorXd answer;  // to a unit impulse between the two
    double give;             // how far they part under it
  };
  static double gapOf(const Tie& tie, const Eigen::VectorXd& x) { return x[tie.a] - x[tie.b]; }

  std::vector<Tie> ties_;
};

}  // namespace nao::sim
