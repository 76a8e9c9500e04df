#include "validation/diagnosis/valley.h"

#include <algorithm>
#include <optional>

namespace nao::validation {
namespace {

constexpr double kFactor = 1.6;  // from a number to its neighbour: free choice
constexpr int kMostSteps = 6;    // a factor of 17
constexpr double kNear = 0.25;   // of what the better neighbour costs more

struct Place {
  double x = 0, cost = 0;
};

// Where a parabola through three places, the middle one the lowest, is least.
double vertexOf(const Place& a, const Place& b, const Place& c) {
  const double left = (b.x - a.x) * (b.cost - c.cost), right = (b.x - c.x) * (b.cost - a.cost);
  if (left == right) return b.x;
  return b.x - ((b.x - a.x) * left - (b.x - c.x) * right) / (2 * (left - right));
}

}  // namespace

double lowestAlong(const std::function<double(double)>& cost, double x, double lower,
                   double upper) {
  const auto at = [&](double to) { return Place{to, cost(to)}; };
  Place best = at(std::clamp(x, lower, upper));
  std::optional<Place> beyond, behind;  // the best one's neighbours
  for (const double factor : {kFactor, 1 / kFactor}) {
    beyond.reset();
    for (int i = 0; i < kMostSteps; ++i) {
      const double to = std::clamp(factor * best.x, lower, upper);
      if (to == best.x) break;
      beyond = at(to);
      if (beyond->cost >= best.cost) break;
      behind = best;
      best = *beyond;
      beyond.reset();
    }
    if (behind) break;  // it went down that way
    behind = beyond;
  }
  if (!beyond || !behind) return best.x;
  const double vertex = vertexOf(*beyond, best, *behind);
  // Costs so near each other are told apart by chance: the parabola knows better.
  const double near = kNear * (std::min(beyond->cost, behind->cost) - best.cost);
  return cost(vertex) < best.cost + near ? vertex : best.x;
}

}  // namespace nao::validation
