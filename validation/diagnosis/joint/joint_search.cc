#include "validation/diagnosis/joint/joint_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "validation/diagnosis/joint/beat_search.h"
#include "validation/diagnosis/joint/number_moves.h"

namespace nao::validation {
namespace {

// Of what the greatest does: something small that explains less is the last one, what would follow
// explains less.
constexpr double kTrifle = 0.03;
// Of what is left: where two causes one after the other explain less, others would do no better.
constexpr double kLittle = 0.2;
constexpr double kSharedPart = 0.15;  // of a number: half the width of a slope

}  // namespace

JointSearch::JointSearch(const JointSimulator& joint, const JointNoise& noise,
                         std::vector<Cause> causes, const Effort& effort, long granted_runs)
    : model_(joint, noise, std::move(causes), effort, granted_runs),
      causes_(model_.causes()),
      effort_(model_.effort()),
      data_(model_.data()),
      ensemble_(model_.ensemble()),
      candidates_(joint, ensemble_, data_, causes_, effort_) {}

void JointSearch::begin(const Beside& beside) {
  give(beside);
  notes_.misfit_before = model_.misfit(stage().raw());
  notes_.split_ratio = splitRatio();
}

EffectSetting JointSearch::sharedSetting(std::size_t cause, double x) const {
  EffectSetting setting = settingOf(causes_[cause], {x});
  setting.joints.clear();
  return setting;
}

void JointSearch::give(std::size_t cause, double x) { give({{sharedSetting(cause, x)}, {cause}}); }

double JointSearch::costOf(std::size_t cause, const std::vector<double>& x,
                           const std::vector<Joint>& place) {
  EffectSetting setting = settingOf(causes_[cause], x);
  setting.joints = place;
  const auto halves = [&](const std::vector<EffectSetting>& causes) {
    return ensemble_.halves(causes, effort_.final_runs, Over::Fit);
  };
  const Halves change = halves({setting}) - halves({});
  return -Explained(stage().white(change), stage().white(stage().raw())).gain();
}

SharedStep JointSearch::stepFrom(std::size_t cause, double x) {
  const FreeNumber& number = causes_[cause].free[0];
  const double width = std::min(
      {std::max(number.smallest, kSharedPart * std::abs(x)), number.upper - x, x - number.lower});
  SharedStep step;
  step.nulls.assign(stage().nulls().size(), 0);
  if (width <= 0 || ensemble_.spent()) return step;
  const auto halves = [&](double at) {
    return ensemble_.exactHalves({sharedSetting(cause, at)}, effort_.slope_runs, Over::Fit);
  };
  const Halves slope = stage().white((halves(x + width) - halves(x - width)) * (1 / (2 * width)));
  const RunPool here = ensemble_.pool({sharedSetting(cause, x)}, effort_.brief_runs);
  const auto along = [&](const Eigen::VectorXd& raw) {
    return slope.mean().dot(stage().white(raw));
  };
  step.square = std::max(0.0, slope.first.dot(slope.second));
  step.along = along(data_.mean() - here.mean);
  for (std::size_t n = 0; n < step.nulls.size(); ++n) step.nulls[n] = along(stage().nulls()[n]);
  return step;
}

double JointSearch::leftBy(std::size_t cause, double x) {
  return model_.leftBy({sharedSetting(cause, x)});
}

std::vector<double> JointSearch::beatingSizesOf(std::size_t cause) {
  return beatingSizes(ensemble_, stage(), causes_, cause);
}

double JointSearch::splitRatio() const {
  const std::vector<Eigen::VectorXd> splits = data_.splits();
  double sum = 0, null_sum = 0;
  for (const Eigen::VectorXd& split : splits) sum += stage().largestGain(stage().white(split));
  for (const double gain : model_.nulls().gains) null_sum += gain;
  if (splits.empty() || null_sum <= 0) return 1;
  return sum / static_cast<double>(splits.size()) /
         (null_sum / static_cast<double>(model_.nulls().gains.size()));
}

bool JointSearch::newestIsTrifle() const {
  return model_.found().back().gain < kTrifle * model_.greatestGain() && newestIsSmall();
}

// Even by chance alone.
bool JointSearch::newestIsSmall() const {
  const ModelFit& fit = model_.fit();
  const Chosen& newest = fit.model.back();
  const Cause& cause = causes_[newest.cause];
  const auto numbers = static_cast<Eigen::Index>(newest.x.size());
  const Eigen::MatrixXd moves = reestimated(stage(), fit);
  return mayBeSmall(foundNumbers(cause, newest.x)[0], moves.col(moves.cols() - numbers), cause);
}

bool JointSearch::newestTwoExplainLittle() const {
  const std::vector<FoundCause>& found = model_.found();
  const auto little = [](const FoundCause& one) { return one.share < kLittle; };
  return found.size() > 1 && std::all_of(found.end() - 2, found.end(), little);
}

void JointSearch::reject(std::size_t cause, double gain, const std::string& reason) {
  notes_.rejected.push_back({causes_[cause].id, gain, reason});
}

bool JointSearch::accept(std::vector<Candidate> ranking) {
  candidates_.weigh(stage(), model_.byChance(), ranking);
  const bool accepted = acceptOneOf(ranking);
  notes_.last_gains.clear();
  if (accepted) return true;
  for (const Candidate& candidate : ranking) notes_.last_gains[candidate.cause] = candidate.gain;
  return false;
}

bool JointSearch::step() {
  if (static_cast<int>(model_.found().size()) >= effort_.most_causes) return false;
  std::vector<Candidate> ranking = candidates_.rankedAt(stage(), model_.byChance());
  if (model_.found().empty()) noteFirsts(ranking);
  return accept(std::move(ranking));
}

void JointSearch::noteFirsts(const std::vector<Candidate>& ranking) {
  firsts_.clear();
  for (const Candidate& one : ranking) {
    if (one.gain <= model_.critical() || causes_[one.cause].alone) continue;
    firsts_.push_back({one.cause, one.x});
  }
}

void JointSearch::lookForMore() {
  while (!newestTwoExplainLittle() && step() && !newestIsTrifle()) {
  }
}

JointVerdict JointSearch::conclude(const OtherJoints& others) {
  model_.setOthers(others);
  const Stage start = stage();
  for (int round = 0; round < 2; ++round) {  // a review may make room for one more
    const std::size_t before = model_.found().size();
    lookForMore();
    if (model_.found().size() == before || !review()) break;
  }
  if (takesPair(start)) lookForMore();
  dropWhatMayBeOff();
  model_.refine();
  if (prune() || takesOneForTwo()) model_.refine();
  notes_.not_tried = candidates_.notTried();
  return JointReport(model_, notes_).verdict();
}

}  // namespace nao::validation
