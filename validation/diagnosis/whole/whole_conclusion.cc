// The part of WholeSearch that puts what was found into words and numbers.
#include <algorithm>
#include <cmath>
#include <map>

#include "validation/diagnosis/joint/by_chance.h"
#include "validation/diagnosis/joint/number_moves.h"
#include "validation/diagnosis/whole/whole_numbers.h"
#include "validation/diagnosis/whole/whole_search.h"

namespace nao::validation {
namespace {

// Replaying commands leaves out what the walk's own feedback would have made of each run's chance,
// and how a robot came to stand where it begins: an estimate, no series of nulls has set it yet.
constexpr double kModelError = 1.5;

}  // namespace

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
  const Eigen::MatrixXd draws = drawNumbers(task_, *stage_, fit_);
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
  verdict.spread = spread_;
  verdict.not_tried = not_tried_;
  if (!not_tried_.empty()) verdict.verdict = Verdict::Unfinished;
  for (std::size_t i = 0; i < provisional_.size(); ++i) verdict.handed_on.push_back(fateOf(i));
}

std::vector<FoundNumber> WholeSearch::numbersOf(const Chosen& chosen) const {
  std::vector<FoundNumber> numbers;
  for (std::size_t i = 0; i < chosen.x.size(); ++i) {
    const FreeNumber& free = placed(chosen.cause).cause.free[i];
    numbers.push_back({free.parameter, free.unit, shownValue(free, chosen.x[i]), chosen.x[i],
                       chosen.x[i], chosen.x[i]});
  }
  return numbers;
}

PlacedFinding WholeSearch::finding(std::size_t place, const Eigen::MatrixXd& draws) const {
  const Chosen& chosen = fit_.model[place];
  const PlacedCause& cause = placed(chosen.cause);
  Finding found;
  found.cause = cause.cause.id;
  found.effect = cause.cause.effect;
  found.numbers = numbersOf(chosen);
  Eigen::Index row = firstNumberOf(fit_.model, place);
  for (FoundNumber& number : found.numbers) number = within(number, draws.row(row++));
  const Accepted& accepted = accepted_[place];
  found.gain = accepted.gain;
  found.share = std::min(1.0, accepted.share);
  found.folds = accepted.folds;
  found.folds_better = accepted.folds_better;
  found.held_out_gain = accepted.held_out;
  found.one_motion_only = accepted.folds == 0 || isOfOneMotion();
  found.rivals = accepted.rivals;
  // As at the joint level a lone cause need be of interest with the shape that it has.
  const auto smallestOf = [&](std::size_t c) { return placed(c).cause.free[0].smallest; };
  if (found.numbers.size() > 1 && onlyOneOfInterest(fit_.model, smallestOf) == place) {
    const Eigen::MatrixXd moves = drawNumbers(task_, *stage_, sizeOf(fit_, place));
    found.as_shaped = {within(found.numbers[0], moves.row(0))};
  }
  const FoundNumber& size = found.as_shaped.empty() ? found.numbers[0] : found.as_shaped[0];
  const double smallest = smallestOf(chosen.cause);
  found.small = mayBeSmall(
      size.low, size.high,
      cause.cause.spread > 0 ? smallestTogether(found.cause, smallest, found.rivals) : smallest);
  found.sentence = cause.sentence(valueText(found.numbers[0]));
  found.experiment = cause.cause.separate;
  return {found, cause.place};
}

// What is held back are then runs of the motion that was fitted.
bool WholeSearch::isOfOneMotion() const {
  const auto& blocks = task_.data->simulator().blocks();
  return std::all_of(blocks.begin(), blocks.end(), [&](const WholeBlock& block) {
    return block.motion == blocks.front().motion;
  });
}

std::string WholeSearch::labelOf(std::size_t cause) const {
  return placed(cause).cause.id + " at " + placed(cause).place;
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

}  // namespace nao::validation
