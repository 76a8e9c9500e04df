#include "validation/diagnosis/joint/size_search.h"

#include <algorithm>
#include <cmath>

#include "validation/diagnosis/joint/beat_search.h"

namespace nao::validation {
namespace {

constexpr int kFollowed = 3, kShortened = 3, kNarrowed = 5;  // steps
constexpr double kFar = 3;                                   // times a size, in one step
constexpr int kHalves = 2, kHalvesIfRough = 5;               // of a way that is tried
constexpr double kNear = 0.08;                               // of a size: not worth a step
constexpr double kBeside = 0.02;                             // of a size, for a slope
constexpr double kStopStep = 1.12;                           // from one size to the next
constexpr double kFarAlong = 10;                             // times that, in one step

bool isWorse(const SizeSearch::Point& a, const SizeSearch::Point& b) { return a.gain < b.gain; }

}  // namespace

SizeSearch::SizeSearch(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
                       std::size_t cause, const Effort& effort, Runs runs)
    : ensemble_(ensemble),
      stage_(stage),
      causes_(causes),
      cause_(cause),
      effort_(effort),
      runs_(runs),
      residual_(stage.white(stage.raw())) {}

SizeSearch::Point SizeSearch::from(const std::vector<double>& x) const {
  const Cause& cause = causes_[cause_];
  Point best = at(x);
  if (cause.beats) return best.gain > 0 ? beating(best) : best;
  if (cause.linear && !cause.scan.empty()) best = alongBend(best);
  best = cause.linear ? shortened(best) : scanned(best);
  return best.gain > 0 ? followed(best) : best;
}

SizeSearch::Point SizeSearch::near(const std::vector<double>& x) const {
  const Point best = at(x);
  return best.gain > 0 && !causes_[cause_].beats ? followed(best) : best;
}

SizeSearch::Point SizeSearch::reshaped(const std::vector<double>& x) const {
  Point best = at(x);
  for (const double part : {0.5, 0.25}) {
    for (std::size_t i = 1; i < x.size(); ++i) {
      for (const double way : {-part, part}) best = reshaped(best, best.x, {{i, way}});
    }
    if (x.size() != 3 || causes_[cause_].ripples) continue;
    const std::vector<double> centre = best.x;
    for (const double one : {-part, part}) {
      for (const double other : {-part, part}) {
        best = reshaped(best, centre, {{1, one}, {2, other}});
      }
    }
  }
  return best;
}

// The best so far, or from these numbers with some moved by a part of their starts' way.
SizeSearch::Point SizeSearch::reshaped(const Point& best, const std::vector<double>& from,
                                       const std::map<std::size_t, double>& moves) const {
  std::vector<double> x = from;
  for (const auto& [number, part] : moves) {
    const FreeNumber& shape = causes_[cause_].free[number];
    const auto [low, high] = std::minmax_element(shape.starts.begin(), shape.starts.end());
    x[number] = std::clamp(x[number] + part * (*high - *low), shape.lower, shape.upper);
  }
  return x == from ? best : std::max(best, followed(at(x)), &isWorse);
}

SizeSearch::Point SizeSearch::at(const std::vector<double>& x) const {
  const Explained explained(stage_.white(changeAt(x)), residual_);
  return {x, explained.gain(), explained.bestScale()};
}

// Rough causes have several valleys: the best size of a widely, then a finely spaced row.
SizeSearch::Point SizeSearch::scanned(Point best) const {
  for (const std::vector<double>& row :
       {std::vector<double>{0.4, 0.63, 1.6, 2.5}, {0.8, 1.25}, {0.9, 1.11}}) {
    const Point centre = best;
    for (const double factor : row) best = std::max(best, scaled(centre, factor), &isWorse);
  }
  return best.gain > 0 || !causes_[cause_].stop ? best : reached(best);
}

// A stop does nothing until it is reached, and soon afterwards too much.
SizeSearch::Point SizeSearch::reached(const Point& from) const {
  Point best = from;
  for (double factor = kStopStep; factor < kFar; factor *= kStopStep) {
    best = std::max(best, scaled(from, factor), &isWorse);
  }
  return best;
}

// To the best of sizes whose beat must be met.
SizeSearch::Point SizeSearch::beating(Point best) const {
  double width = beatWidth(ensemble_.data(), best.x[0]);
  for (int i = 0; i < kNarrowed; ++i, width /= 2) {
    const Point centre = best;
    for (const double size : {centre.x[0] - width, centre.x[0] + width}) {
      best = std::max(best, withSize(centre, size), &isWorse);
    }
  }
  return best;
}

// Responses bend where a joint meets a stop: from one size to where the next beside it points.
SizeSearch::Point SizeSearch::alongBend(Point best) const {
  double step = std::max(size().smallest, kBeside * std::abs(best.x[0]));
  for (int i = 0; i < kFollowed; ++i, step /= 2) {
    const Response here = responseTo(best.x[0]), beside = responseTo(best.x[0] + step);
    const Point next = withSize(best, alongChord(here, beside, residual_, kFarAlong));
    if (!isWorse(best, next)) break;
    best = next;
  }
  return best;
}

// A look was scaled too far if nothing is gained there: half as far, and again.
SizeSearch::Point SizeSearch::shortened(Point best) const {
  for (int i = 0; i < kShortened && best.gain <= 0; ++i) best = scaled(best, 0.5);
  return best;
}

// To where the cause would be best if it were linear, or part of the way, until it hardly moves.
SizeSearch::Point SizeSearch::followed(Point best) const {
  for (int i = 0; i < kFollowed; ++i) {
    const double factor = std::clamp(best.scale, 1 / kFar, kFar);
    if (std::abs(factor - 1) < kNear) break;
    const Point next = partOfTheWay(best, factor);
    if (!isWorse(best, next)) break;
    best = next;
  }
  return best;
}

// All of it, half, and where valleys are narrow, such as a rate limit's, still less.
SizeSearch::Point SizeSearch::partOfTheWay(const Point& from, double factor) const {
  const int tried = causes_[cause_].linear ? kHalves : kHalvesIfRough;
  for (int i = 0; i < tried; ++i, factor = std::sqrt(factor)) {
    const Point next = scaled(from, factor);
    if (isWorse(from, next)) return next;
  }
  return from;
}

SizeSearch::Point SizeSearch::withSize(const Point& from, double size) const {
  std::vector<double> x = from.x;
  x[0] = std::clamp(size, this->size().lower, this->size().upper);
  return at(x);
}

SizeSearch::Point SizeSearch::scaled(const Point& from, double factor) const {
  return withSize(from, factor * from.x[0]);
}

// Of a cause of one number.
Response SizeSearch::responseTo(double size) const {
  return {size, stage_.white(changeAt({size})).mean()};
}

Halves SizeSearch::changeAt(const std::vector<double>& x) const {
  CauseList with = stage_.model();
  with.push_back({cause_, x});
  const auto settings = settingsOf(causes_, with);
  if (runs_ == Runs::Coarse) {
    return ensemble_.halves(settings, effort_.look_runs, Over::Fit) - stage_.quickBase();
  }
  return ensemble_.roughHalves(settings, effort_.look_runs, Over::Fit) - stage_.lookBase();
}

}  // namespace nao::validation
