#include "validation/diagnosis/joint/joint_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nao::validation {
namespace {

constexpr double kSmallestShare = 0.03;  // of the excess misfit, less is not worth a name
constexpr double kNextBest = 0.4;        // of the best gain: tried if the best may not be named
// Of what the greatest cause explains: the law that a robot follows is only like that of the
// catalogue, and null sets, made by the latter, know nothing of the difference. This is a tenth of
// the first one's response. A false friction beside a rate limit by another law explained 0.8 % of
// what the limit does; of twelve second causes that were hidden none less than 1.2 %.
constexpr double kLawError = 0.01;
// Of what the greatest of its own family does: where that one's law is another, this one is the
// likeliest to explain the difference. False seconds beside hidden frictions of other laws
// explained 0.7 to 2.2 % as much as the first, of two that were hidden 52 and 83 %.
constexpr double kKinError = 0.05;
// Of what the greatest does: something small that explains less is the last one, what would follow
// explains less.
constexpr double kTrifle = 0.03;
// Of what is left: where two causes one after the other explain less, others would do no better.
constexpr double kLittle = 0.2;
constexpr double kUnchecked = 3;      // of the threshold: where it acts too briefly for any fold
constexpr double kBorneOut = 0.5;     // of what a fit promises, by exact runs: free choice
constexpr double kSharedPart = 0.15;  // of a number: half the width of a slope
constexpr char kOffBy[] = "explains no more than what was found may itself be off by";
constexpr char kEndOfRange[] = "fits best at the end of its range";

double half(const Eigen::VectorXd& x) { return x.squaredNorm() / 2; }

}  // namespace

double OtherJoints::costOf(std::size_t cause, double x) const {
  double cost = 0;
  for (const std::vector<SharedPart>& joint : shared) {
    const SharedPart* nearest = nullptr;
    for (const SharedPart& part : joint) {
      if (part.cause != cause || part.scanned) continue;
      if (nearest == nullptr || std::abs(part.x - x) < std::abs(nearest->x - x)) nearest = &part;
    }
    if (nearest == nullptr) continue;
    const double scale = x / nearest->x;
    cost += std::max(0.0, scale * (scale * nearest->square / 2 - nearest->along));
  }
  return cost;
}

JointSearch::JointSearch(const JointSimulator& joint, const JointNoise& noise,
                         std::vector<Cause> causes, const Effort& effort, long granted_runs)
    : joint_(joint),
      causes_(std::move(causes)),
      effort_(effort),
      data_(joint, noise),
      ensemble_(joint, data_, noise, granted_runs),
      candidates_(ensemble_, data_, causes_, effort_) {
  for (Cause& cause : causes_) {
    cause = boundedAt(cause, joint, sim::standardEffects());
    if (cause.coupled && !joint.isCoupled()) cause.free[0].starts.clear();  // never looked at
  }
}

void JointSearch::begin(const Beside& beside) {
  give(beside);
  misfit_before_ = misfit(*stage_, stage_->raw());
  split_ratio_ = splitRatio();
}

EffectSetting JointSearch::sharedSetting(std::size_t cause, double x) const {
  EffectSetting setting = settingOf(causes_[cause], {x});
  setting.joints.clear();
  return setting;
}

void JointSearch::give(const Beside& beside) {
  const double before = stage_ ? half(stage_->white(stage_->raw())) : 0;
  ensemble_.setGiven(beside.effects);
  given_ = beside.ruled_out;
  enter(stageOf({}, Eigen::MatrixXd(data_.size(), 0)));
  given_gain_ = before - half(stage_->white(stage_->raw()));
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
  return -Explained(stage_->white(change), stage_->white(stage_->raw())).gain();
}

SharedStep JointSearch::stepFrom(std::size_t cause, double x) {
  const FreeNumber& number = causes_[cause].free[0];
  const double width = std::min(
      {std::max(number.smallest, kSharedPart * std::abs(x)), number.upper - x, x - number.lower});
  SharedStep step;
  step.nulls.assign(stage_->nulls().size(), 0);
  if (width <= 0 || ensemble_.spent()) return step;
  const auto halves = [&](double at) {
    return ensemble_.exactHalves({sharedSetting(cause, at)}, effort_.slope_runs, Over::Fit);
  };
  const Halves slope = stage_->white((halves(x + width) - halves(x - width)) * (1 / (2 * width)));
  const RunPool here = ensemble_.pool({sharedSetting(cause, x)}, effort_.brief_runs);
  const auto along = [&](const Eigen::VectorXd& raw) {
    return slope.mean().dot(stage_->white(raw));
  };
  step.square = std::max(0.0, slope.first.dot(slope.second));
  step.along = along(data_.mean() - here.mean);
  for (std::size_t n = 0; n < step.nulls.size(); ++n) step.nulls[n] = along(stage_->nulls()[n]);
  return step;
}

std::unique_ptr<Stage> JointSearch::stageOf(const CauseList& model,
                                            const Eigen::MatrixXd& jacobian) {
  return std::make_unique<Stage>(ensemble_, data_, causes_, model, jacobian, effort_, given_);
}

// Where chance is all that is left, what there was to see before is looked for: a fifth of a
// joint's time.
void JointSearch::enter(std::unique_ptr<Stage> stage) {
  stage->simulateNulls(joint_.joint());
  const double left = half(stage->white(stage->raw()));
  const bool by_chance = !stage->model().empty() && left <= chanceOf(*stage, 0).most_left;
  stage->lookAround(by_chance ? stage_.get() : nullptr);
  if (!nominal_) nominal_ = std::move(stage_);
  stage_ = std::move(stage);
  nulls_ = {};
  double mean = 0, square = 0;
  for (const Eigen::VectorXd& null : stage_->nulls()) {
    nulls_.gains.push_back(stage_->largestGain(stage_->white(null)));
    nulls_.remainders.push_back(half(stage_->whiteAll(null)));
    mean += nulls_.remainders.back();
    square += nulls_.remainders.back() * nulls_.remainders.back();
  }
  mean /= static_cast<double>(nulls_.gains.size());
  square /= static_cast<double>(nulls_.gains.size());
  const double sd = std::sqrt(std::max(square - mean * mean, 1e-12));
  for (double& remainder : nulls_.remainders) remainder = (remainder - mean) / sd;
}

// Fits are made of coarse steps: Gauss-Newton steps with exact runs correct their numbers, a rough
// one before the comparison, unless it leads nowhere good, and a last one by it.
void JointSearch::enterModel(const ModelFit& fit) {
  fit_ = fit;
  if (fit_.model.empty()) return enter(stageOf({}, fit_.jacobian));
  const RunPool pool = ensemble_.pool(settingsOf(causes_, fit_.model), effort_.brief_runs);
  const Eigen::VectorXd unmoved = data_.mean() - pool.mean;
  moveNumbers(fit_, unmoved, *stage_, causes_);
  std::unique_ptr<Stage> stage = stageOf(fit_.model, fit_.jacobian);
  const auto left = [&](const Eigen::VectorXd& raw) { return half(stage_->whitenFit(raw)); };
  if (left(stage->raw()) > left(unmoved) + critical()) {
    fit_.model = fit.model;
    stage = stageOf(fit_.model, fit_.jacobian);
  }
  enter(std::move(stage));
  moveNumbers(fit_, stage_->raw(), *stage_, causes_);
}

double JointSearch::splitRatio() {
  const std::vector<Eigen::VectorXd> splits = data_.splits();
  double sum = 0, null_sum = 0;
  for (const Eigen::VectorXd& split : splits) sum += stage_->largestGain(stage_->white(split));
  for (const double gain : nulls_.gains) null_sum += gain;
  if (splits.empty() || null_sum <= 0) return 1;
  return sum / static_cast<double>(splits.size()) /
         (null_sum / static_cast<double>(nulls_.gains.size()));
}

double JointSearch::critical() const {
  std::vector<double> largest = nulls_.gains;
  for (std::size_t i = 0; i < largest.size() && i < others_.nulls.gains.size(); ++i) {
    largest[i] = std::max(largest[i], others_.nulls.gains[i]);
  }
  return quantile(largest, 1 - effort_.false_alarms);
}

// Half the squares of what is left, over what the null sets leave.
double JointSearch::misfit(const Stage& stage, const Eigen::VectorXd& raw) const {
  double floor = 0;
  for (const Eigen::VectorXd& null : stage.nulls()) floor += half(stage.whiteAll(null));
  floor /= static_cast<double>(std::max<std::size_t>(1, stage.nulls().size()));
  return std::sqrt(half(stage.whiteAll(raw)) / std::max(floor, 1e-12));
}

ByChance JointSearch::byChance() const { return chanceOf(*stage_, critical()); }

double JointSearch::shareOf(const Stage& stage, double gain) const {
  return gain / std::max(half(stage.white(stage.raw())) - byChance().left, gain);
}

// Why a candidate may not be named though it fits; empty: nothing against it.
std::string JointSearch::objection(const Stage& stage, const Candidate& candidate,
                                   const CrossValidation& validation) const {
  const bool unchecked = validation.folds == 0 && candidate.gain > kUnchecked * critical();
  if (!validation.accepted() && !unchecked) return "does not predict data it was not fitted to";
  if (shareOf(stage, candidate.gain) < kSmallestShare) return "explains under 3 % of the misfit";
  if (mayBeOffBy(candidate.gain, greatestGain())) return kOffBy;
  if (isAtEnd({candidate.cause, candidate.x})) return kEndOfRange;
  if (causes_[candidate.cause].one_for_all &&
      others_.costOf(candidate.cause, candidate.x[0]) > kUnchecked * critical()) {
    return "there is one for all joints, and others speak against it";
  }
  return "";
}

// Whether what explains this may be what the law of another that explains so much lacks.
bool JointSearch::mayBeOffBy(double gain, double greatest) const {
  return gain < kLawError * greatest;
}

double JointSearch::greatestGain() const {
  double greatest = std::max(0.0, given_gain_);
  for (const Accepted& one : accepted_) greatest = std::max(greatest, one.gain);
  return greatest;
}

// Whether a second law of a family may be what the first one's own lacks. But where it frees that
// one of its bound it is needed.
bool JointSearch::mayBeKinsLaw(const Candidate& candidate) const {
  const std::string& family = causes_[candidate.cause].family;
  if (family.empty() || trying_) return false;
  return std::any_of(accepted_.begin(), accepted_.end(), [&](const Accepted& one) {
    return causes_[one.cause].family == family && candidate.gain < kKinError * one.gain;
  });
}

bool JointSearch::newestIsTrifle() const {
  return accepted_.back().gain < kTrifle * greatestGain() && newestIsSmall();
}

bool JointSearch::newestTwoExplainLittle() const {
  const auto little = [](const Accepted& one) { return one.share < kLittle; };
  return accepted_.size() > 1 && std::all_of(accepted_.end() - 2, accepted_.end(), little);
}

bool JointSearch::isAtEnd(const Chosen& one) const {
  const FreeNumber& size = causes_[one.cause].free[0];
  const double margin = 1e-6 * (size.upper - size.lower);
  const bool above = one.x[0] > size.upper - margin && !causes_[one.cause].whole;
  return above || one.x[0] < size.lower + margin;
}

void JointSearch::reject(std::size_t cause, double gain, const std::string& reason) {
  rejected_.push_back({causes_[cause].id, gain, reason});
}

// How a candidate that may be named predicts what it was not fitted to; of others it notes why not.
std::optional<CrossValidation> JointSearch::validated(const Candidate& candidate) {
  const auto dropped = dropped_.find(candidate.cause);
  if (dropped != dropped_.end() && candidate.gain < dropped->second) return std::nullopt;
  const CrossValidation validation =
      crossValidate(data_, *stage_, candidate.fit, candidate.x.size());
  const std::string reason = objection(*stage_, candidate, validation);
  if (reason.empty()) return validation;
  reject(candidate.cause, candidate.gain, reason);
  return std::nullopt;
}

bool JointSearch::accept(std::vector<Candidate> ranking) {
  candidates_.weigh(*stage_, byChance(), ranking);
  const bool accepted = acceptOneOf(ranking);
  fitted_.clear();
  if (accepted) return true;
  for (const Candidate& candidate : ranking) fitted_[candidate.cause] = candidate.gain;
  return false;
}

bool JointSearch::acceptOneOf(std::vector<Candidate>& ranking) {
  const double best = ranking.empty() ? 0 : ranking.front().gain;
  int fitted = 0;
  for (Candidate& candidate : ranking) {
    if (candidate.gain <= critical()) return false;
    if (!candidate.full) {  // all before it may not be named
      if (candidate.gain < kNextBest * best || fitted++ == effort_.finalists) return false;
      if (ensemble_.spent()) return false;
      candidates_.fitFinally(*stage_, candidate);
    }
    if (candidate.gain <= critical()) continue;
    if (mayBeKinsLaw(candidate)) {  // of which the others explain less
      reject(candidate.cause, candidate.gain, kOffBy);
      return false;
    }
    const auto validation = validated(candidate);
    if (validation && takeIfBorneOut(candidate, *validation, ranking)) return true;
    if (!validation && takeIfFreed(candidate, ranking)) return true;
  }
  return false;
}

void JointSearch::take(const Candidate& candidate, const CrossValidation& validation,
                       const std::vector<Candidate>& ranking) {
  accepted_.push_back(
      {candidate.cause, candidate.gain, shareOf(*stage_, candidate.gain), validation, {}, {}});
  setRivals(accepted_.size() - 1, ranking, *stage_);
  ensemble_.learnNoise(settingsOf(causes_, candidate.fit.model));
  enterModel(candidate.fit);
  descend();
}

// A joint that sticks or rattles may look explained in coarse steps alone. Of little, chance
// between two ensembles may hide the most.
bool JointSearch::takeIfBorneOut(const Candidate& candidate, const CrossValidation& validation,
                                 const std::vector<Candidate>& ranking) {
  const Eigen::VectorXd raw = stage_->raw();
  Snapshot before = snapshot();
  take(candidate, validation, ranking);
  const double all = half(stage_->whitenFit(raw));
  const double promised = all - half(stage_->whitenFit(raw - candidate.fit.change.mean()));
  const double kept = all - half(stage_->white(stage_->raw()));
  if (kept >= kBorneOut * std::max(0.0, promised)) return true;
  if (promised - kept < kUnchecked * critical()) return true;
  restore(std::move(before));
  reject(candidate.cause, candidate.gain, "runs without approximations do not bear it out");
  return false;
}

// One of two causes that act alike, alone, goes as far as it may: only with the other beside it is
// it seen to be what it is. Two such in a row are none.
bool JointSearch::takeIfFreed(const Candidate& candidate, const std::vector<Candidate>& ranking) {
  if (trying_ || rejected_.empty() || rejected_.back().reason != kEndOfRange) return false;
  if (static_cast<int>(accepted_.size()) + 2 > effort_.most_causes) return false;
  Snapshot before = snapshot();
  const Rejected reason = rejected_.back();
  rejected_.pop_back();
  const std::size_t place = accepted_.size();
  take(candidate, crossValidate(data_, *stage_, candidate.fit, candidate.x.size()), ranking);
  trying_ = true;
  const bool freed = step() && !isAtEnd(fit_.model[place]);
  trying_ = false;
  if (freed) return true;
  restore(std::move(before));
  rejected_.push_back(reason);
  return false;
}

JointSearch::Snapshot JointSearch::snapshot() const {
  return {std::make_unique<Stage>(*stage_), fit_, nulls_, accepted_, ensemble_.noise()};
}

void JointSearch::restore(Snapshot before) {
  stage_ = std::move(before.stage);
  fit_ = std::move(before.fit);
  nulls_ = std::move(before.nulls);
  accepted_ = std::move(before.accepted);
  ensemble_.setNoise(before.noise);
}

bool JointSearch::step() {
  if (static_cast<int>(accepted_.size()) >= effort_.most_causes) return false;
  std::vector<Candidate> ranking = candidates_.rankedAt(*stage_, byChance());
  if (accepted_.empty()) noteFirsts(ranking);
  return accept(std::move(ranking));
}

void JointSearch::noteFirsts(const std::vector<Candidate>& ranking) {
  firsts_.clear();
  for (const Candidate& one : ranking) {
    if (one.gain > critical()) firsts_.push_back({one.cause, one.x});
  }
}

void JointSearch::lookForMore() {
  while (!newestTwoExplainLittle() && step() && !newestIsTrifle()) {
  }
}

JointVerdict JointSearch::conclude(const OtherJoints& others) {
  others_ = others;
  const Stage start = *stage_;
  for (int round = 0; round < 2; ++round) {  // a review may make room for one more
    const std::size_t before = accepted_.size();
    lookForMore();
    if (accepted_.size() == before || !review()) break;
  }
  if (takesPair(start)) lookForMore();
  refine();
  if (prune()) refine();
  rejectTheRest();
  JointVerdict verdict;
  judgeRemainder(verdict);
  describe(verdict);
  judge(verdict);
  return verdict;
}

}  // namespace nao::validation
