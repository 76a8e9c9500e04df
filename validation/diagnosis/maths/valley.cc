#include "validation/diagnosis/maths/valley.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nao::validation {
namespace {

constexpr double kFactor = 1.6;  // from a number to its neighbour: free choice
constexpr int kMostSteps = 6;    // a factor of 17
constexpr int kMostHalvings = 3;
// Of costs, thrice what was seen: no proof against a parabola.
constexpr double kChance = 50;  // [nats]
constexpr double kNear = 0.25;  // of what the better neighbour costs more

struct Place {
  double x = 0, cost = 0;
};

struct Three {  // the best and its neighbours
  Place beyond, best, behind;
};

// Where a parabola through three places, the middle one the lowest, is least.
double vertexOf(const Three& of) {
  const auto& [a, b, c] = of;
  const double left = (b.x - a.x) * (b.cost - c.cost), right = (b.x - c.x) * (b.cost - a.cost);
  if (left == right) return b.x;
  return b.x - ((b.x - a.x) * left - (b.x - c.x) * right) / (2 * (left - right));
}

// The same parabola's cost elsewhere.
double along(const Three& of, double x) {
  const auto part = [x](const Place& own, const Place& a, const Place& b) {
    return own.cost * (x - a.x) * (x - b.x) / ((own.x - a.x) * (own.x - b.x));
  };
  return part(of.best, of.beyond, of.behind) + part(of.beyond, of.best, of.behind) +
         part(of.behind, of.best, of.beyond);
}

// With a place between two of them.
Three narrowed(const Three& of, const Place& place) {
  const bool is_beyond = (place.x > of.best.x) == (of.beyond.x > of.best.x);
  if (place.cost < of.best.cost) {
    return is_beyond ? Three{of.beyond, place, of.best} : Three{of.best, place, of.behind};
  }
  return is_beyond ? Three{place, of.best, of.behind} : Three{of.beyond, of.best, place};
}

// By a parabola; where costs do not follow it, one side is the steeper: by nearer places.
double lowestBetween(const std::function<Place(double)>& at, Three of) {
  for (int i = 0; i < kMostHalvings; ++i) {
    const Place vertex = at(vertexOf(of));
    // Costs so near each other are told apart by chance: the parabola knows better.
    const double near = kNear * (std::min(of.beyond.cost, of.behind.cost) - of.best.cost);
    if (std::abs(vertex.cost - along(of, vertex.x)) < std::max(near, kChance)) {
      return vertex.cost < of.best.cost + near ? vertex.x : of.best.x;
    }
    of = narrowed(of, vertex);
    of = narrowed(of, at((of.best.x + of.beyond.x) / 2));
    of = narrowed(of, at((of.best.x + of.behind.x) / 2));
  }
  return of.best.x;
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
  return lowestBetween(at, {*beyond, best, *behind});
}

}  // namespace nao::validation
