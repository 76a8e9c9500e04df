#include "validation/diagnosis/shared_cause.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <map>

#include "validation/diagnosis/beat_search.h"

namespace nao::validation {
namespace {

constexpr double kAsGood = 0.8;  // of what the joints' own causes explain by looks: both are rough
constexpr int kTried = 3;        // shared causes that are fitted
constexpr double kSame = 0.03;   // of the gain: rivals within it are not told apart

using Searches = std::vector<std::unique_ptr<JointSearch>>;

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

bool isStart(const Cause& cause, double x) {
  const std::vector<double>& starts = cause.free[0].starts;
  return std::find(starts.begin(), starts.end(), x) != starts.end();
}

std::vector<SharedLook> sharedLooks(const Searches& searches) {
  std::map<std::pair<std::size_t, double>, SharedLook> sums;
  for (std::size_t j = 0; j < searches.size(); ++j) {
    const Stage& stage = searches[j]->stage();
    const Eigen::VectorXd white = stage.white(stage.raw());
    for (const Look& look : stage.looks()) {
      const Cause& cause = searches[j]->causes()[look.cause];
      if (cause.scope != Scope::Robot || look.x.size() != 1) continue;
      const Explained explained(look.white, white);
      // Of a scan every joint has its own best, near the one that all share.
      const bool scanned = !cause.scan.empty() && !isStart(cause, look.x[0]);
      SharedLook& sum = sums[{look.cause, scanned ? kOfScan : look.x[0]}];
      sum.cause = look.cause;
      if (explained.gain() > sum.most) {
        sum.most = explained.gain(), sum.x = look.x[0];
      }
      sum.along += explained.along();
      sum.square += explained.square();
      sum.lower = std::max(sum.lower, look.lower);
      sum.upper = std::min(sum.upper, look.upper);
      ++sum.joints;
    }
  }
  std::vector<SharedLook> looks;
  for (const auto& [key, sum] : sums) {
    if (sum.joints == static_cast<int>(searches.size()) && sum.lower <= sum.upper) {
      looks.push_back(sum);
    }
  }
  return looks;
}

// What each joint gains with this number [nats].
std::vector<double> gainsAt(const Searches& searches, std::size_t cause, double x, int jobs) {
  std::vector<double> gains(searches.size());
  inParallel(searches.size(), jobs,
             [&](std::size_t j) { gains[j] = -searches[j]->costOf(cause, x); });
  return gains;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

// One number for all joints; remembers what every number gains.
class SharedFit {
 public:
  SharedFit(const Searches& searches, const SharedLook& look, int jobs)
      : searches_(searches),
        look_(look),
        number_(searches.front()->causes()[look.cause].free[0]),
        jobs_(jobs) {}

  // Narrows a bracket of three numbers around the best by parabolas.
  void narrow() {
    double centre = look_.scale() * look_.x, width = 0.3 * std::abs(centre);
    for (int round = 0; round < 3 && width > 0; ++round, width *= 0.35) {
      const double low = gainAt(centre - width), mid = gainAt(centre),
                   high = gainAt(centre + width), bend = low - 2 * mid + high;
      const double move =
          bend < 0 ? (low - high) / (2 * bend) * width : (high > low ? width : -width);
      centre += std::clamp(move, -2 * width, 2 * width);
    }
    gainAt(centre);
  }

  // To the best of these sizes, then as finely as all joints can tell.
  void beat(const std::vector<double>& sizes, const JointData& data) {
    for (const double x : sizes) gainAt(x);
    double width = beatWidth(data, bestNumber());
    for (int round = 0; round < 5; ++round, width /= 2) {
      const double centre = bestNumber();
      gainAt(centre - width);
      gainAt(centre + width);
    }
  }

  SharedCause best(double critical) const {
    SharedCause best;
    best.cause = look_.cause;
    best.x = bestNumber();
    const std::vector<double>& gains = tried_.at(best.x);
    best.gain = std::max(0.0, sum(gains));
    best.joints = static_cast<int>(
        std::count_if(gains.begin(), gains.end(), [&](double g) { return g > critical; }));
    return best;
  }

 private:
  double gainAt(double x) {
    x = std::clamp(x, number_.lower, number_.upper);
    auto found = tried_.find(x);
    if (found == tried_.end()) {
      found = tried_.emplace(x, gainsAt(searches_, look_.cause, x, jobs_)).first;
    }
    return sum(found->second);
  }

  double bestNumber() const {
    const auto best = std::max_element(
        tried_.begin(), tried_.end(),
        [](const auto& a, const auto& b) { return sum(a.second) < sum(b.second); });
    return best->first;
  }

  const Searches& searches_;
  const SharedLook& look_;
  const FreeNumber& number_;
  int jobs_;
  std::map<double, std::vector<double>> tried_;  // by number: of each joint
};

SharedCause fitShared(const Searches& searches, const SharedLook& look, double critical, int jobs) {
  SharedFit fit(searches, look, jobs);
  fit.narrow();
  return fit.best(critical);
}

// Clocks that beat with that of the log: the joint that is furthest off proposes sizes.
void addBeats(const Searches& searches, double critical, int jobs, std::vector<SharedCause>& fits) {
  std::size_t worst = 0;
  double most = -1;
  for (std::size_t j = 0; j < searches.size(); ++j) {
    const Stage& stage = searches[j]->stage();
    const double square = stage.white(stage.raw()).squaredNorm();
    if (square > most) most = square, worst = j;
  }
  const auto& causes = searches[worst]->causes();
  for (std::size_t c = 0; c < causes.size(); ++c) {
    if (!causes[c].beats || causes[c].scope != Scope::Robot) continue;
    const std::vector<double> sizes = searches[worst]->beatingSizesOf(c);
    if (sizes.empty()) continue;
    SharedLook look;
    look.cause = c;
    SharedFit fit(searches, look, jobs);
    fit.beat(sizes, searches[worst]->data());
    fits.push_back(fit.best(critical));
  }
}

}  // namespace

void inParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  const auto threads = static_cast<std::size_t>(std::max(1, jobs));
  std::vector<std::future<void>> running;
  for (std::size_t first = 1; first < threads && first < count; ++first) {
    running.push_back(std::async(std::launch::async, [=, &work] {
      for (std::size_t i = first; i < count; i += threads) work(i);
    }));
  }
  for (std::size_t i = 0; i < count; i += threads) work(i);
  for (auto& one : running) one.get();
}

std::optional<SharedCause> findShared(const Searches& searches, double critical, int jobs) {
  if (searches.size() < 2) return std::nullopt;
  double own = 0;
  for (const auto& search : searches) {
    const double best = search->stage().largestGain(search->stage().white(search->stage().raw()));
    if (best > critical) own += best;
  }
  std::vector<SharedLook> looks = sharedLooks(searches);
  std::stable_sort(looks.begin(), looks.end(),
                   [](const SharedLook& a, const SharedLook& b) { return a.gain() > b.gain(); });
  std::vector<SharedCause> fits;
  for (const SharedLook& look : looks) {
    if (look.gain() <= critical || look.gain() < kAsGood * own) break;
    const bool tried = std::any_of(fits.begin(), fits.end(),
                                   [&](const SharedCause& one) { return one.cause == look.cause; });
    const bool beats = searches.front()->causes()[look.cause].beats;  // looked at below
    if (tried || beats || static_cast<int>(fits.size()) >= kTried) continue;
    fits.push_back(fitShared(searches, look, critical, jobs));
  }
  if (own > 0) addBeats(searches, critical, jobs, fits);
  const auto& causes = searches.front()->causes();
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
      best.rivals.emplace_back(fits[i].cause, fits[i].x);
    }
  }
  return best;
}

}  // namespace nao::validation
