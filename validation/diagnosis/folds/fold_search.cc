#include "validation/diagnosis/folds/fold_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "validation/diagnosis/maths/block_bootstrap.h"

namespace nao::validation {
namespace {

constexpr double kSame = 0.03;        // of the gain: rivals within it are not told apart
constexpr int kSwaps = 3;             // causes that compete for the place of another
constexpr int kRounds = 8;            // of growth and review: more is going in circles
constexpr std::size_t kManyLogs = 8;  // as blocks of their own; fewer are cut into seconds
constexpr std::uint64_t kSeed = 1;
constexpr double kRounding = 3;  // times the encoder's rounding: less is no remainder

class FoldSearch {
 public:
  FoldSearch(const JointSimulator& joint, const std::vector<Cause>& causes,
             const FoldSearchOptions& options)
      : joint_(joint),
        options_(options),
        fits_(joint, causes, foldsOf(joint, options.gains), options.fit, options.jobs),
        causes_(fits_.causes()),
        folds_(fits_.folds()),
        model_(fits_.empty()) {}

  FoldDiagnosis run() {
    FoldDiagnosis found;
    found.before = model_.errors;
    for (int round = 0; round < kRounds; ++round) {
      while (static_cast<int>(model_.of_all.size()) < options_.most_causes && grow()) {
      }
      if (!review()) break;
    }
    found.folds = folds_;
    found.after = model_.errors;
    describe(found);
    return found;
  }

 private:
  // Asked between searches alone, where the count is the same for any number of threads.
  bool isCutOff() {
    cut_off_ = fits_.fit().used() >= options_.granted;
    return cut_off_;
  }

  bool helps(const FoldErrors& before, const FoldErrors& after) const {
    std::size_t better = 0;
    for (std::size_t f = 0; f < folds_.size(); ++f) {
      if (after.held_out[f] < before.held_out[f]) ++better;
    }
    return 2 * better > folds_.size() && after.mean() < (1 - options_.least_gain) * before.mean();
  }

  bool grow() {
    if (isCutOff()) return false;
    const std::vector<FoldTried> tried =
        fits_.tryAll(model_, fits_.screened(model_, options_.tried));
    const FoldErrors before = model_.errors;
    for (const FoldTried& one : tried) {
      if (!helps(before, one.model.errors)) continue;
      take(one, tried, before.mean());
      return true;
    }
    for (const FoldTried& one : tried) held_back_[one.cause] = one.model.errors.mean();
    return false;
  }

  void take(const FoldTried& chosen, const std::vector<FoldTried>& tried, double before) {
    accepted_.push_back(chosen.cause);
    setRivals(chosen, tried, before);
    model_ = chosen.model;
    tell(causes_[chosen.cause].id);
  }

  void setRivals(const FoldTried& chosen, const std::vector<FoldTried>& tried, double before) {
    rivals_[chosen.cause].clear();
    const double gain = before - chosen.model.errors.mean();
    for (const FoldTried& other : tried) {
      const double behind = other.model.errors.mean() - chosen.model.errors.mean();
      if (other.cause == chosen.cause || behind > kSame * gain || behind < 0) continue;
      const Cause& cause = causes_[other.cause];
      rivals_[chosen.cause].push_back({cause.id, cause.effect, "",
                                       foundNumbers(cause, other.model.of_all.back().x),
                                       1e3 * behind});
    }
  }

  void tell(const std::string& what) const {
    if (!options_.progress) return;
    char text[128];
    std::snprintf(text, sizeof text, "%s: held-out error %.2f mrad", what.c_str(),
                  1e3 * model_.errors.mean());
    options_.progress(text);
  }

  // Takes out the cause without which the folds are predicted best, unless that is worse; else
  // every cause competes once more with others for its place. True if the model changed.
  bool review() {
    if (model_.of_all.size() < 2 || isCutOff()) return false;
    const std::vector<FoldModel> without = fits_.withoutEach(model_);
    for (std::size_t i = 0; i < without.size(); ++i) {
      lost_[accepted_[i]] = {without[i].errors, model_.errors};
    }
    std::size_t best = 0;
    for (std::size_t i = 0; i < without.size(); ++i) {
      if (without[i].errors.mean() < without[best].errors.mean()) best = i;
    }
    if (!helps(without[best].errors, model_.errors)) {
      drop(best, without[best], "without ");
      return true;
    }
    for (std::size_t i = 0; i < without.size(); ++i) {
      const auto tried = fits_.tryAll(without[i], fits_.screened(without[i], kSwaps));
      if (tried.empty() || !helps(model_.errors, tried.front().model.errors)) continue;
      drop(i, tried.front().model, "in its place ");
      take(tried.front(), tried, without[i].errors.mean());
      return true;
    }
    return false;
  }

  void drop(std::size_t place, const FoldModel& model, const std::string& how) {
    const std::size_t cause = accepted_[place];
    dropped_.push_back(cause);
    accepted_.erase(accepted_.begin() + static_cast<std::ptrdiff_t>(place));
    model_ = model;
    tell(how + causes_[cause].id);
  }

  void describe(FoldDiagnosis& found) {
    JointVerdict& verdict = found.verdict;
    verdict.joint = joint_.joint();
    verdict.with_repeats = false;
    verdict.repeats = 1;
    MotionFit::Result fit = fits_.fit().fit(model_.of_all, fits_.all());
    fits_.fit().linearise(fit, fits_.all());
    found.fitted = fit.residual.cwiseAbs().mean();
    const Eigen::MatrixXd moves = movesOf(fit);
    Eigen::Index column = 0;
    for (const Chosen& one : fit.model) {
      Finding finding = findingOf(one);
      for (FoundNumber& number : finding.numbers) {
        const Eigen::VectorXd move = moves.col(column++);
        number.low = number.deviation + quantileOf(move, 0.05);
        number.high = number.deviation + quantileOf(move, 0.95);
      }
      const FoundNumber& size = finding.numbers[0];
      finding.small = mayBeSmall(size.low, size.high, causes_[one.cause].free[0].smallest);
      verdict.findings.push_back(std::move(finding));
    }
    reject(verdict);
    judge(found, fit.residual);
  }

  Eigen::MatrixXd movesOf(const MotionFit::Result& fit) const {
    if (fit.model.empty()) return {};
    std::vector<SampleBlock> logs;
    Eigen::Index at = 0;
    for (const std::size_t m : fits_.all()) {
      logs.push_back({at, joint_.measured()[m].repeats.front().rows()});
      at += logs.back().size;
    }
    const auto second = static_cast<Eigen::Index>(1 / joint_.measured()[fits_.all().front()].dt);
    return bootstrapMoves(fit.jacobian, fit.residual, fits_.fit().weights(fit.residual),
                          blocksOf(logs, kManyLogs, second), options_.sets, kSeed);
  }

  Finding findingOf(const Chosen& one) {
    const Cause& cause = causes_[one.cause];
    Finding finding;
    finding.cause = cause.id;
    finding.effect = cause.effect;
    finding.numbers = foundNumbers(cause, one.x);
    finding.folds = static_cast<int>(folds_.size());
    const auto lost = lost_.find(one.cause);
    if (lost != lost_.end()) {
      const auto& [without, with] = lost->second;
      for (std::size_t f = 0; f < folds_.size(); ++f) {
        if (with.held_out[f] < without.held_out[f]) ++finding.folds_better;
      }
      finding.share = 1 - with.mean() / without.mean();
    }
    finding.rivals = rivals_[one.cause];
    finding.sentence = cause.fill(joint_.joint(), valueText(finding.numbers[0]));
    finding.experiment = cause.separate;
    return finding;
  }

  void reject(JointVerdict& verdict) const {
    for (const std::size_t c : dropped_) {
      verdict.rejected.push_back({causes_[c].id, 0, "no longer needed beside the others"});
    }
    for (const auto& [cause, error] : held_back_) {
      verdict.rejected.push_back(
          {causes_[cause].id, 0, "does not predict the folds that it was not fitted to"});
    }
    for (std::size_t c = 0; c < causes_.size(); ++c) {
      const bool told = has(c) || held_back_.count(c) > 0 ||
                        std::find(dropped_.begin(), dropped_.end(), c) != dropped_.end();
      if (told) continue;
      if (cut_off_) {
        verdict.not_tried.push_back(causes_[c].id);
      } else {
        verdict.rejected.push_back({causes_[c].id, 0, "promises less than those tried"});
      }
    }
  }

  // Without repeats the floor is what the encoder rounds.
  void judge(FoldDiagnosis& found, const Eigen::VectorXd& residual) const {
    JointVerdict& verdict = found.verdict;
    double quantum = joint_.present("encoder_quantum", "quantum");
    if (quantum <= 0) quantum = 1e-3;
    const double floor = quantum / std::sqrt(12.0);
    const double before = std::sqrt(fits_.fit().residual({}, fits_.all()).squaredNorm() /
                                    static_cast<double>(residual.size()));
    const double after = std::sqrt(residual.squaredNorm() / static_cast<double>(residual.size()));
    verdict.misfit_before = before / floor;
    verdict.misfit_after = after / floor;
    verdict.remainder_score = verdict.misfit_after;
    verdict.remainder_critical = kRounding;
    const bool remains = verdict.misfit_after > kRounding;
    if (remains && cut_off_) {
      verdict.verdict = Verdict::Unfinished;
      return;
    }
    const auto named = verdict.named();
    const bool ambiguous = std::any_of(named.begin(), named.end(),
                                       [](const Finding* one) { return !one->rivals.empty(); });
    if (named.empty()) {
      verdict.verdict = remains ? Verdict::Unknown : Verdict::NoDiscrepancy;
    } else if (remains) {
      verdict.verdict = Verdict::PartlyExplained;
    } else {
      verdict.verdict = ambiguous ? Verdict::Ambiguous : Verdict::Named;
    }
  }

  bool has(std::size_t cause) const {
    return std::find(accepted_.begin(), accepted_.end(), cause) != accepted_.end();
  }

  const JointSimulator& joint_;
  FoldSearchOptions options_;
  FoldFits fits_;
  const std::vector<Cause>& causes_;
  const std::vector<Fold>& folds_;
  FoldModel model_;
  std::vector<std::size_t> accepted_, dropped_;  // accepted: in the order of the model
  std::map<std::size_t, std::vector<Rival>> rivals_;
  std::map<std::size_t, std::pair<FoldErrors, FoldErrors>> lost_;  // without, with
  std::map<std::size_t, double> held_back_;
  bool cut_off_ = false;  // by the budget
};

}  // namespace

FoldDiagnosis searchByFolds(const JointSimulator& joint, const std::vector<Cause>& causes,
                            const FoldSearchOptions& options) {
  return FoldSearch(joint, causes, options).run();
}

}  // namespace nao::validation
