#include "validation/diagnosis/joint/stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.h"
#include "validation/diagnosis/ensemble/noise_modes.h"
#include "validation/diagnosis/ensemble/start_offsets.h"
#include "validation/diagnosis/maths/chords.h"
#include "validation/diagnosis/maths/span.h"

namespace nao::validation {
namespace {

// Of the most that equal robots differ by: 1 % of a head's weight moved where its centre of mass
// was told to be by 0.1 %, by directions of 1 and 10 times that size by 1.7 and 0.3 %.
constexpr double kWidely = 5;

}  // namespace

Stage::Stage(Ensemble& ensemble, const JointData& data, const std::vector<Cause>& causes,
             CauseList model, const Eigen::MatrixXd& jacobian, const Effort& effort,
             const std::vector<std::size_t>& given)
    : data_(data),
      causes_(causes),
      ensemble_(ensemble),
      model_(std::move(model)),
      given_(given),
      jacobian_(jacobian),
      effort_(effort) {
  const auto settings = settingsOf(causes, model_);
  pool_ = ensemble.pool(settings, effort.base_runs);
  quick_base_ = ensemble.halves(settings, effort.look_runs, Over::Fit);
  look_base_ = ensemble.roughHalves(settings, effort.look_runs, Over::Fit);
  raw_ = data.mean() - pool_.mean;
  const RunPool spread = ensemble.spread(settings, effort.spread_runs);
  const NoiseModes modes = findNoiseModes(spread, pool_.worth(), data, data.sd());
  Eigen::MatrixXd disturbances = directions(effort, ensemble.noise().start_sd);
  disturbances.conservativeResize(Eigen::NoChange, disturbances.cols() + modes.directions.cols());
  disturbances.rightCols(modes.directions.cols()) = modes.directions;
  // The prediction is a mean too.
  Eigen::VectorXd sd = modes.sd;
  for (const MotionSpan& span : data.spans()) {
    sd.segment(span.offset, span.size()) *=
        std::sqrt(1 + static_cast<double>(span.repeats) / pool_.worth());
  }
  const Eigen::Index n = data.fitSize();
  fit_ = Whitening(sd.head(n), disturbances.topRows(n));
  all_ = Whitening(sd, disturbances);
  setJacobian(jacobian);
}

Stage::Stage(const Stage& full, std::size_t without, const Eigen::MatrixXd& jacobian)
    : Stage(full) {
  const std::size_t cause = model_[without].cause;
  const auto before = settingsOf(causes_, model_);
  model_.erase(model_.begin() + static_cast<std::ptrdiff_t>(without));
  const auto settings = settingsOf(causes_, model_);
  raw_ -= (ensemble_.halves(settings, effort_.final_runs) -
           ensemble_.halves(before, effort_.final_runs))
              .mean();
  quick_base_ = ensemble_.halves(settings, effort_.look_runs, Over::Fit);
  look_base_ = ensemble_.roughHalves(settings, effort_.look_runs, Over::Fit);
  setJacobian(jacobian);
  for (Look& one : looks_) one.white = white(one.raw);
  lookAt(cause);
}

// What the model's numbers explain.
void Stage::setJacobian(const Eigen::MatrixXd& jacobian) {
  jacobian_ = jacobian;
  Eigen::MatrixXd own_fit(data_.fitSize(), jacobian.cols()), own_all(data_.size(), jacobian.cols());
  for (Eigen::Index i = 0; i < jacobian.cols(); ++i) {
    own_fit.col(i) = fit_(jacobian.col(i).head(data_.fitSize()));
    own_all.col(i) = all_(jacobian.col(i));
  }
  own_fit_ = orthonormal(own_fit);
  own_all_ = orthonormal(own_all);
}

bool Stage::isTaken(std::size_t cause) const {
  return std::find(given_.begin(), given_.end(), cause) != given_.end() || has(model_, cause);
}

// One run per motion tells which of many sizes is worth a look; what shapes them is nominal.
void Stage::scan(std::size_t cause) {
  const auto settings = settingsOf(causes_, model_);
  const Eigen::VectorXd before = ensemble_.rough(settings);
  std::vector<double> sizes = causes_[cause].scan;
  std::sort(sizes.begin(), sizes.end());
  const FreeNumber& number = causes_[cause].free[0];
  std::vector<double> x(causes_[cause].free.size(), 0);
  std::vector<Response> row;
  for (const double size : sizes) {
    if (size < number.lower || size > number.upper) continue;
    x[0] = size;
    CauseList with = model_;
    with.push_back({cause, x});
    row.push_back({size, white(ensemble_.rough(settingsOf(causes_, with)) - before)});
  }
  const SizeGain best = bestOnChords(row, white(raw_));
  x[0] = best.size;
  if (best.gain > 0) lookAt(cause, x);
}

void Stage::lookAround(const Stage* earlier) {
  for (std::size_t c = 0; c < causes_.size(); ++c) {
    if (isTaken(c) || (earlier != nullptr && takeLooks(*earlier, c))) continue;
    if (ensemble_.spent() && !startsOf(causes_[c]).empty()) {
      unseen_.push_back(c);
    } else {
      lookAt(c);
    }
  }
}

// False if it has none.
bool Stage::takeLooks(const Stage& earlier, std::size_t cause) {
  const std::size_t before = looks_.size();
  for (const Look& look : earlier.looks_) {
    if (look.cause != cause) continue;
    looks_.push_back(look);
    looks_.back().white = white(look.raw);
  }
  return looks_.size() > before;
}

void Stage::lookAt(std::size_t cause) {
  for (const std::vector<double>& x : startsOf(causes_[cause])) lookAt(cause, x);
  if (!causes_[cause].scan.empty()) scan(cause);
}

void Stage::lookAt(std::size_t cause, const std::vector<double>& x) {
  const Cause& what = causes_[cause];
  CauseList with = model_;
  with.push_back({cause, x});
  Look found{cause, x, {}, {}, 0, 0};
  found.raw =
      ensemble_.roughHalves(settingsOf(causes_, with), effort_.look_runs, Over::Fit) - look_base_;
  found.white = white(found.raw);
  const double to_lower = what.free[0].lower / x[0], to_upper = what.free[0].upper / x[0];
  found.lower = std::min(to_lower, to_upper);
  found.upper = std::max(to_lower, to_upper);
  if (!what.linear) {
    found.lower = std::max(0.0, found.lower);
    found.upper = std::min(kFurthest, found.upper);
  }
  looks_.push_back(std::move(found));
}

// Along which residuals may differ from white noise by one SD: the start of every motion, and what
// equal robots differ by.
Eigen::MatrixXd Stage::directions(const Effort& effort, double start_sd) {
  std::vector<Eigen::VectorXd> columns;
  for (const MotionSpan& span : data_.spans()) {
    Eigen::VectorXd late = Eigen::VectorXd::Zero(data_.size());
    const double sd = start_sd / std::sqrt(static_cast<double>(span.repeats));
    for (Eigen::Index s = 0; s < span.signals; ++s) {
      const Eigen::Index at = span.offset + s * span.rows;
      late.segment(at, span.rows) =
          sd * rateBetweenSamples(pool_.mean.segment(at, span.rows), span.dt);
    }
    columns.push_back(late);
  }
  addModel(columns);
  simulateDifferences(effort);
  for (const Halves& one : differences_) columns.push_back(one.first);
  Eigen::MatrixXd all(data_.size(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    all.col(static_cast<Eigen::Index>(i)) = columns[i];
  return all;
}

void Stage::simulateDifferences(const Effort& effort) {
  const Halves base = ensemble_.roughHalves(settingsOf(causes_, model_), effort.difference_runs);
  for (std::size_t c = 0; c < causes_.size(); ++c) {
    if (causes_[c].spread == 0 || isTaken(c)) continue;
    differences_.push_back(difference(causes_[c], causes_[c].joints, base, effort));
    undeclared_causes_.push_back(c);
  }
  for (const Cause& cause : causes_) {
    if (!cause.spread_beyond) continue;
    for (const Joint joint : ensemble_.carried()) {
      differences_.push_back(difference(cause, {joint}, base, effort));
    }
  }
}

// What one SD of a number that equal robots differ by changes. Before encoders round it: of a mean
// that moves by a tenth of a count, rounded readings are mostly chance.
Halves Stage::difference(const Cause& cause, const std::vector<Joint>& joints, const Halves& base,
                         const Effort& effort) {
  std::vector<double> x = startsOf(cause).front();
  const double wide = std::sqrt(3.0) * kWidely;  // SD
  x[0] = std::min(wide * cause.spread, cause.free[0].upper);
  std::vector<EffectSetting> settings = settingsOf(causes_, model_);
  settings.push_back(settingOf(cause, x));
  settings.back().joints = joints;
  const Halves with = ensemble_.roughHalves(settings, effort.difference_runs);
  return (with - base) * (cause.spread / x[0]);
}

// Of a number that is spread by one SD and a residual that holds it beside other disturbances, both
// whitened with it in them: mean and variance of what it is.
std::vector<SmallDifference> Stage::smallDifferences(const Eigen::VectorXd& raw) const {
  const Eigen::VectorXd residual = white(raw);
  std::vector<SmallDifference> found;
  for (std::size_t i = 0; i < undeclared_causes_.size(); ++i) {
    const Eigen::VectorXd direction = white(differences_[i].first);
    const double spread = causes_[undeclared_causes_[i]].spread;
    const double known = std::min(1.0, direction.squaredNorm());
    found.push_back({undeclared_causes_[i], spread * direction.dot(residual),
                     spread * std::sqrt(1 - known), known});
  }
  return found;
}

// The model's own numbers: what they may be off by is part of their intervals.
void Stage::addModel(std::vector<Eigen::VectorXd>& columns) const {
  Eigen::Index column = 0;
  for (const Chosen& one : model_) {
    const Cause& what = causes_[one.cause];
    const double spread = what.spreadAt(one.x[0]);
    if (spread > 0) columns.push_back(jacobian_.col(column) * spread);
    column += static_cast<Eigen::Index>(what.free.size());
  }
}

void Stage::simulateNulls(const std::string& joint) {
  for (int set = 0; set < effort_.null_sets; ++set) {
    const std::uint64_t seed = static_cast<std::uint64_t>(set) + 1;
    Random random(seed, "undeclared." + joint);
    Eigen::VectorXd residual = pool_.measuredAgain(data_, seed);
    for (Eigen::Index i = 0; i < residual.size(); ++i) {
      if (data_.rounding()[i] > 0) residual[i] += data_.rounding()[i] * random.normal();
    }
    for (const Halves& one : differences_) {
      residual += one.second * random.uniform(-std::sqrt(3.0), std::sqrt(3.0));
    }
    nulls_.push_back(std::move(residual));
  }
}

Eigen::VectorXd Stage::scatter() const {
  Eigen::VectorXd all(data_.size());
  for (std::size_t i = 0; i < data_.spans().size(); ++i) {
    const MotionSpan& span = data_.spans()[i];
    const Eigen::MatrixXd beside = pool_.deviations(i);
    all.segment(span.offset, span.size()) =
        (beside.rowwise().squaredNorm() / static_cast<double>(beside.cols())).cwiseSqrt();
  }
  return all;
}

Eigen::VectorXd Stage::whitenFit(const Eigen::VectorXd& raw) const {
  return fit_(raw.head(data_.fitSize()));
}

Eigen::VectorXd Stage::white(const Eigen::VectorXd& raw) const {
  return without(own_fit_, whitenFit(raw));
}

Halves Stage::white(const Halves& raw) const {
  return raw.through([this](const Eigen::VectorXd& half) { return white(half); });
}

Halves Stage::whitenFit(const Halves& raw) const {
  return raw.through([this](const Eigen::VectorXd& half) { return whitenFit(half); });
}

Eigen::VectorXd Stage::whiteAll(const Eigen::VectorXd& raw) const {
  return without(own_all_, all_(raw));
}

double Stage::gain(const Look& look, const Eigen::VectorXd& white, double* scale) {
  const Explained explained(look.white, white);
  if (explained.square() <= 0) return 0;
  const double best = std::clamp(explained.bestScale(), look.lower, look.upper);
  if (scale != nullptr) *scale = best;
  return explained.gain(best);
}

double Stage::largestGain(const Eigen::VectorXd& white) const {
  double largest = 0;
  for (const Look& one : looks_) largest = std::max(largest, gain(one, white));
  return largest;
}

}  // namespace nao::validation
