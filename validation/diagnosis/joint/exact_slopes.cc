#include "validation/diagnosis/joint/exact_slopes.h"

#include <algorithm>
#include <cmath>

namespace nao::validation {
namespace {

constexpr double kPart = 0.08;   // of a number: free choice
constexpr double kStop = 0.25;   // of a stop's size of interest: a joint meets it within that
constexpr double kWidest = 0.5;  // of it, where less shows mostly chance
constexpr double kWider = 3;
constexpr double kChance = 0.1;  // of a slope's squares

// What to go to either side, within bounds; nothing if one of them is that near.
double within(const FreeNumber& number, double x, double wished) {
  return std::min({wished, number.upper - x, x - number.lower});
}

class Slopes {
 public:
  Slopes(Ensemble& ensemble, const std::vector<Cause>& causes, int runs, const Stage& stage,
         ModelFit& fit)
      : ensemble_(ensemble), causes_(causes), runs_(runs), stage_(stage), fit_(fit) {}

  // Chance fades as a difference widens: one that steepens has gone beyond where the joint moves as
  // it does here.
  void set(const FreeNumber& number, bool stop, double& x, Eigen::Index column) {
    const double part = kPart * std::abs(x);
    const double wished =
        stop ? std::min(kStop * number.smallest, part) : std::max(number.smallest, part);
    double width = within(number, x, wished);
    if (width <= 0) return;
    setSlope(fit_, column, slope(x, width));
    while (chance(column) > kChance) {
      const double wider = within(number, x, std::min(kWider * width, kWidest * std::abs(x)));
      if (wider <= width || ensemble_.spent()) return;
      const Eigen::VectorXd mean = fit_.jacobian.col(column), by_chance = fit_.chance.col(column);
      setSlope(fit_, column, slope(x, wider));
      if (sizeOf(fit_.jacobian.col(column)) > sizeOf(mean)) {
        fit_.jacobian.col(column) = mean;
        fit_.chance.col(column) = by_chance;
        return;
      }
      width = wider;
    }
  }

 private:
  // With `x`, a number of the fit, moved to either side.
  Halves slope(double& x, double width) {
    const double middle = x;
    x = middle + width;
    const Halves above = runsHere();
    x = middle - width;
    const Halves below = runsHere();
    x = middle;
    return (above - below) * (1 / (2 * width));
  }

  Halves runsHere() { return ensemble_.exactHalves(settingsOf(causes_, fit_.model), runs_); }

  double sizeOf(const Eigen::VectorXd& change) const { return stage_.whitenFit(change).norm(); }

  double chance(Eigen::Index column) const {
    const double all = sizeOf(fit_.jacobian.col(column));
    return std::pow(sizeOf(fit_.chance.col(column)) / std::max(all, 1e-150), 2);
  }

  Ensemble& ensemble_;
  const std::vector<Cause>& causes_;
  int runs_;
  const Stage& stage_;
  ModelFit& fit_;
};

}  // namespace

void setExactSlopes(Ensemble& ensemble, const std::vector<Cause>& causes, int runs,
                    const Stage& stage, ModelFit& fit) {
  Slopes slopes(ensemble, causes, runs, stage, fit);
  Eigen::Index column = 0;
  for (Chosen& one : fit.model) {
    const Cause& cause = causes[one.cause];
    for (std::size_t i = 0; i < one.x.size(); ++i, ++column) {
      if (i == 0 && cause.beats) continue;
      slopes.set(cause.free[i], cause.stop && i == 0, one.x[i], column);
    }
  }
}

}  // namespace nao::validation
