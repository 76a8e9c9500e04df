#include "validation/diagnosis/ensemble.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/check.h"
#include "core/random.h"
#include "validation/diagnosis/ensemble_tape.h"
#include "validation/diagnosis/joint_data.h"
#include "validation/diagnosis/noise_fit.h"

namespace nao::validation {
namespace {

// Of an exact run, in coarse ones: a limb of four joints against a rig.
constexpr long kExactCost = 40;

constexpr char kRounding[] = "encoder_quantum";

bool roundsReadings(const EffectSetting& cause) { return cause.name == kRounding; }

// The sum of as many of these runs, drawn by chance, each once.
Eigen::VectorXd sumOfDifferent(const Eigen::MatrixXd& runs, Eigen::Index repeats, Random& random) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(runs.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(runs.rows());
  for (Eigen::Index r = 0; r < repeats; ++r) {
    const auto left = static_cast<double>(runs.cols() - r);
    std::swap(
        order[static_cast<std::size_t>(r)],
        order[static_cast<std::size_t>(r + static_cast<Eigen::Index>(random.uniform() * left))]);
    sum += runs.col(order[static_cast<std::size_t>(r)]);
  }
  return sum;
}

// The same, each as often as chance has it.
Eigen::VectorXd sumOfAny(const Eigen::MatrixXd& runs, Eigen::Index repeats, Random& random) {
  const auto count = static_cast<double>(runs.cols());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(runs.rows());
  for (Eigen::Index r = 0; r < repeats; ++r) {
    sum += runs.col(static_cast<Eigen::Index>(random.uniform() * count));
  }
  return sum;
}

}  // namespace

Eigen::VectorXd RunPool::measuredAgain(const JointData& data, std::uint64_t seed) const {
  Random random(seed, "measured again");
  Eigen::VectorXd all(mean.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const MotionSpan& span = data.spans()[i];
    const Eigen::Index repeats = span.repeats;
    const double r = static_cast<double>(repeats), n = static_cast<double>(runs[i].cols());
    // Half of the runs and more say too little of chance if each is drawn once; all of them,
    // nothing.
    const bool once = 2 * r <= n;
    const Eigen::VectorXd sum =
        once ? sumOfDifferent(runs[i], repeats, random) : sumOfAny(runs[i], repeats, random);
    // Drawn from what the mean was made of, the mean's variance is that of one run times this.
    const double drawn = once ? 1 / r - 1 / n : (1 - 1 / n) / r;
    const double widen = std::sqrt((1 / r + 1 / n) / drawn);
    all.segment(span.offset, span.size()) =
        widen * (sum / r - mean.segment(span.offset, span.size()));
  }
  return all;
}

Ensemble::Ensemble(const JointSimulator& joint, const JointData& data, const JointNoise& noise,
                   long granted)
    : joint_(joint), data_(data), noise_(noise), granted_(granted) {}

void Ensemble::learnNoise(const std::vector<EffectSetting>& causes) {
  noise_ = fitNoise(joint_, noise_, withGiven(causes));
}

std::vector<EffectSetting> Ensemble::withGiven(const std::vector<EffectSetting>& causes) const {
  std::vector<EffectSetting> all = given_;
  all.insert(all.end(), causes.begin(), causes.end());
  return all;
}

Eigen::VectorXd Ensemble::recalled(const std::function<Eigen::VectorXd()>& simulate) {
  Eigen::VectorXd result = tape_ ? tape_->next(used_, simulate) : simulate();
  if (watch_) watch_(used_);
  return result;
}

Halves Ensemble::halves(const std::vector<EffectSetting>& causes, int runs, Over motions) {
  return halvesOf(joint_.coarse(), causes, runs, motions);
}

Halves Ensemble::roughHalves(const std::vector<EffectSetting>& causes, int runs, Over motions) {
  return halvesOf(joint_.rough(), causes, runs, motions);
}

Halves Ensemble::exactHalves(const std::vector<EffectSetting>& causes, int runs, Over motions) {
  return halvesOf(joint_.exact(), causes, runs, motions);
}

// All that was given too, without rounding unless a cause alters it.
Ensemble::Prediction Ensemble::unrounded(const std::vector<EffectSetting>& causes) const {
  Prediction of{withGiven(causes), noise_};
  if (std::any_of(of.causes.begin(), of.causes.end(), roundsReadings)) return of;
  of.noise.quantum = 0;
  const double own = joint_.present(kRounding, "quantum");
  if (own != 0) of.causes.push_back({kRounding, {{"quantum", -own}}, joint_.place(), ""});
  return of;
}

Halves Ensemble::halvesOf(const JointSimulator& joint, const std::vector<EffectSetting>& causes,
                          int runs, Over motions) {
  NAO_CHECK(runs % 2 == 0 && runs > 0);
  const Prediction of = unrounded(causes);
  return {recalled([&] { return meanOf(joint, of, motions, 0, runs, 2); }),
          recalled([&] { return meanOf(joint, of, motions, 1, runs, 2); })};
}

Eigen::VectorXd Ensemble::rough(const std::vector<EffectSetting>& causes) {
  return recalled([&] { return meanOf(joint_.rough(), unrounded(causes), Over::Fit, 0, 1, 1); });
}

Eigen::VectorXd Ensemble::roughOf(const std::vector<EffectSetting>& causes,
                                  const MotionSpan& span) {
  return recalled([&]() -> Eigen::VectorXd {
    ++used_;
    const Prediction of = unrounded(causes);
    const std::uint64_t stream = streamOf(StreamUse::Mean, span.motion, 0);
    return joint_.rough().run(of.causes, span.motion, stream, of.noise).reshaped();
  });
}

// Of every `every`-th of the runs 0 to `runs` - 1, from the `first` on.
Eigen::VectorXd Ensemble::meanOf(const JointSimulator& joint, const Prediction& of, Over motions,
                                 int first, int runs, int every) {
  const int count = (runs - first + every - 1) / every;
  std::vector<Eigen::MatrixXd> means;
  for (const MotionSpan& span : data_.spans()) {
    if (motions == Over::Fit && span.split != Split::Fit) break;  // fit motions come first
    const auto run = [&](int r) {
      const std::uint64_t stream = streamOf(StreamUse::Mean, span.motion, r);
      return joint.run(of.causes, span.motion, stream, of.noise);
    };
    Eigen::MatrixXd sum = run(first);
    for (int r = first + every; r < runs; r += every) sum += run(r);
    means.push_back(sum / count);
    used_ += count * costOf(joint);
  }
  return data_.stack(means);
}

long Ensemble::costOf(const JointSimulator& joint) const {
  return &joint == &joint_.exact() && &joint != &joint_ ? kExactCost : 1;
}

// On tape: the runs of every span one after the other.
RunPool Ensemble::pool(const std::vector<EffectSetting>& causes, int runs) {
  RunPool pool;
  const Eigen::VectorXd all = recalled([&] {
    Eigen::VectorXd values(data_.size() * runs);
    const RunPool simulated = simulatedPool(causes, runs);
    for (std::size_t i = 0; i < simulated.runs.size(); ++i) {
      const MotionSpan& span = data_.spans()[i];
      values.segment(span.offset * runs, span.size() * runs) = simulated.runs[i].reshaped();
    }
    return values;
  });
  pool.mean.resize(data_.size());
  for (const MotionSpan& span : data_.spans()) {
    pool.runs.push_back(
        all.segment(span.offset * runs, span.size() * runs).reshaped(span.size(), runs));
    pool.mean.segment(span.offset, span.size()) = pool.runs.back().rowwise().mean();
  }
  return pool;
}

RunPool Ensemble::simulatedPool(const std::vector<EffectSetting>& causes, int runs) {
  const std::vector<EffectSetting> all = withGiven(causes);
  const JointSimulator& joint = joint_.exact();
  RunPool pool;
  for (const MotionSpan& span : data_.spans()) {
    const std::size_t m = span.motion;
    Eigen::MatrixXd columns(span.size(), runs);
    for (int r = 0; r < runs; ++r) {
      columns.col(r) = joint.run(all, m, streamOf(StreamUse::Pool, m, r), noise_).reshaped();
    }
    pool.runs.push_back(std::move(columns));
    used_ += runs * costOf(joint);
  }
  return pool;
}

}  // namespace nao::validation
