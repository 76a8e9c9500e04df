#include "tests/hidden/look_alikes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/hidden/laws/laws.h"
#include "tests/hidden/response.h"

namespace nao::hidden {
namespace {

using validation::LogSet;
using validation::RecordingPlan;

// Rivals that stay farther away than this if they grow in proportion are not looked at closer.
constexpr double kHopeless = 2.5;  // of `below`
constexpr int kLooks = 6;
constexpr int kRepeats = 2;

// What the catalogue's effect of a law has as neutral, sign by sign.
double leastOf(const Hideout& rival) {
  const sim::EffectType* type = sim::standardEffects().find(rival.law);
  for (const sim::Parameter& parameter : type->parameters) {
    if (parameter.name == rival.parameter) return parameter.min - parameter.neutral;
  }
  return 0;
}

// The catalogue's own laws, further shapes of those with two numbers among them. At one joint a
// cause of all joints is one of its own, unless it has no number of its own there.
std::vector<Hideout> rivals() {
  std::vector<Hideout> all = catalogueHideouts();
  const std::vector<Hideout> given = all;
  const auto add = [&](const std::string& law, const char* parameter, double value) {
    for (Hideout hideout : given) {
      if (hideout.law != law) continue;
      hideout.shape[parameter] = value;
      all.push_back(hideout);
    }
  };
  for (const double speed : {0.05, 0.6}) add("stribeck_friction", "speed", speed);
  for (const double turns : {4.0, 16.0}) add("cogging", "per_turn", turns);
  for (const double rest : {-0.5, 0.5, 1.0}) add("cable_spring", "rest", rest);
  return all;
}

// A zero that is off lets a joint meet a stop by as much earlier: a stop that was moved does the
// same there. Neither answers to a size that does not reach, so that they begin at this one.
void addAsFar(const EffectSetting& effect, std::vector<Hideout>& all) {
  const std::vector<Hideout> given = all;
  for (const char* angle : {"angle", "upper", "lower"}) {
    const auto by = effect.parameters.find(angle);
    if (by == effect.parameters.end() || by->second == 0) continue;
    for (Hideout hideout : given) {
      if (hideout.law != "joint_stop" && hideout.law != "encoder_offset") continue;
      hideout.start = std::copysign(by->second, hideout.start);
      all.push_back(hideout);
    }
  }
}

class Comparison {
 public:
  Comparison(const Disguise& disguise, double below) : disguise_(disguise), below_(below) {
    plan_ = disguise.plan;
    plan_.repeats = kRepeats;
    plan_.step = std::chrono::milliseconds(2);  // differences, not data: as Worlds by default
    without_ = angles(plan_);
    target_ = response();
  }

  LookAlike fit(const Hideout& rival) const {
    LookAlike best{rival.cause, 0, 1e300};
    const double sign = rival.start < 0 ? -1 : 1, most = std::abs(rival.most);
    double deviation = rival.start;
    for (int look = 0; look < kLooks; ++look) {
      const Repeats change = changeBy(rival, deviation);
      const double apart = apartOf(change, 1);
      if (apart < best.apart) best = {rival.cause, deviation, apart};
      // By how much more of this change the target would be met, in the sense of least squares.
      const double own = productOf(change, change);
      const double factor = own > 0 ? productOf(change, target_) / own : 1;
      if (std::min(apartOf(change, factor), best.apart) > kHopeless * below_) break;
      if (std::abs(factor - 1) < 0.02) break;
      double next = deviation * std::clamp(factor, -3.0, 3.0);
      if (next * sign <= 0 && next < leastOf(rival)) break;  // it has no such sign
      next = std::clamp(next, -most, most);
      if (next == deviation || next == 0) break;
      deviation = next;
    }
    return best;
  }

 private:
  Repeats angles(const RecordingPlan& plan, bool hidden = false) const {
    const LogSet set = hidden && disguise_.record != nullptr ? disguise_.record(plan)
                                                             : validation::recordSimulated(plan);
    return repeatsOf(set, disguise_.joint);
  }

  // Of the hidden effect, in its own reality.
  Repeats response() const {
    RecordingPlan with = plan_;
    with.extra.push_back(disguise_.effect);
    const bool elsewhere = disguise_.record != nullptr;
    return less(angles(with, true), elsewhere ? angles(plan_, true) : without_);
  }

  Repeats changeBy(const Hideout& rival, double deviation) const {
    RecordingPlan with = plan_;
    with.extra.push_back(settingAt(rival, deviation, *plan_.model, disguise_.joint));
    return less(angles(with), without_);
  }

  // If `factor` of this change were made.
  double apartOf(const Repeats& change, double factor) const {
    return rmsWhereActing(less(target_, change, factor)) / disguise_.mean_sd;
  }

  const Disguise& disguise_;
  double below_;
  RecordingPlan plan_;
  Repeats without_, target_;
};

}  // namespace

std::vector<LookAlike> findLookAlikes(const Disguise& disguise, double below) {
  const Comparison comparison(disguise, below);
  std::map<std::string, LookAlike> nearest;
  std::vector<Hideout> all = rivals();
  addAsFar(disguise.effect, all);
  for (const Hideout& rival : all) {
    if (looksAlike(rival.cause, disguise.cause)) continue;
    const LookAlike fitted = comparison.fit(rival);
    const auto [place, fresh] = nearest.try_emplace(fitted.cause, fitted);
    if (!fresh && fitted.apart < place->second.apart) place->second = fitted;
  }
  std::vector<LookAlike> alike;
  alike.reserve(nearest.size());
  for (const auto& [cause, one] : nearest) alike.push_back(one);
  std::sort(alike.begin(), alike.end(),
            [](const LookAlike& a, const LookAlike& b) { return a.apart < b.apart; });
  return alike;
}

}  // namespace nao::hidden
