#include "validation/diagnosis/whole/whole_stage.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/whole/whole_scatter.h"

namespace nao::validation {
namespace {

constexpr std::size_t kAllRuns = 1000000;

std::uint64_t number(WholeStream stream) { return static_cast<std::uint64_t>(stream); }

// By the largest block; of those held back alone.
int runsPerMeasured(const WholeData& data, int runs, bool held = false) {
  std::size_t most = 1;
  for (const WholeBlock& block : data.simulator().blocks()) {
    if (!held || block.split != Split::Fit) most = std::max(most, block.runs.size());
  }
  return perRun(runs, most);
}

WholePool simulate(const WholeTask& task, const CauseList& model, WholeStream stream) {
  const int runs = std::max(4, runsPerMeasured(*task.data, task.effort.base_runs));
  return startedAlike(
      *task.data, task.data->simulate(settingsOf(*task.causes, model), runs, kAllRuns, Blocks::All,
                                      number(stream), task.noise, task.jobs));
}

Eigen::VectorXd residual(const WholeData& data, const std::vector<Eigen::VectorXd>& means) {
  std::vector<Eigen::VectorXd> difference(data.runs());
  for (std::size_t run = 0; run < data.runs(); ++run) {
    if (means[run].size() > 0) difference[run] = data.measured(run) - means[run];
  }
  return data.stackMeans(difference);
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  if (columns.cols() == 0) return columns;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
}

Eigen::VectorXd without(const Eigen::MatrixXd& basis, Eigen::VectorXd vector) {
  if (basis.cols() == 0) return vector;
  const Eigen::VectorXd along = basis.transpose() * vector;
  vector -= basis * along;
  return vector;
}

// A look serves both signs where the response is nearly linear.
bool needsStart(const Cause& cause, const std::vector<double>& start) {
  const bool first = start[0] == cause.free[0].starts[0];
  const double size = start[0];
  if (size < cause.free[0].lower || size > cause.free[0].upper) return false;
  return first || !cause.linear || cause.gross || cause.free.size() > 1;
}

}  // namespace

std::vector<EffectSetting> settingsOf(const std::vector<PlacedCause>& causes,
                                      const CauseList& model) {
  std::vector<EffectSetting> settings;
  for (const Chosen& chosen : model) {
    settings.push_back(causes[chosen.cause].setting(chosen.x));
  }
  return settings;
}

WholePool fitRuns(const WholeTask& task, const CauseList& model, Blocks blocks, int jobs) {
  const int runs = blocks == Blocks::Held
                       ? runsPerMeasured(*task.data, task.effort.base_runs / 2, true)
                       : runsPerMeasured(*task.data, task.effort.fit_runs);
  return task.data->simulate(settingsOf(*task.causes, model), runs, kAllRuns, blocks,
                             number(WholeStream::Base), task.noise, jobs, Pace::Coarse);
}

WholePool slopeRuns(const WholeTask& task, const CauseList& model) {
  return task.data->simulate(settingsOf(*task.causes, model),
                             std::max(2, runsPerMeasured(*task.data, task.effort.fit_runs)),
                             kAllRuns, Blocks::All, number(WholeStream::Base), task.noise,
                             task.jobs, Pace::Coarse);
}

WholePool lookRuns(const WholeTask& task, const CauseList& model, int jobs) {
  return task.data->simulate(settingsOf(*task.causes, model), 1,
                             static_cast<std::size_t>(task.effort.look_runs), Blocks::Fit,
                             number(WholeStream::Base), task.noise, jobs, Pace::Coarse);
}

void learnStepErrors(const WholeTask& task, const CauseList& model) {
  task.data->learnStepErrors(settingsOf(*task.causes, model), task.effort.step_runs, task.noise,
                             task.jobs);
}

Eigen::VectorXd manyRunsResidual(const WholeTask& task, const CauseList& model) {
  return residual(*task.data, meansOf(simulate(task, model, WholeStream::Base)));
}

WholeStage::WholeStage(const WholeTask& task, CauseList model, const Eigen::MatrixXd& jacobian,
                       const WholeStage* before)
    : task_(task),
      model_(std::move(model)),
      pool_(simulate(task_, model_, WholeStream::Base)),
      noise_(*task_.data, pool_) {
  const WholeData& data = *task_.data;
  const std::vector<Eigen::VectorXd> means = meansOf(pool_);
  raw_ = residual(data, means);
  if (data.hasCoarse()) {
    coarse_means_ = data.stackMeans(meansOf(fitRuns(task_, model_, Blocks::All, task_.jobs)));
  }
  const std::vector<Eigen::VectorXd> first = meansOf(lookRuns(task_, model_, task_.jobs));
  if (data.hasCoarse()) rough_means_ = data.stackMeans(first);
  if (before) {
    takeLooks(*before, first);
  } else {
    lookAtAll(first);
  }
  gatherUndeclared();
  Eigen::MatrixXd directions(data.size(), noise_.directions().cols() + undeclared_.cols());
  directions << noise_.directions(), undeclared_;
  all_ = Whitening(noise_.sd(), directions);
  const Eigen::Index fit = data.fitSize();
  fit_ = Whitening(noise_.sd().head(fit), directions.topRows(fit));
  Eigen::MatrixXd own(data.size(), jacobian.cols()), own_fit(fit, jacobian.cols());
  for (Eigen::Index i = 0; i < jacobian.cols(); ++i) {
    own.col(i) = whitenAll(jacobian.col(i));
    own_fit.col(i) = whitenFit(jacobian.col(i));
  }
  own_all_ = orthonormal(own);
  own_fit_ = orthonormal(own_fit);
  inParallel(looks_.size(), task_.jobs,
             [&](std::size_t i) { looks_[i].white = white(looks_[i].raw); });
  simulateNulls(means);
}

// `base`: the first runs of the model, by the streams that a look has too.
void WholeStage::lookAtAll(const std::vector<Eigen::VectorXd>& base) {
  struct Order {
    std::size_t cause;
    std::vector<double> x;
  };
  std::vector<Order> orders;
  for (std::size_t c = 0; c < task_.causes->size(); ++c) {
    const Cause& cause = (*task_.causes)[c].cause;
    if (has(model_, c)) continue;
    for (const std::vector<double>& start : startsOf(cause)) {
      if (needsStart(cause, start)) orders.push_back({c, start});
    }
  }
  // What the budget does not pay for is told, not left out in silence.
  const long each = static_cast<long>(task_.effort.look_runs) *
                    static_cast<long>(task_.data->simulator().blocks().size());
  const long paid = std::max(0L, (task_.granted - task_.data->used()) / std::max(1L, each));
  while (static_cast<long>(orders.size()) > paid) {
    if (not_tried_.empty() || not_tried_.back() != orders.back().cause) {
      not_tried_.push_back(orders.back().cause);
    }
    orders.pop_back();
  }
  looks_.resize(orders.size());
  inParallel(orders.size(), task_.jobs,
             [&](std::size_t i) { looks_[i] = look(orders[i].cause, orders[i].x, base); });
}

// What equal robots differ by shows otherwise beside a gross cause (on a slippery floor): these
// looks are taken anew.
void WholeStage::takeLooks(const WholeStage& before, const std::vector<Eigen::VectorXd>& base) {
  for (const WholeLook& look : before.looks_) {
    if (!has(model_, look.cause)) looks_.push_back(look);
  }
  inParallel(looks_.size(), task_.jobs, [&](std::size_t i) {
    const WholeLook old = looks_[i];
    if ((*task_.causes)[old.cause].cause.spread > 0) looks_[i] = look(old.cause, old.x, base);
  });
}

WholeLook WholeStage::look(std::size_t cause, const std::vector<double>& x,
                           const std::vector<Eigen::VectorXd>& base) const {
  CauseList with = model_;
  with.push_back({cause, x});
  const WholePool pool = lookRuns(task_, with, 1);
  std::vector<Eigen::VectorXd> change(base.size());
  for (std::size_t run = 0; run < base.size(); ++run) {
    if (base[run].size() > 0 && !pool[run].empty()) change[run] = pool[run].front() - base[run];
  }
  WholeLook look{cause, x, task_.data->stackMeans(change), {}, 0, 0};
  const Cause& of = (*task_.causes)[cause].cause;
  const double low = of.free[0].lower / x[0], high = of.free[0].upper / x[0];
  look.lower = of.linear ? std::min(low, high) : 0;
  look.upper = std::max(low, high);
  return look;
}

void WholeStage::simulateNulls(const std::vector<Eigen::VectorXd>& means) {
  const WholeData& data = *task_.data;
  const WholePool pool = simulate(task_, model_, WholeStream::Null);
  Random random(7, "null sets");
  for (int set = 0; set < task_.effort.null_sets; ++set) {
    std::vector<Eigen::VectorXd> drawn(data.runs());
    for (std::size_t run = 0; run < data.runs(); ++run) {
      if (pool[run].empty() || means[run].size() == 0) continue;
      const auto pick =
          static_cast<std::size_t>(random.uniform() * static_cast<double>(pool[run].size()));
      drawn[run] = pool[run][pick] - means[run];
    }
    Eigen::VectorXd null = noise_.raised().cwiseProduct(data.stackMeans(drawn));
    for (Eigen::Index i = 0; i < undeclared_.cols(); ++i) {
      null += random.normal() * undeclared_.col(i);
    }
    nulls_.push_back(std::move(null));
  }
}

double WholeStage::simulatedPerRun() const {
  double sum = 0;
  for (const auto& runs : pool_) sum += static_cast<double>(runs.size());
  return sum / static_cast<double>(pool_.size());
}

Eigen::VectorXd WholeStage::whitenFit(const Eigen::VectorXd& raw) const {
  return fit_(raw.head(task_.data->fitSize()));
}
Eigen::VectorXd WholeStage::white(const Eigen::VectorXd& raw) const {
  return beside(whitenFit(raw));
}
Eigen::VectorXd WholeStage::beside(const Eigen::VectorXd& whitened) const {
  return without(own_fit_, whitened);
}
Eigen::VectorXd WholeStage::whiteAll(const Eigen::VectorXd& raw) const {
  return without(own_all_, whitenAll(raw));
}

double WholeStage::gain(const WholeLook& look, const Eigen::VectorXd& white, double* scale) {
  const double along = look.white.dot(white), square = look.white.squaredNorm();
  double best = square > 0 ? along / square : 0;
  best = std::clamp(best, look.lower, look.upper);
  if (scale) *scale = best;
  return best * along - best * best * square / 2;
}

std::vector<double> WholeStage::nullGains() const {
  std::vector<double> gains(nulls_.size());
  inParallel(nulls_.size(), task_.jobs, [&](std::size_t n) {
    const Eigen::VectorXd residual = white(nulls_[n]);
    for (const WholeLook& look : looks_) gains[n] = std::max(gains[n], gain(look, residual));
  });
  return gains;
}

std::vector<double> WholeStage::nullMisfits() const {
  std::vector<double> misfits(nulls_.size());
  inParallel(nulls_.size(), task_.jobs, [&](std::size_t n) {
    misfits[n] = whiteAll(nulls_[n]).squaredNorm() / static_cast<double>(nulls_[n].size());
  });
  return misfits;
}

}  // namespace nao::validation
