#include "validation/diagnosis/joint/joint_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nao::validation {
namespace {

// How well a fitted noise is known: null sets draw theirs from what the fit says. Hidden nulls left
// 0.6 to 1.09 of the noise floor (60 joints), laws without a name 5 and more.
constexpr double kNoiseKnown = 1.1;

double half(const Eigen::VectorXd& x) { return x.squaredNorm() / 2; }

// The larger of the two by null set, of those that both have.
std::vector<double> largestOf(std::vector<double> own, const std::vector<double>& others) {
  for (std::size_t i = 0; i < own.size() && i < others.size(); ++i) {
    own[i] = std::max(own[i], others[i]);
  }
  return own;
}

struct Spread {
  double mean = 0, sd = 0;
};

Spread spreadOf(const std::vector<double>& values) {
  double mean = 0, square = 0;
  for (const double value : values) mean += value, square += value * value;
  const double count = std::max(1.0, static_cast<double>(values.size()));
  mean /= count, square /= count;
  return {mean, std::sqrt(std::max(square - mean * mean, 1e-12))};
}

// Half the squares that each null set leaves.
std::vector<double> leftByNulls(const Stage& stage) {
  std::vector<double> left;
  for (const Eigen::VectorXd& null : stage.nulls()) left.push_back(half(stage.whiteAll(null)));
  return left;
}

NullRecord recordOf(const Stage& stage) {
  NullRecord record{{}, leftByNulls(stage)};
  for (const Eigen::VectorXd& null : stage.nulls()) {
    record.gains.push_back(stage.largestGain(stage.white(null)));
  }
  const Spread spread = spreadOf(record.remainders);
  for (double& left : record.remainders) left = (left - spread.mean) / spread.sd;
  return record;
}

}  // namespace

JointModel::JointModel(const JointSimulator& joint, const JointNoise& noise,
                       std::vector<Cause> causes, const Effort& effort, long granted_runs)
    : joint_(joint),
      causes_(withPartsOfRipples(std::move(causes))),
      effort_(effort),
      data_(joint, noise),
      ensemble_(joint, data_, noise, granted_runs) {
  for (Cause& cause : causes_) {
    cause = boundedAt(cause, joint, sim::standardEffects());
    if (cause.coupled && !joint.isCoupled()) cause.free[0].starts.clear();  // never looked at
  }
}

void JointModel::give(const Beside& beside) {
  const double before = stage_ ? half(stage_->white(stage_->raw())) : 0;
  ensemble_.setGiven(beside.effects);
  given_ = beside.ruled_out;
  enter(stageOf({}, Eigen::MatrixXd(data_.size(), 0)));
  given_gain_ = before - half(stage_->white(stage_->raw()));
}

std::unique_ptr<Stage> JointModel::stageOf(const CauseList& model,
                                           const Eigen::MatrixXd& jacobian) {
  return std::make_unique<Stage>(ensemble_, data_, causes_, model, jacobian, effort_, given_);
}

// Where chance is all that is left, what there was to see before is looked for: a fifth of a
// joint's time.
void JointModel::enter(std::unique_ptr<Stage> stage) {
  stage->simulateNulls(joint_.joint());
  const double left = half(stage->white(stage->raw()));
  const bool by_chance = !stage->model().empty() && left <= chanceOf(*stage, 0).most_left;
  stage->lookAround(by_chance ? stage_.get() : nullptr);
  if (!nominal_) nominal_ = std::move(stage_);
  stage_ = std::move(stage);
  nulls_ = recordOf(*stage_);
}

// Fits are made of coarse steps: Gauss-Newton steps with exact runs correct their numbers, a rough
// one before the comparison, unless it leads nowhere good, and a last one by it.
void JointModel::enter(const ModelFit& fit) {
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

JointModel::Snapshot JointModel::snapshot() const {
  return {std::make_unique<Stage>(*stage_), fit_, nulls_, found_, ensemble_.noise()};
}

void JointModel::restore(Snapshot before) {
  stage_ = std::move(before.stage);
  fit_ = std::move(before.fit);
  nulls_ = std::move(before.nulls);
  found_ = std::move(before.found);
  ensemble_.setNoise(before.noise);
}

double JointModel::critical() const {
  return quantile(largestOf(nulls_.gains, others_.nulls.gains), 1 - effort_.false_alarms);
}

double JointModel::excess() const { return half(stage_->white(stage_->raw())) - byChance().left; }

double JointModel::misfit(const Eigen::VectorXd& raw) const {
  const double floor = spreadOf(leftByNulls(*stage_)).mean;
  return std::sqrt(half(stage_->whiteAll(raw)) / std::max(floor, 1e-12));
}

Remainder JointModel::remainder() const {
  const Spread chance = spreadOf(leftByNulls(*stage_));
  const double critical =
      quantile(largestOf(nulls_.remainders, others_.nulls.remainders), 1 - effort_.false_alarms);
  return {(half(stage_->whiteAll(stage_->raw())) - chance.mean) / chance.sd,
          std::max(critical, (kNoiseKnown * kNoiseKnown - 1) * chance.mean / chance.sd)};
}

double JointModel::greatestGain() const {
  double greatest = std::max(0.0, given_gain_);
  for (const FoundCause& one : found_) greatest = std::max(greatest, one.gain);
  return greatest;
}

Eigen::MatrixXd JointModel::slopesOf(std::size_t place) const {
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < place; ++i) {
    column += static_cast<Eigen::Index>(fit_.model[i].x.size());
  }
  return fit_.jacobian.middleCols(column, static_cast<Eigen::Index>(fit_.model[place].x.size()));
}

std::unique_ptr<Stage> JointModel::stageWithout(std::size_t place) const {
  Eigen::MatrixXd jacobian(data_.size(), 0);
  for (std::size_t i = 0; i < fit_.model.size(); ++i) {
    if (i == place) continue;
    const Eigen::MatrixXd slopes = slopesOf(i);
    jacobian.conservativeResize(Eigen::NoChange, jacobian.cols() + slopes.cols());
    jacobian.rightCols(slopes.cols()) = slopes;
  }
  return std::make_unique<Stage>(*stage_, place, jacobian);
}

bool JointModel::isAtEnd(const Chosen& one) const {
  const FreeNumber& size = causes_[one.cause].free[0];
  const double margin = 1e-6 * (size.upper - size.lower);
  const bool above = one.x[0] > size.upper - margin && !causes_[one.cause].whole;
  return above || one.x[0] < size.lower + margin;
}

double JointModel::leftBy(const std::vector<EffectSetting>& causes) {
  const RunPool pool = ensemble_.pool(causes, effort_.slope_runs);
  return half(stage_->whitenFit(data_.mean() - pool.mean));
}

}  // namespace nao::validation
