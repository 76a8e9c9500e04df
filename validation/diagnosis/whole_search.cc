#include "validation/diagnosis/whole_search.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "validation/diagnosis/joint_search.h"
#include "validation/diagnosis/least_squares.h"
#include "validation/diagnosis/shared_cause.h"

namespace nao::validation {
namespace {

constexpr std::size_t kAllRuns = 1000000;
// Of a fit: one number moves nearly straight to its place, several along valleys.
constexpr int kIterations = 3, kIterationsOfSeveral = 10;
// Of the excess misfit, that a cause must explain at least; as at the joint level.
constexpr double kLeastShare = 0.03;
// Replaying commands leaves out what the walk's own feedback would have made of each run's chance,
// and how a robot came to stand where it begins: an estimate, no series of nulls has set it yet.
constexpr double kModelError = 1.5;
// 99 % of chi-square with one degree of freedom, maximised over about ten independent looks, half:
// what the threshold would be if the noise were white [nats].
constexpr double kWhiteThreshold = 6;

// All numbers of a model in one row, and back.
std::vector<double> flat(const WholeModel& model) {
  std::vector<double> x;
  for (const WholeChosen& one : model) x.insert(x.end(), one.x.begin(), one.x.end());
  return x;
}
WholeModel withNumbers(WholeModel model, const std::vector<double>& x) {
  std::size_t at = 0;
  for (WholeChosen& one : model) {
    for (double& number : one.x) number = x[at++];
  }
  return model;
}

double stepOf(const FreeNumber& number, double x) {
  return std::max({number.smallest / 2, 0.05 * std::abs(x), 1e-6});
}

FitSpace spaceOf(const std::vector<PlacedCause>& causes, const WholeModel& model) {
  FitSpace space;
  const bool several = flat(model).size() > 1;
  space.iterations = several ? kIterationsOfSeveral : kIterations;
  for (const WholeChosen& one : model) {
    for (std::size_t i = 0; i < one.x.size(); ++i) {
      const FreeNumber& number = causes[one.cause].cause.free[i];
      space.start.push_back(std::clamp(one.x[i], number.lower, number.upper));
      space.lower.push_back(number.lower);
      space.upper.push_back(number.upper);
      space.step.push_back(stepOf(number, one.x[i]));
    }
  }
  return space;
}

}  // namespace

WholeSearch::WholeSearch(const WholeTask& task, Progress progress, double false_alarms)
    : task_(task), progress_(std::move(progress)), false_alarms_(false_alarms) {}

WholeVerdict WholeSearch::run() {
  enter({});
  misfit_before_ =
      stage_->whiteAll(stage_->raw()).squaredNorm() / static_cast<double>(task_.data->size());
  while (static_cast<int>(fit_.model.size()) < task_.effort.most_causes && step()) review();
  WholeVerdict verdict;
  judge(verdict);
  describe(verdict);
  return verdict;
}

void WholeSearch::enter(const Fit& fit) {
  fit_ = fit;
  if (fit_.jacobian.cols() == 0) fit_.jacobian.resize(task_.data->size(), 0);
  const std::string what = fit_.model.empty() ? "looking at every cause" : "simulating the model";
  tell(what + " and what it shows by chance");
  stage_ = std::make_unique<WholeStage>(task_, fit_.model, fit_.jacobian, stage_.get());
  critical_ = quantile(stage_->nullGains(), 1 - false_alarms_);
  spread_of_gain_ = std::max(1.0, critical_ / kWhiteThreshold);
  for (const std::size_t cause : stage_->notTried()) not_tried_.push_back(labelOf(cause, ""));
  fit_.residual = stage_->whitenFit(simulatedResidual(fit_.model, true));
  fit_.cost = fit_.residual.squaredNorm() / 2;
}

Eigen::VectorXd WholeSearch::simulatedResidual(const WholeModel& model, bool fit_only) const {
  const WholeData& data = *task_.data;
  std::size_t most = 1;
  for (const WholeBlock& block : data.simulator().blocks()) {
    most = std::max(most, block.runs.size());
  }
  const auto means = meansOf(
      data.simulate(settingsOf(*task_.causes, model), perRun(task_.effort.fit_runs, most), kAllRuns,
                    fit_only, static_cast<std::uint64_t>(WholeStream::Base), task_.noise, 1));
  std::vector<Eigen::VectorXd> difference(data.runs());
  for (std::size_t run = 0; run < data.runs(); ++run) {
    if (means[run].size() > 0) difference[run] = data.measured(run) - means[run];
  }
  return data.stackMeans(difference);
}

WholeSearch::Fit WholeSearch::fitModel(const WholeModel& start) const {
  const auto residual = [&](const std::vector<double>& x) {
    return stage_->whitenFit(simulatedResidual(withNumbers(start, x), true));
  };
  const FitPoint point = leastSquares(residual, spaceOf(*task_.causes, start));
  return {withNumbers(start, point.x), point.residual, {}, point.cost};
}

// From where the look would be best, or from where it was taken, whichever is nearer.
WholeSearch::Fit WholeSearch::fitFrom(const WholeLook& look, double scale) const {
  WholeModel scaled = fit_.model, taken = fit_.model;
  taken.push_back({look.cause, look.x});
  scaled.push_back({look.cause, look.x});
  scaled.back().x[0] *= scale;
  const auto costOf = [&](const WholeModel& model) {
    return stage_->whitenFit(simulatedResidual(model, true)).squaredNorm();
  };
  return fitModel(costOf(scaled) <= costOf(taken) ? scaled : taken);
}

std::vector<WholeSearch::Candidate> WholeSearch::rank() {
  const Eigen::VectorXd white = stage_->white(stage_->raw());
  struct Best {
    double gain = 0, scale = 0;
    const WholeLook* look = nullptr;
  };
  std::map<std::size_t, Best> best;
  for (const WholeLook& look : stage_->looks()) {
    double scale = 0;
    const double gain = WholeStage::gain(look, white, &scale);
    if (gain > best[look.cause].gain) best[look.cause] = {gain, scale, &look};
  }
  std::vector<Best> looks;
  for (const auto& [cause, one] : best) {
    if (one.look) looks.push_back(one);
  }
  std::stable_sort(looks.begin(), looks.end(),
                   [](const Best& a, const Best& b) { return a.gain > b.gain; });
  const double least = looks.empty() ? 0 : std::max(critical_ / 3, 0.1 * looks.front().gain);
  std::vector<Best> finalists;
  for (const Best& one : looks) {
    if (one.gain >= least && static_cast<int>(finalists.size()) < task_.effort.finalists) {
      finalists.push_back(one);
    } else if (one.gain > critical_ / 3) {
      rejected_.push_back({labelOf(one.look->cause, ""), one.gain, "others promise more"});
    }
  }
  if (!finalists.empty()) tell("fitting " + std::to_string(finalists.size()) + " causes");
  if (task_.data->used() > task_.granted) {
    for (const Best& one : finalists) not_tried_.push_back(labelOf(one.look->cause, ""));
    finalists.clear();
  }
  std::vector<Candidate> ranking(finalists.size());
  inParallel(finalists.size(), task_.jobs, [&](std::size_t i) {
    ranking[i].cause = finalists[i].look->cause;
    ranking[i].fit = fitFrom(*finalists[i].look, finalists[i].scale);
    ranking[i].gain = fit_.cost - ranking[i].fit.cost;
  });
  std::stable_sort(ranking.begin(), ranking.end(),
                   [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
  return ranking;
}

bool WholeSearch::step() { return accept(rank()); }

bool WholeSearch::accept(const std::vector<Candidate>& ranking) {
  for (const Candidate& candidate : ranking) {
    const double held_out = candidate.gain > critical_ ? heldOut(candidate.fit.model) : 0;
    const std::string reason = objection(candidate, held_out);
    if (!reason.empty()) {
      rejected_.push_back({labelOf(candidate.cause, ""), candidate.gain, reason});
      continue;
    }
    Accepted accepted;
    accepted.gain = candidate.gain;
    accepted.held_out = std::isnan(held_out) ? 0 : held_out;
    accepted.folds = std::isnan(held_out) ? 0 : 1;
    accepted.folds_better = accepted.folds;
    accepted.share =
        candidate.gain / std::max(1e-9, fit_.cost - static_cast<double>(fit_.residual.size()) / 4);
    accepted.rivals = rivalsOf(ranking, candidate);
    for (const Candidate& other : ranking) {
      if (&other != &candidate && other.gain > critical_ && accepted.others.size() < 3) {
        accepted.others.push_back(other.fit.model.back());
      }
    }
    accepted_.push_back(accepted);
    Fit next = candidate.fit;
    next.jacobian = jacobianOf(next.model);
    enter(next);
    return true;
  }
  return false;
}

Eigen::MatrixXd WholeSearch::jacobianOf(const WholeModel& model) const {
  const FitSpace space = spaceOf(*task_.causes, model);
  const std::vector<double> x = flat(model);
  std::vector<Eigen::VectorXd> residual(x.size() + 1);
  std::vector<double> step(x.size(), 0);
  inParallel(x.size() + 1, task_.jobs, [&](std::size_t i) {
    std::vector<double> beside = x;
    if (i < x.size()) {
      step[i] = differenceStep(space, i, x[i]);
      beside[i] += step[i];
    }
    residual[i] = simulatedResidual(withNumbers(model, beside), false);
  });
  Eigen::MatrixXd jacobian(task_.data->size(), static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) {
    jacobian.col(static_cast<Eigen::Index>(i)) = (residual.back() - residual[i]) / step[i];
  }
  return jacobian;
}

// Of the select blocks; not a number if there is none or the cause does nothing there.
double WholeSearch::heldOut(const WholeModel& model) const {
  const Eigen::Index held = task_.data->size() - task_.data->fitSize();
  if (held == 0) return std::numeric_limits<double>::quiet_NaN();
  const auto tailOf = [&](const WholeModel& of) {
    return stage_->whitenAll(simulatedResidual(of, false)).tail(held).eval();
  };
  const Eigen::VectorXd before = tailOf(fit_.model), after = tailOf(model);
  if ((before - after).norm() < 2) return std::numeric_limits<double>::quiet_NaN();
  return (before.squaredNorm() - after.squaredNorm()) / 2;
}

std::string WholeSearch::objection(const Candidate& candidate, double held_out) const {
  if (candidate.gain <= critical_) return "below the threshold";
  if (held_out <= 0) return "does not predict the motions held back";
  const double excess = fit_.cost - static_cast<double>(fit_.residual.size()) / 4;
  if (excess > 0 && candidate.gain < kLeastShare * excess) return "explains too little";
  return "";
}

std::vector<Rival> WholeSearch::rivalsOf(const std::vector<Candidate>& ranking,
                                         const Candidate& best) const {
  std::vector<Rival> rivals;
  for (const Candidate& other : ranking) {
    const double behind = best.gain - other.gain;
    if (&other == &best || other.gain <= critical_ || behind < 0) continue;
    const double apart = (best.fit.residual - other.fit.residual).norm();
    const double reach = std::max(3 * spread_of_gain_, 1.5 * apart * std::sqrt(spread_of_gain_));
    if (behind > reach) continue;
    rivals.push_back({labelOf(other.cause, placed(best.cause).place),
                      numbersOf(other.fit.model.back()), behind});
  }
  return rivals;
}

// Every cause competes again once another one has joined: it must still be needed, and be better
// than those that were fitted beside it.
void WholeSearch::review() {
  for (std::size_t place = 0; place + 1 < fit_.model.size();) {
    WholeModel without = fit_.model;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(place));
    tell("reviewing " + placed(fit_.model[place].cause).cause.id);
    Fit less = fitModel(without);
    const double gain = less.cost - fit_.cost;
    if (gain < critical_) {
      rejected_.push_back({labelOf(fit_.model[place].cause, ""), gain, "no longer needed"});
      accepted_.erase(accepted_.begin() + static_cast<std::ptrdiff_t>(place));
      less.jacobian = jacobianOf(less.model);
      enter(less);
      place = 0;
      continue;
    }
    accepted_[place].gain = gain;
    swapOne(place);
    ++place;
  }
}

bool WholeSearch::swapOne(std::size_t place) {
  const std::vector<WholeChosen> others = accepted_[place].others;
  for (const WholeChosen& other : others) {
    WholeModel swapped = fit_.model;
    swapped[place] = other;
    Fit fit = fitModel(swapped);
    if (fit.cost > fit_.cost - 3 * spread_of_gain_) continue;
    rejected_.push_back({labelOf(fit_.model[place].cause, ""), fit.cost - fit_.cost,
                         "replaced by " + labelOf(other.cause, "")});
    accepted_[place].rivals.clear();
    fit.jacobian = jacobianOf(fit.model);
    enter(fit);
    return true;
  }
  return false;
}

void WholeSearch::judge(WholeVerdict& verdict) const {
  const std::vector<double> nulls = stage_->nullMisfits();
  const double middle = quantile(nulls, 0.5);
  verdict.critical_gain = critical_;
  verdict.misfit_before = misfit_before_ / middle;
  verdict.misfit_after = stage_->whiteAll(stage_->raw()).squaredNorm() /
                         static_cast<double>(task_.data->size()) / middle;
  verdict.remainder = verdict.misfit_after;
  verdict.remainder_critical = quantile(nulls, 1 - false_alarms_) / middle * kModelError;
  bool named = false, ambiguous = false;
  const Eigen::MatrixXd draws = drawNumbers();
  for (std::size_t place = 0; place < fit_.model.size(); ++place) {
    verdict.findings.push_back(finding(place, draws));
    const Finding& found = verdict.findings.back().finding;
    named = named || !found.small;
    ambiguous = ambiguous || (!found.small && !found.rivals.empty());
  }
  const bool remains = verdict.remainder > verdict.remainder_critical;
  if (remains) {
    verdict.signature = signature();
    verdict.verdict = named ? Verdict::PartlyExplained : Verdict::Unknown;
  } else if (named) {
    verdict.verdict = ambiguous ? Verdict::Ambiguous : Verdict::Named;
  }
}

void WholeSearch::describe(WholeVerdict& verdict) const {
  verdict.rejected = rejected_;
  verdict.model = fit_.model;
  verdict.not_tried = not_tried_;
  if (!not_tried_.empty()) verdict.verdict = Verdict::Unfinished;
}

// What the numbers of the model would be in each null set: one Gauss-Newton step.
Eigen::MatrixXd WholeSearch::drawNumbers() const {
  const Eigen::Index n = fit_.jacobian.cols();
  Eigen::MatrixXd draws(n, static_cast<Eigen::Index>(stage_->nulls().size()));
  if (n == 0) return draws;
  Eigen::MatrixXd white(task_.data->fitSize(), n);
  for (Eigen::Index i = 0; i < n; ++i) white.col(i) = stage_->whitenFit(fit_.jacobian.col(i));
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solve(white);
  for (Eigen::Index set = 0; set < draws.cols(); ++set) {
    draws.col(set) = solve.solve(stage_->whitenFit(stage_->nulls()[static_cast<std::size_t>(set)]));
  }
  return draws;
}

std::vector<FoundNumber> WholeSearch::numbersOf(const WholeChosen& chosen) const {
  std::vector<FoundNumber> numbers;
  for (std::size_t i = 0; i < chosen.x.size(); ++i) {
    const FreeNumber& free = placed(chosen.cause).cause.free[i];
    numbers.push_back({free.parameter, free.unit, shownValue(free, chosen.x[i]), chosen.x[i],
                       chosen.x[i], chosen.x[i]});
  }
  return numbers;
}

PlacedFinding WholeSearch::finding(std::size_t place, const Eigen::MatrixXd& draws) const {
  const WholeChosen& chosen = fit_.model[place];
  const PlacedCause& cause = placed(chosen.cause);
  Finding found;
  found.cause = cause.cause.id;
  found.effect = cause.cause.effect;
  found.numbers = numbersOf(chosen);
  Eigen::Index row = 0;
  for (std::size_t before = 0; before < place; ++before) {
    row += static_cast<Eigen::Index>(fit_.model[before].x.size());
  }
  for (FoundNumber& number : found.numbers) {
    const Eigen::VectorXd drawn = draws.row(row++);
    const std::vector<double> values(drawn.data(), drawn.data() + drawn.size());
    number.low = number.deviation + quantile(values, 0.05);
    number.high = number.deviation + quantile(values, 0.95);
  }
  const Accepted& accepted = accepted_[place];
  found.gain = accepted.gain;
  found.share = std::min(1.0, accepted.share);
  found.folds = accepted.folds;
  found.folds_better = accepted.folds_better;
  found.held_out_gain = accepted.held_out;
  found.one_motion_only = accepted.folds == 0;
  found.small = std::abs(chosen.x[0]) < cause.cause.free[0].smallest;
  found.rivals = accepted.rivals;
  found.sentence = cause.sentence(valueText(found.numbers[0]));
  found.experiment = cause.cause.separate;
  return {found, cause.place};
}

std::string WholeSearch::labelOf(std::size_t cause, const std::string& beside) const {
  const PlacedCause& of = placed(cause);
  return of.place == beside ? of.cause.id : of.cause.id + " at " + of.place;
}

// The three signals that remain most, by what they have beyond noise.
std::string WholeSearch::signature() const {
  const Eigen::VectorXd white = stage_->whiteAll(stage_->raw());
  std::map<std::string, double> excess;
  for (std::size_t block = 0; block < task_.data->spaces().size(); ++block) {
    for (const FeatureGroup& group : task_.data->spaces()[block].groups()) {
      const auto part = white.segment(task_.data->offsets()[block] + group.offset, group.size);
      excess[group.name] += part.squaredNorm() - static_cast<double>(group.size);
    }
  }
  std::vector<std::pair<double, std::string>> worst;
  for (const auto& [name, value] : excess) worst.push_back({-value, name});
  std::sort(worst.begin(), worst.end());
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, worst.size()); ++i) {
    text += (i > 0 ? ", " : "") + worst[i].second;
  }
  return text;
}

void WholeSearch::tell(const std::string& what) const {
  if (progress_) progress_(what);
}

}  // namespace nao::validation
