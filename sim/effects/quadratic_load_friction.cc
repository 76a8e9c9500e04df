// Dry friction that grows with the square of what the gear carries: budget = coefficient T_load^2,
// T_load of the step before, at most 0.9 |T_load| (more would lock the gear for good). Source:
// teeth that bend share the load less evenly the more there is; a form of published servo models
// (Rhoban's BAM).
#include <algorithm>
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

constexpr double kMost = 0.9;  // as load_friction

class QuadraticLoadFriction final : public Effect {
 public:
  explicit QuadraticLoadFriction(const EffectSetup& setup)
      : joints_(setup.hinged()), coefficient_(setup.value("coefficient")) {}

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      const double load = std::abs(moment.load_torque[j]);
      const double budget = std::min(coefficient_ * load, kMost) * load;
      terms.resist_forward[j] += budget;
      terms.resist_backward[j] += budget;
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double coefficient_;  // [1/(N m)]
};

}  // namespace

EffectType quadraticLoadFriction() {
  return {"quadratic_load_friction",
          "Dry friction in proportion to the square of the torque that the gear carries.",
          {{"coefficient", "1/(N m)", 0.1, 0, 0, 50, 0.005}},
          Acts::OnDrive,
          makeEffect<QuadraticLoadFriction>};
}

}  // namespace nao::sim
