#include "validation/diagnosis/joint/joint_report.h"

#include <algorithm>
#include <optional>
#include <set>

#include "validation/diagnosis/joint/number_moves.h"

namespace nao::validation {
namespace {

constexpr double kSure = 0.95;       // a 90 % interval is of interest as a whole
constexpr double kSureAlone = 0.9;   // by these chances a cause which is alone is of interest
constexpr double kNormal90 = 1.645;  // [SD] half an interval, of a normal distribution
constexpr double kExcited = 1;       // squared noise SDs of a look: else it cannot be judged
constexpr double kTold = 0.2;        // of a small difference's variance that data must take away
constexpr double kLeans = 0.1;       // of the greatest gain: missed

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

struct BestLook {
  double gain = 0, response = 0;  // of any: [nats], [squared noise SDs]
};

// None if the cause was not looked at.
std::optional<BestLook> bestLook(const Stage& stage, std::size_t cause,
                                 const Eigen::VectorXd& white) {
  std::optional<BestLook> best;
  for (const Look& look : stage.looks()) {
    if (look.cause != cause) continue;
    if (!best) best.emplace();
    best->gain = std::max(best->gain, Stage::gain(look, white));
    best->response = std::max(best->response, look.white.first.dot(look.white.second));
  }
  return best;
}

std::string whyNot(double gain, const BestLook& seen, double critical) {
  if (seen.response < kExcited) {
    return "not excited: no motion of this set shows it, it cannot be judged";
  }
  return gain > critical ? "explains less than what was tried before it"
                         : "its gain is below the threshold";
}

}  // namespace

JointReport::JointReport(JointModel& model, const SearchNotes& notes)
    : model_(model),
      notes_(notes),
      stage_(model.stage()),
      fit_(model.fit()),
      causes_(model.causes()) {}

JointVerdict JointReport::verdict() {
  JointVerdict verdict;
  verdict.joint = model_.joint().joint();
  verdict.rejected = rejected();
  const Remainder left = model_.remainder();
  verdict.remainder_score = left.score;
  verdict.remainder_critical = left.critical;
  if (!model_.found().empty()) addFindings(verdict);
  verdict.adjustments = adjustments();
  addEvidence(verdict);
  judge(verdict);
  return verdict;
}

// Beside others a cause may be what their laws leave over: its whole interval has to be of
// interest. Alone it need only be with the shape that it has, as how steep a coupled stop is and
// where it begins undo each other, so do a friction and its speed; by nine chances of ten, if there
// is no remainder that it may stand in for.
void JointReport::addFindings(JointVerdict& verdict) {
  const Eigen::VectorXd angle = unroundedAngle();
  const Eigen::MatrixXd moves = movesOf(fit_, angle);
  const auto alone = onlyOneOfInterest(
      fit_.model, [&](std::size_t cause) { return causes_[cause].free[0].smallest; });
  const double sure = verdict.remains() ? kSure : kSureAlone;
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < model_.found().size(); ++i) {
    Finding finding = findingOf(i);
    const Cause& cause = causes_[model_.found()[i].cause];
    const FoundNumber& size = finding.numbers[0];
    if (alone == i) {
      const Eigen::VectorXd as_shaped = movesOf(sizeOf(fit_, i), angle).col(0);
      finding.small = mayBeSmall(size, as_shaped, cause, sure);
      if (moves.cols() > 1) finding.as_shaped = {within(size, as_shaped)};
    } else {
      finding.small = mayBeSmall(size, moves.col(column), cause);
    }
    for (FoundNumber& number : finding.numbers) number = within(number, moves.col(column++));
    finding.profile = profileOf(i, size);
    verdict.findings.push_back(std::move(finding));
  }
}

// Of the whole model, if an encoder rounds it.
Eigen::VectorXd JointReport::unroundedAngle() {
  if (model_.data().quantum() <= 0) return {};
  const auto settings = settingsOf(causes_, fit_.model);
  return model_.ensemble().exactHalves(settings, model_.effort().slope_runs, Over::Fit).mean();
}

// A column per number of the fit: how far off it may be, drawn once per null set.
Eigen::MatrixXd JointReport::movesOf(const ModelSlopes& fit, const Eigen::VectorXd& angle) const {
  Eigen::MatrixXd moves = reestimated(stage_, fit);
  // What has no name pulls at the numbers as noise of its size would.
  moves *= std::max(1.0, model_.misfit(model_.left()));
  addDisagreement(model_.data(), stage_, fit, model_.left(), moves);
  if (model_.data().quantum() > 0) addRounding(model_.data(), stage_, fit, angle, moves);
  addSpread(causes_, fit.model, moves);
  return moves;
}

// All but intervals, what they say of its size, and profile.
Finding JointReport::findingOf(std::size_t place) const {
  const FoundCause& chosen = model_.found()[place];
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
  finding.sentence = cause.fill(model_.joint().joint(), valueText(finding.numbers[0]));
  finding.experiment = cause.separate;
  return finding;
}

// Of what the data do not tell it is not worth a line.
std::vector<Adjustment> JointReport::adjustments() const {
  std::vector<Adjustment> all;
  for (const SmallDifference& one : stage_.smallDifferences(model_.left())) {
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

void JointReport::addEvidence(JointVerdict& verdict) const {
  std::set<std::string> not_tried(notes_.not_tried.begin(), notes_.not_tried.end());
  for (const std::size_t cause : stage_.unseen()) not_tried.insert(causes_[cause].id);
  verdict.not_tried.assign(not_tried.begin(), not_tried.end());
  verdict.critical_gain = model_.critical();
  verdict.misfit_before = notes_.misfit_before;
  verdict.misfit_after = model_.misfit(stage_.raw());
  verdict.split_ratio = notes_.split_ratio;
  verdict.with_repeats = model_.data().hasRepeats();
  verdict.repeats = model_.data().spans().front().repeats;
  for (const MotionSpan& span : model_.data().spans()) {
    verdict.repeats = std::min(verdict.repeats, span.repeats);
  }
  if (verdict.with_repeats) verdict.noise = model_.ensemble().noise().torque_sd;
  verdict.runs = model_.ensemble().used();
}

void JointReport::judge(JointVerdict& verdict) const {
  const bool remains = verdict.remains() || leansOnATrifle(verdict);
  if (remains) {
    doubt(verdict);
    verdict.adjustments.clear();  // they would stand in for what has no name
    verdict.signature = shapeOfUnknown().text();
  } else {
    doubtThoseAtEnd(verdict);
  }
  const bool unfinished = model_.ensemble().spent() && (remains || !verdict.not_tried.empty());
  verdict.verdict = unfinished ? Verdict::Unfinished : verdictOf(verdict, remains);
}

// What is named explains the data only with another cause beside it that is of no interest, that
// equal robots do not differ by, and that is missed all the same: it stands in for something.
bool JointReport::leansOnATrifle(const JointVerdict& verdict) const {
  if (verdict.named().empty()) return false;
  const double much = kLeans * model_.greatestGain();
  return std::any_of(verdict.findings.begin(), verdict.findings.end(), [&](const Finding& one) {
    const auto place = static_cast<std::size_t>(&one - verdict.findings.data());
    return one.small && one.gain > much && causes_[model_.found()[place].cause].spread <= 0;
  });
}

// Data ask for more of them than their laws allow for.
void JointReport::doubtThoseAtEnd(JointVerdict& verdict) const {
  for (std::size_t i = 0; i < verdict.findings.size(); ++i) {
    if (model_.isAtEnd(fit_.model[i])) doubt(verdict.findings[i], "look for what acts beside it");
  }
}

// What was found beside an unknown mostly stands in for a part of it: the shape is that of all, and
// of what is left only where all has none.
Signature JointReport::shapeOfUnknown() const {
  if (model_.nominal() != nullptr) {
    Signature of_all = lackedAt(model_.joint(), model_.ensemble(), causes_, *model_.nominal());
    if (!of_all.terms.empty()) return of_all;
  }
  return lackedAt(model_.joint(), model_.ensemble(), causes_, stage_);
}

// What speaks against each cause that was not found: what was last said of it, or its best look.
std::vector<Rejected> JointReport::rejected() const {
  std::vector<Rejected> all;
  for (const Rejected& one : notes_.rejected) {  // in one round; it may have been found in another
    const auto same = [&](const FoundCause& found) { return causes_[found.cause].id == one.cause; };
    if (std::none_of(model_.found().begin(), model_.found().end(), same)) all.push_back(one);
  }
  const Eigen::VectorXd white = stage_.white(stage_.raw());
  for (std::size_t c = 0; c < causes_.size(); ++c) {
    const auto known = [&](const Rejected& one) { return one.cause == causes_[c].id; };
    if (std::any_of(all.begin(), all.end(), known)) continue;
    const auto best = bestLook(stage_, c, white);
    if (!best) continue;
    const auto fitted = notes_.last_gains.find(c);
    const double gain = fitted == notes_.last_gains.end() ? best->gain : fitted->second;
    all.push_back({causes_[c].id, std::max(0.0, gain), whyNot(gain, *best, model_.critical())});
  }
  return all;
}

}  // namespace nao::validation
