// The part of JointSearch that puts what was found into words and numbers.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/random.h"
#include "validation/diagnosis/joint_search.h"
#include "validation/diagnosis/motion_votes.h"
#include "validation/diagnosis/signature.h"

namespace nao::validation {
namespace {

constexpr double kHigh = 0.95;       // of a 90 % interval
constexpr double kHighAlone = 0.9;   // of the chances that a cause which is alone is of interest
constexpr double kNormal90 = 1.645;  // [SD] half an interval, of a normal distribution
// How well a fitted noise is known: null sets draw theirs from what the fit says. Hidden nulls left
// 0.6 to 1.09 of the noise floor (60 joints), laws without a name 5 and more.
constexpr double kNoiseKnown = 1.1;
constexpr int kHarmonics = 3;    // of a sawtooth: 83 % of its variance
constexpr double kTold = 0.2;    // of a small difference's variance that data must take away
constexpr double kMostly = 0.9;  // of a misfit's excess: what explains it is more than a stand-in

// What the numbers of the model would have come out as in each null set: one Gauss-Newton step
// with the sensitivities of the fit. A row per set.
Eigen::MatrixXd reestimated(const Stage& stage, const ModelFit& fit) {
  const SlopeSteps steps = stepsOf(fit, stage);
  Eigen::MatrixXd moves(static_cast<Eigen::Index>(stage.nulls().size()), fit.jacobian.cols());
  for (Eigen::Index n = 0; n < moves.rows(); ++n) {
    const Eigen::VectorXd& null = stage.nulls()[static_cast<std::size_t>(n)];
    moves.row(n) = steps(stage.whitenFit(null)).transpose();
  }
  return moves;
}

// Beyond chance: what is wrong otherwise draws each motion's numbers its own way.
void addDisagreement(const JointData& data, const Stage& stage, const ModelFit& fit,
                     const Eigen::VectorXd& left, Eigen::MatrixXd& moves) {
  const SlopeSteps steps = stepsOf(fit, stage);
  std::vector<Eigen::MatrixXd> by_chance;
  for (const Eigen::VectorXd& null : stage.nulls()) {
    by_chance.push_back(votesOf(data, stage, fit, steps, null));
  }
  const Eigen::VectorXd variance = disagreement(votesOf(data, stage, fit, steps, left), by_chance);
  Random random(1, "disagreement");
  for (Eigen::Index n = 0; n < moves.rows(); ++n) {
    for (Eigen::Index i = 0; i < moves.cols(); ++i) {
      moves(n, i) += std::sqrt(variance[i]) * random.normal();
    }
  }
}

// A joint that rests reads one count all along, at a stop in motion after motion: rounding is one
// error there, not one per sample. How far it is from one place of rest to the next, `angle` tells,
// a prediction that no encoder rounds; where between two counts any of them lies nobody knows, nor
// where a model's does that reads the same: of both sawteeth, smeared by how the joint shakes, the
// phase is drawn.
void addRounding(const JointData& data, const Stage& stage, const ModelFit& fit,
                 const Eigen::VectorXd& angle, Eigen::MatrixXd& moves) {
  const Eigen::Index size = data.fitSize();
  const Eigen::ArrayXd count = angle.head(size).array() / data.quantum();
  const Eigen::ArrayXd shake = stage.scatter().head(size).array() / data.quantum();
  const Eigen::ArrayXd of_angle =
      data.quantum() * (data.rounding().head(size).array() > 0).cast<double>();
  const SlopeSteps steps = stepsOf(fit, stage);
  for (int k = 1; k <= kHarmonics; ++k) {
    const double turn = 2 * M_PI * k;
    const Eigen::ArrayXd most =
        of_angle * shake.unaryExpr([k](double sd) { return roundingHarmonic(k, sd); });
    const Eigen::VectorXd sine = steps(stage.whitenFit((most * (turn * count).sin()).matrix()));
    const Eigen::VectorXd cosine = steps(stage.whitenFit((most * (turn * count).cos()).matrix()));
    Random random(1, "where between two counts");  // of every harmonic the same
    for (Eigen::Index n = 0; n < moves.rows(); ++n) {
      const double measured = turn * random.uniform(), model = turn * random.uniform();
      moves.row(n) += ((std::cos(measured) - std::cos(model)) * sine +
                       (std::sin(measured) - std::sin(model)) * cosine)
                          .transpose();
    }
  }
}

// What equal robots differ by in the numbers themselves, and what laws leave out.
void addSpread(const std::vector<Cause>& causes, const CauseList& model, Eigen::MatrixXd& moves) {
  Random numbers(1, "undeclared numbers"), laws(1, "laws");
  Eigen::Index column = 0;
  for (const Chosen& one : model) {
    const double most = std::sqrt(3.0) * causes[one.cause].spreadAt(one.x[0]);
    const double law = causes[one.cause].lawErrorAt(one.x[0]);
    for (Eigen::Index n = 0; n < moves.rows(); ++n) {
      if (most > 0) moves(n, column) += numbers.uniform(-most, most);
      moves(n, column) += law * laws.normal();
    }
    column += static_cast<Eigen::Index>(one.x.size());
  }
}

// Beside a remainder a cause may be the nearest imitation of a law that is not in the catalogue: it
// is not named alone.
void doubt(JointVerdict& verdict) {
  for (Finding& finding : verdict.findings) {
    finding.rivals.push_back({"unknown", {}, 0});
    if (finding.rivals.size() == 1) finding.experiment = "look at the signature of what remains";
  }
}

Verdict verdictOf(const JointVerdict& joint, bool remains) {
  const std::vector<const Finding*> named = joint.named();
  if (named.empty()) return remains ? Verdict::Unknown : Verdict::NoDiscrepancy;
  if (remains) return Verdict::PartlyExplained;
  const bool ambiguous = std::any_of(named.begin(), named.end(),
                                     [](const Finding* one) { return !one->rivals.empty(); });
  return ambiguous ? Verdict::Ambiguous : Verdict::Named;
}

void setInterval(FoundNumber& number, const Eigen::VectorXd& moves, double high = kHigh) {
  const std::vector<double> all(moves.data(), moves.data() + moves.size());
  number.low = number.deviation - quantile(all, high);
  number.high = number.deviation - quantile(all, 1 - high);
}

// Whether a cause may be of no interest, as its size may be what it is less `moves`. Beside others
// it may be what their laws leave over: it has to be surer. How steep a coupled stop is and where
// it begins undo each other: its interval says nothing of what is there.
bool isSmall(FoundNumber size, const Eigen::VectorXd& moves, const Cause& cause, bool alone) {
  const double smallest = cause.free[0].smallest;
  if (cause.coupled) return std::abs(size.deviation) < smallest;
  setInterval(size, moves, alone ? kHighAlone : kHigh);
  return mayBeSmall(size.low, size.high, smallest);
}

}  // namespace

void JointSearch::describe(JointVerdict& verdict) {
  verdict.joint = joint_.joint();
  Eigen::MatrixXd moves;
  if (!accepted_.empty()) {
    moves = reestimated(*stage_, fit_);
    // What has no name pulls at the numbers as noise of its size would.
    moves *= std::max(1.0, misfit(*stage_, left_));
    addDisagreement(data_, *stage_, fit_, left_, moves);
    if (data_.quantum() > 0) {
      const Halves angle =
          ensemble_.exactHalves(settingsOf(causes_, fit_.model), effort_.slope_runs, Over::Fit);
      addRounding(data_, *stage_, fit_, angle.mean(), moves);
    }
  }
  addSpread(causes_, fit_.model, moves);
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < accepted_.size(); ++i) {
    Finding finding = findingOf(i);
    finding.small = isSmall(finding.numbers[0], moves.col(column), causes_[accepted_[i].cause],
                            accepted_.size() == 1);
    for (FoundNumber& number : finding.numbers) setInterval(number, moves.col(column++));
    finding.profile = profileOf(i, finding.numbers[0]);
    verdict.findings.push_back(std::move(finding));
  }
  verdict.adjustments = adjustments();
}

// Even by chance alone.
bool JointSearch::newestIsSmall() const {
  const Chosen& newest = fit_.model.back();
  const Cause& cause = causes_[newest.cause];
  const auto numbers = static_cast<Eigen::Index>(newest.x.size());
  const Eigen::MatrixXd moves = reestimated(*stage_, fit_);
  return isSmall(foundNumbers(cause, newest.x)[0], moves.col(moves.cols() - numbers), cause,
                 accepted_.size() == 1);
}

// All but intervals, what they say of its size, and profile.
Finding JointSearch::findingOf(std::size_t place) const {
  const Accepted& chosen = accepted_[place];
  const Cause& cause = causes_[chosen.cause];
  const std::vector<double>& x = fit_.model[place].x;
  Finding finding;
  finding.cause = cause.id;
  finding.effect = cause.effect;
  finding.numbers = foundNumbers(cause, x);
  finding.gain = chosen.gain;
  finding.share = chosen.share;
  finding.folds = chosen.validation.folds;
  finding.folds_better = chosen.validation.better;
  finding.held_out_gain = chosen.validation.gain;
  finding.one_motion_only = chosen.validation.oneMotionOnly();
  for (const Candidate& rival : chosen.rivals) {
    const Cause& other = causes_[rival.cause];
    finding.rivals.push_back({other.id, foundNumbers(other, rival.x), chosen.gain - rival.gain});
  }
  finding.confusion = chosen.confusion;
  finding.sentence = cause.fill(joint_.joint(), valueText(finding.numbers[0]));
  finding.experiment = cause.separate;
  return finding;
}

// Of what the data do not tell it is not worth a line.
std::vector<Adjustment> JointSearch::adjustments() const {
  std::vector<Adjustment> all;
  for (const SmallDifference& one : stage_->smallDifferences(left_)) {
    if (one.known < kTold) continue;
    const Cause& cause = causes_[one.cause];
    std::vector<double> x = startsOf(cause).front();
    x[0] = one.x;
    FoundNumber number = foundNumbers(cause, x).front();
    number.low = number.deviation - kNormal90 * one.sd;
    number.high = number.deviation + kNormal90 * one.sd;
    all.push_back({cause.id, cause.effect, number});
  }
  return all;
}

void JointSearch::judge(JointVerdict& verdict) {
  verdict.rejected = rejected_;
  std::set<std::string> not_tried(candidates_.notTried().begin(), candidates_.notTried().end());
  for (const std::size_t cause : stage_->unseen()) not_tried.insert(causes_[cause].id);
  verdict.not_tried.assign(not_tried.begin(), not_tried.end());
  verdict.critical_gain = critical();
  verdict.misfit_before = misfit_before_;
  verdict.misfit_after = misfit(*stage_, stage_->raw());
  verdict.split_ratio = split_ratio_;
  verdict.with_repeats = data_.hasRepeats();
  verdict.repeats = data_.spans().front().repeats;
  for (const MotionSpan& span : data_.spans()) {
    verdict.repeats = std::min(verdict.repeats, span.repeats);
  }
  if (verdict.with_repeats) verdict.noise = ensemble_.noise().torque_sd;
  verdict.runs = ensemble_.used();
  judgeRemainder(verdict);
  const bool remains = verdict.remainder_score > verdict.remainder_critical;
  if (remains) {
    doubt(verdict);
    verdict.adjustments.clear();  // they would stand in for what has no name
    verdict.signature = remainingShape(verdict).text();
  }
  const bool unfinished = ensemble_.spent() && (remains || !not_tried.empty());
  verdict.verdict = unfinished ? Verdict::Unfinished : verdictOf(verdict, remains);
}

// Where what was found explains but a part, it more likely stands in for one of the unknown: all is
// the remainder then. So it is where what several of them leave has no shape.
Signature JointSearch::remainingShape(const JointVerdict& verdict) const {
  const auto excess = [](double misfit) { return misfit * misfit - 1; };
  const bool mostly = excess(verdict.misfit_after) <= (1 - kMostly) * excess(verdict.misfit_before);
  if (nominal_ && !mostly) return signatureOf(joint_, data_, *nominal_, {});
  std::vector<EffectSetting> model = ensemble_.given();
  for (const EffectSetting& one : settingsOf(causes_, stage_->model())) model.push_back(one);
  const Signature left = signatureOf(joint_, data_, *stage_, model);
  return left.terms.empty() && nominal_ ? signatureOf(joint_, data_, *nominal_, {}) : left;
}

// What is left, in SDs of what null sets leave.
void JointSearch::judgeRemainder(JointVerdict& verdict) const {
  std::vector<double> largest = nulls_.remainders;
  for (std::size_t i = 0; i < largest.size() && i < others_.nulls.remainders.size(); ++i) {
    largest[i] = std::max(largest[i], others_.nulls.remainders[i]);
  }
  double mean = 0, square = 0;
  for (const Eigen::VectorXd& null : stage_->nulls()) {
    const double half = stage_->whiteAll(null).squaredNorm() / 2;
    mean += half / static_cast<double>(stage_->nulls().size());
    square += half * half / static_cast<double>(stage_->nulls().size());
  }
  const double sd = std::sqrt(std::max(square - mean * mean, 1e-12));
  verdict.remainder_critical = std::max(quantile(largest, 1 - effort_.false_alarms),
                                        (kNoiseKnown * kNoiseKnown - 1) * mean / sd);
  verdict.remainder_score = (stage_->whiteAll(stage_->raw()).squaredNorm() / 2 - mean) / sd;
}

}  // namespace nao::validation
