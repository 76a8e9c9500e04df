#include "validation/diagnosis/joint/shared_cause.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "validation/diagnosis/joint/beat_search.h"
#include "validation/diagnosis/maths/shared_fit.h"

namespace nao::validation {
namespace {

constexpr double kAsGood = 0.8;  // of what the joints' own causes explain by looks: both are rough
constexpr double kPlausible = 0.5;  // of the same, by the best look: else joints share nothing
// Of the same: less never becomes the best fit. A filter of 4 ms is looked at by 15, from where no
// straight line leads to it.
constexpr double kHopeless = 0.04;
constexpr int kTried = 5;         // shared causes that are fitted
constexpr int kRounds = 4;        // of exact steps
constexpr double kSettled = 0.2;  // of the interval: a step that is no longer worth another
constexpr double kSame = 0.03;    // of the gain: rivals within it are not told apart

// The parabola of nats that a look is worth at a scale: along * s - square * s^2 / 2, all joints.
struct SharedLook {
  std::size_t cause = 0;
  double x = 0;
  double along = 0, square = 0, lower = -1e300, upper = 1e300;
  double most = -1e300;  // [nats] of the joint that x was taken from
  int joints = 0;
  double scale() const { return square > 0 ? std::clamp(along / square, lower, upper) : 0; }
  double gain() const { return scale() * along - scale() * scale() * square / 2; }
};

constexpr double kOfScan = 0;  // no size is 0

std::vector<SharedLook> sharedLooks(const JointCrowd& joints) {
  std::map<std::pair<std::size_t, double>, SharedLook> sums;
  for (const JointLooks& joint : joints.looks()) {
    for (const SharedPart& part : joint.shared) {
      // Of a scan every joint has its own best, near the one that all share.
      SharedLook& sum = sums[{part.cause, part.scanned ? kOfScan : part.x}];
      sum.cause = part.cause;
      if (part.gain > sum.most) {
        sum.most = part.gain, sum.x = part.x;
      }
      sum.along += part.along;
      sum.square += part.square;
      sum.lower = std::max(sum.lower, part.lower);
      sum.upper = std::min(sum.upper, part.upper);
      ++sum.joints;
    }
  }
  std::vector<SharedLook> looks;
  for (const auto& [key, sum] : sums) {
    if (sum.joints == static_cast<int>(joints.size()) && sum.lower <= sum.upper) {
      looks.push_back(sum);
    }
  }
  return looks;
}

SharedFit fitOf(JointCrowd& joints, std::size_t cause) {
  const FreeNumber& number = joints.causes()[cause].free[0];
  return {[&joints, cause](double x) { return joints.gainsAt(cause, x); }, number.lower,
          number.upper};
}

SharedCause bestOf(const SharedFit& fit, std::size_t cause, double critical) {
  SharedCause best;
  best.cause = cause;
  best.x = fit.best();
  best.gain = std::max(0.0, fit.gain());
  best.joints = static_cast<int>(std::count_if(fit.gains().begin(), fit.gains().end(),
                                               [&](double gain) { return gain > critical; }));
  return best;
}

SharedCause fitShared(JointCrowd& joints, const SharedLook& look, double critical) {
  SharedFit fit = fitOf(joints, look.cause);
  fit.narrow(look.scale() * look.x);
  return bestOf(fit, look.cause, critical);
}

// Clocks that beat with that of the log: the joint that is furthest off proposes sizes.
void addBeats(JointCrowd& joints, double critical, std::vector<SharedCause>& fits) {
  std::size_t worst = 0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints.looks()[j].square > joints.looks()[worst].square) worst = j;
  }
  const auto& causes = joints.causes();
  for (std::size_t c = 0; c < causes.size(); ++c) {
    if (!causes[c].beats || causes[c].scope != Scope::Robot) continue;
    const std::vector<double> sizes = joints.beatingSizesOf(worst, c);
    if (sizes.empty()) continue;
    SharedFit fit = fitOf(joints, c);
    fit.tryAll(sizes);
    fit.halve(beatWidth(joints.data(worst), fit.best()));
    fits.push_back(bestOf(fit, c, critical));
  }
}

SharedStep stepOfAll(JointCrowd& joints, const SharedCause& shared) {
  SharedStep all;
  for (const SharedStep& one : joints.stepsFrom(shared.cause, shared.x)) {
    all.along += one.along;
    all.square += one.square;
    all.nulls.resize(std::max(all.nulls.size(), one.nulls.size()), 0);
    for (std::size_t n = 0; n < one.nulls.size(); ++n) all.nulls[n] += one.nulls[n];
  }
  return all;
}

void refineClock(JointCrowd& joints, SharedCause& shared) {
  const auto left = [&](double x) {
    const std::vector<double> each = joints.leftAt(shared.cause, x);
    return std::accumulate(each.begin(), each.end(), 0.0);
  };
  const double width = beatWidth(joints.data(0), shared.x);
  shared.x = shared.low = shared.high = bestBeside({shared.x, left(shared.x)}, width, left).x;
}

// Coarse runs found it; exact ones of all joints together say by how much it is off, and null sets
// how well they know.
void refine(JointCrowd& joints, SharedCause& shared) {
  const Cause& cause = joints.causes()[shared.cause];
  const FreeNumber& number = cause.free[0];
  if (cause.beats) return refineClock(joints, shared);
  shared.low = shared.high = shared.x;
  for (int round = 0; round < kRounds; ++round) {
    SharedStep all = stepOfAll(joints, shared);
    if (all.square <= 0) return;
    const double moved = all.along / all.square;
    shared.x = std::clamp(shared.x + moved, number.lower, number.upper);
    for (double& null : all.nulls) null /= all.square;
    const double above = quantile(all.nulls, 0.95), below = quantile(all.nulls, 0.05);
    shared.low = shared.x - above;
    shared.high = shared.x - below;
    if (std::abs(moved) < kSettled * (above - below)) return;
  }
}

}  // namespace

std::optional<SharedCause> findShared(JointCrowd& joints, double critical) {
  if (joints.size() < 2) return std::nullopt;
  double own = 0;
  for (const JointLooks& joint : joints.looks()) {
    if (joint.best > critical) own += joint.best;
  }
  std::vector<SharedLook> looks = sharedLooks(joints);
  std::stable_sort(looks.begin(), looks.end(),
                   [](const SharedLook& a, const SharedLook& b) { return a.gain() > b.gain(); });
  std::vector<SharedCause> fits;
  const bool plausible = !looks.empty() && looks.front().gain() >= kPlausible * own;
  for (const SharedLook& look : looks) {
    if (!plausible || look.gain() <= std::max(critical, kHopeless * own)) break;
    const bool tried = std::any_of(fits.begin(), fits.end(),
                                   [&](const SharedCause& one) { return one.cause == look.cause; });
    const bool beats = joints.causes()[look.cause].beats;  // looked at below
    if (tried || beats || static_cast<int>(fits.size()) >= kTried) continue;
    fits.push_back(fitShared(joints, look, critical));
  }
  if (own > 0) addBeats(joints, critical, fits);
  const auto& causes = joints.causes();
  // The size of a rough cause is the best of many: it has to be better than one that is not.
  const auto worth = [&](const SharedCause& one) {
    return causes[one.cause].linear ? one.gain : (1 - kSame) * one.gain;
  };
  std::stable_sort(fits.begin(), fits.end(),
                   [&](const SharedCause& a, const SharedCause& b) { return worth(a) > worth(b); });
  if (fits.empty() || fits.front().joints < 2 || fits.front().gain < kAsGood * own ||
      std::abs(fits.front().x) < causes[fits.front().cause].free[0].smallest) {
    return std::nullopt;
  }
  SharedCause best = fits.front();
  for (std::size_t i = 1; i < fits.size(); ++i) {
    if (fits[i].cause == best.cause) continue;
    if (fits[i].gain >= best.gain - std::max(critical, kSame * best.gain)) {
      best.rivals.push_back({fits[i].cause, fits[i].x, ""});
    }
  }
  refine(joints, best);
  if (mayBeSmall(best.low, best.high, causes[best.cause].free[0].smallest)) return std::nullopt;
  return best;
}

}  // namespace nao::validation
