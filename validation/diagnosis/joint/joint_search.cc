#include "validation/diagnosis/joint/joint_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nao::validation {
namespace {

// Of what the greatest does: something small that explains less is the last one, what would follow
// explains less.
constexpr double kTrifle = 0.03;
// Of what is left: where two causes one after the other explain less, others would do no better.
constexpr double kLittle = 0.2;
constexpr double kSharedPart = 0.15;  // of a number: half the width of a slope

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
      causes_(withPartsOfRipples(std::move(causes))),
      effort_(effort),
      data_(joint, noise),
      ensemble_(joint, data_, noise, granted_runs),
      candidates_(joint, ensemble_, data_, causes_, effort_) {
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

bool JointSearch::newestIsTrifle() const {
  return accepted_.back().gain < kTrifle * greatestGain() && newestIsSmall();
}

bool JointSearch::newestTwoExplainLittle() const {
  const auto little = [](const Accepted& one) { return one.share < kLittle; };
  return accepted_.size() > 1 && std::all_of(accepted_.end() - 2, accepted_.end(), little);
}

void JointSearch::reject(std::size_t cause, double gain, const std::string& reason) {
  rejected_.push_back({causes_[cause].id, gain, reason});
}

bool JointSearch::accept(std::vector<Candidate> ranking) {
  candidates_.weigh(*stage_, byChance(), ranking);
  const bool accepted = acceptOneOf(ranking);
  fitted_.clear();
  if (accepted) return true;
  for (const Candidate& candidate : ranking) fitted_[candidate.cause] = candidate.gain;
  return false;
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
    if (one.gain <= critical() || causes_[one.cause].alone) continue;
    firsts_.push_back({one.cause, one.x});
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
  const Remainder left = remainder();
  verdict.remainder_score = left.score;
  verdict.remainder_critical = left.critical;
  describe(verdict);
  judge(verdict);
  return verdict;
}

}  // namespace nao::validation
