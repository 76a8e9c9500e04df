#include "validation/diagnosis/joint/beat_search.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "validation/diagnosis/ensemble/joint_data.h"

namespace nao::validation {
namespace {

constexpr double kTurns =
    0.25;  // by which neighbours of the row part over a motion; a half shows nothing
constexpr double kLargest = 0.12;  // [s] further than any bus or script holds: free choice
constexpr std::size_t kBest = 4;   // sizes of either kind that all motions are asked about
constexpr int kInStep = 4;         // ticks until a clock meets a command again, at most
constexpr double kFirst = 0.25;    // of the width of a beat, by which a size goes first,
constexpr int kNarrowed = 4;       // by half each time

double lengthOf(const MotionSpan& span) { return static_cast<double>(span.rows) * span.dt; }

// One run of one motion for every size; everything outside the motion is as it was.
class BeatRow {
 public:
  BeatRow(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
          std::size_t cause, double x)
      : ensemble_(ensemble), stage_(stage), causes_(causes), cause_(cause) {
    chooseSpan(x);
    before_ = ensemble_.roughOf(settingsOf(causes_, stage_.model()), *span_);
    residual_ = white(stage_.raw().segment(span_->offset, span_->size()));
  }

  TriedSize at(double x) const {
    const Eigen::VectorXd change = white(predictionWith(x, *span_) - before_);
    const Explained explained({change, change}, residual_);
    return {x, explained.gain(), explained.gain(std::max(0.0, explained.bestScale()))};
  }
  const MotionSpan& span() const { return *span_; }

 private:
  Eigen::VectorXd predictionWith(double x, const MotionSpan& span) const {
    CauseList with = stage_.model();
    with.push_back({cause_, {x}});
    return ensemble_.roughOf(settingsOf(causes_, with), span);
  }

  Eigen::VectorXd white(const Eigen::VectorXd& part) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(stage_.raw().size());
    all.segment(span_->offset, span_->size()) = part;
    return stage_.white(all);
  }

  // The fit motion that the cause changes most.
  void chooseSpan(double x) {
    const auto settings = settingsOf(causes_, stage_.model());
    double most = -1;
    for (const MotionSpan& span : ensemble_.data().spans()) {
      if (span.split != Split::Fit) continue;
      const Eigen::VectorXd sd = ensemble_.data().sd().segment(span.offset, span.size());
      const Eigen::VectorXd change = predictionWith(x, span) - ensemble_.roughOf(settings, span);
      const double size = change.cwiseQuotient(sd).squaredNorm();
      if (size > most) most = size, span_ = &span;
    }
  }

  Ensemble& ensemble_;
  const Stage& stage_;
  const std::vector<Cause>& causes_;
  std::size_t cause_;
  const MotionSpan* span_ = nullptr;
  Eigen::VectorXd before_, residual_;
};

// Rates [1 / its unit] to be tried: a row, and clocks in step with commands of one per sample. Of
// these every few ticks meet a command, and to either side take the one before or after it.
std::vector<double> ratesOf(const FreeNumber& size, const MotionSpan& span) {
  std::vector<double> rates;
  const double most = 1 / size.smallest, step = kTurns / lengthOf(span);
  for (double rate = 1 / kLargest; rate < most; rate += step) rates.push_back(rate);
  for (int ticks = 1; ticks <= kInStep; ++ticks) {
    for (int commands = 1; commands * span.dt <= ticks * kLargest; ++commands) {
      const double rate = ticks / (commands * span.dt);
      if (rate < most && std::gcd(ticks, commands) == 1) rates.push_back(rate);
    }
  }
  return rates;
}

}  // namespace

double beatWidth(const JointData& data, double x) {
  double longest = 0;
  for (const MotionSpan& span : data.spans()) longest = std::max(longest, lengthOf(span));
  return kTurns * x * x / longest;
}

std::vector<double> bestSizes(std::vector<TriedSize> tried) {
  std::vector<double> best;
  for (const auto gain : {&TriedSize::as_it_is, &TriedSize::scaled}) {
    std::stable_sort(tried.begin(), tried.end(),
                     [gain](const TriedSize& a, const TriedSize& b) { return a.*gain > b.*gain; });
    for (std::size_t i = 0; i < std::min(kBest, tried.size()); ++i) {
      if (std::find(best.begin(), best.end(), tried[i].x) == best.end()) best.push_back(tried[i].x);
    }
  }
  return best;
}

std::vector<double> beatingSizes(Ensemble& ensemble, const Stage& stage,
                                 const std::vector<Cause>& causes, std::size_t cause) {
  const FreeNumber& size = causes[cause].free[0];
  const BeatRow row(ensemble, stage, causes, cause, size.starts.front());
  std::vector<TriedSize> tried;
  for (const double rate : ratesOf(size, row.span())) {
    if (ensemble.spent()) break;
    tried.push_back(row.at(1 / rate));
  }
  return bestSizes(std::move(tried));
}

BeatSize bestBeside(BeatSize start, double beat_width, const std::function<double(double)>& left) {
  BeatSize best = start;
  double width = kFirst * beat_width;
  for (int i = 0; i < kNarrowed; ++i, width /= 2) {
    for (const double x : {best.x - width, best.x + width}) {
      const BeatSize other{x, left(x)};
      if (other.left < best.left) best = other;
    }
  }
  return best;
}

}  // namespace nao::validation
