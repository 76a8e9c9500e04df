// The part of JointSearch that puts what was found into words and numbers.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "validation/diagnosis/joint/joint_search.h"
#include "validation/diagnosis/joint/number_moves.h"
#include "validation/diagnosis/joint/signature.h"

namespace nao::validation {
namespace {

constexpr double kHigh = 0.95;       // of a 90 % interval
constexpr double kHighAlone = 0.9;   // of the chances that a cause which is alone is of interest
constexpr double kNormal90 = 1.645;  // [SD] half an interval, of a normal distribution
// How well a fitted noise is known: null sets draw theirs from what the fit says. Hidden nulls left
// 0.6 to 1.09 of the noise floor (60 joints), laws without a name 5 and more.
constexpr double kNoiseKnown = 1.1;
constexpr double kExcited = 1;  // squared noise SDs of a look: else it cannot be judged
constexpr double kTold = 0.2;   // of a small difference's variance that data must take away
constexpr double kLeans = 0.1;  // of the greatest gain: missed

void doubt(Finding& finding, const std::string& experiment) {
  finding.rivals.push_back(whatHasNoName());
  if (finding.rivals.size() == 1) finding.experiment = experiment;
}

// Beside a remainder a cause may be the nearest imitation of a law that is not in the catalogue: it
// is not named alone.
void doubt(JointVerdict& verdict) {
  for (Finding& finding : verdict.findings) doubt(finding, "look at the signature of the unknown");
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

FoundNumber within(FoundNumber number, const Eigen::VectorXd& moves, double high) {
  setInterval(number, moves, high);
  return number;
}

// Whether a cause may be of no interest, as its size may be what it is less `moves`.
bool isSmall(const FoundNumber& size, const Eigen::VectorXd& moves, const Cause& cause,
             double high) {
  const FoundNumber one = within(size, moves, high);
  return mayBeSmall(one.low, one.high, cause.free[0].smallest);
}

}  // namespace

void JointSearch::describe(JointVerdict& verdict) {
  verdict.joint = joint_.joint();
  if (!accepted_.empty()) addFindings(verdict);
  verdict.adjustments = adjustments();
}

// Beside others a cause may be what their laws leave over: its whole interval has to be of
// interest. Alone it need only be with the shape that it has, as how steep a coupled stop is and
// where it begins undo each other, so do a friction and its speed; by nine chances of ten, if there
// is no remainder that it may stand in for.
void JointSearch::addFindings(JointVerdict& verdict) {
  const Eigen::VectorXd angle = unroundedAngle();
  const Eigen::MatrixXd moves = movesOf(fit_, angle);
  const auto alone = onlyOneOfInterest(fit_.model, causes_);
  const double sure = verdict.remains() ? kHigh : kHighAlone;
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < accepted_.size(); ++i) {
    Finding finding = findingOf(i);
    const Cause& cause = causes_[accepted_[i].cause];
    const FoundNumber& size = finding.numbers[0];
    if (alone == i) {
      const Eigen::VectorXd as_shaped = movesOf(sizeOf(fit_, i), angle).col(0);
      finding.small = isSmall(size, as_shaped, cause, sure);
      if (moves.cols() > 1) finding.as_shaped = {within(size, as_shaped, kHigh)};
    } else {
      finding.small = isSmall(size, moves.col(column), cause, kHigh);
    }
    for (FoundNumber& number : finding.numbers) setInterval(number, moves.col(column++));
    finding.profile = profileOf(i, size);
    verdict.findings.push_back(std::move(finding));
  }
}

// Of the whole model, if an encoder rounds it.
Eigen::VectorXd JointSearch::unroundedAngle() {
  if (data_.quantum() <= 0) return {};
  const auto settings = settingsOf(causes_, fit_.model);
  return ensemble_.exactHalves(settings, effort_.slope_runs, Over::Fit).mean();
}

// A column per number of the fit: how far off it may be, drawn once per null set.
Eigen::MatrixXd JointSearch::movesOf(const ModelFit& fit, const Eigen::VectorXd& angle) const {
  Eigen::MatrixXd moves = reestimated(*stage_, fit);
  // What has no name pulls at the numbers as noise of its size would.
  moves *= std::max(1.0, misfit(*stage_, left_));
  addDisagreement(data_, *stage_, fit, left_, moves);
  if (data_.quantum() > 0) addRounding(data_, *stage_, fit, angle, moves);
  addSpread(causes_, fit.model, moves);
  return moves;
}

// Even by chance alone.
bool JointSearch::newestIsSmall() const {
  const Chosen& newest = fit_.model.back();
  const Cause& cause = causes_[newest.cause];
  const auto numbers = static_cast<Eigen::Index>(newest.x.size());
  const Eigen::MatrixXd moves = reestimated(*stage_, fit_);
  return isSmall(foundNumbers(cause, newest.x)[0], moves.col(moves.cols() - numbers), cause, kHigh);
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
    finding.rivals.push_back(
        {other.id, other.effect, "", foundNumbers(other, rival.x), chosen.gain - rival.gain});
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
  const bool remains = verdict.remains() || leansOnATrifle(verdict);
  if (remains) {
    doubt(verdict);
    verdict.adjustments.clear();  // they would stand in for what has no name
    verdict.signature = shapeOfUnknown().text();
  } else {
    doubtThoseAtEnd(verdict);
  }
  const bool unfinished = ensemble_.spent() && (remains || !not_tried.empty());
  verdict.verdict = unfinished ? Verdict::Unfinished : verdictOf(verdict, remains);
}

// What is named explains the data only with another cause beside it that is of no interest, that
// equal robots do not differ by, and that is missed all the same: it stands in for something.
bool JointSearch::leansOnATrifle(const JointVerdict& verdict) const {
  if (verdict.named().empty()) return false;
  const double much = kLeans * greatestGain();
  return std::any_of(verdict.findings.begin(), verdict.findings.end(), [&](const Finding& one) {
    const auto place = static_cast<std::size_t>(&one - verdict.findings.data());
    return one.small && one.gain > much && causes_[accepted_[place].cause].spread <= 0;
  });
}

// Data ask for more of them than their laws allow for.
void JointSearch::doubtThoseAtEnd(JointVerdict& verdict) const {
  for (std::size_t i = 0; i < verdict.findings.size(); ++i) {
    if (isAtEnd(fit_.model[i])) doubt(verdict.findings[i], "look for what acts beside it");
  }
}

// What was found beside an unknown mostly stands in for a part of it: the shape is that of all, and
// of what is left only where all has none.
Signature JointSearch::shapeOfUnknown() const {
  std::vector<EffectSetting> model = ensemble_.given();
  if (nominal_) {
    Signature of_all = signatureOf(joint_, data_, *nominal_, model);
    if (!of_all.terms.empty()) return of_all;
  }
  for (const EffectSetting& one : settingsOf(causes_, stage_->model())) model.push_back(one);
  return signatureOf(joint_, data_, *stage_, model);
}

JointSearch::Remainder JointSearch::remainder() const {
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
  return {(stage_->whiteAll(stage_->raw()).squaredNorm() / 2 - mean) / sd,
          std::max(quantile(largest, 1 - effort_.false_alarms),
                   (kNoiseKnown * kNoiseKnown - 1) * mean / sd)};
}

// What a cause gains by its fit, if there was one in the last round, or by its best look.
double JointSearch::lastGainOf(std::size_t cause, double by_look) const {
  const auto fitted = fitted_.find(cause);
  return fitted == fitted_.end() ? by_look : fitted->second;
}

// What was refused in one round may have been found in another.
void JointSearch::forgetWhatWasFound() {
  const auto found = [&](const Rejected& one) {
    return std::any_of(accepted_.begin(), accepted_.end(),
                       [&](const Accepted& other) { return causes_[other.cause].id == one.cause; });
  };
  rejected_.erase(std::remove_if(rejected_.begin(), rejected_.end(), found), rejected_.end());
}

void JointSearch::rejectTheRest() {
  forgetWhatWasFound();
  const Eigen::VectorXd white = stage_->white(stage_->raw());
  for (std::size_t c = 0; c < causes_.size(); ++c) {
    double best = 0, response = 0;
    bool looked = false;
    for (const Look& look : stage_->looks()) {
      if (look.cause != c) continue;
      looked = true;
      best = std::max(best, Stage::gain(look, white));
      response = std::max(response, look.white.first.dot(look.white.second));
    }
    const auto known = [&](const Rejected& one) { return one.cause == causes_[c].id; };
    if (!looked || std::any_of(rejected_.begin(), rejected_.end(), known)) continue;
    const double gain = std::max(0.0, lastGainOf(c, best));
    if (response < kExcited) {
      reject(c, gain, "not excited: no motion of this set shows it, it cannot be judged");
    } else if (gain > critical()) {
      reject(c, gain, "explains less than what was tried before it");
    } else {
      reject(c, gain, "its gain is below the threshold");
    }
  }
}

}  // namespace nao::validation
