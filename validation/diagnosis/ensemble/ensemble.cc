#include "validation/diagnosis/ensemble/ensemble.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/check.h"
#include "core/random.h"
#include "validation/diagnosis/ensemble/ensemble_tape.h"
#include "validation/diagnosis/ensemble/joint_data.h"
#include "validation/diagnosis/ensemble/noise_fit.h"

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

// Of each pair of the runs, this with them.
template <typename Join>
Eigen::MatrixXd joined(const Eigen::MatrixXd& runs, const Join& join) {
  Eigen::MatrixXd all(runs.rows(), runs.cols() / 2);
  for (Eigen::Index i = 0; i < all.cols(); ++i) {
    const Eigen::Index first = i / 2 * 4 + i % 2;
    all.col(i) = join(runs.col(first), runs.col(first + 2));
  }
  return all;
}

double squaresBeside(const Eigen::MatrixXd& columns) {
  return (columns.colwise() - columns.rowwise().mean().eval()).squaredNorm() /
         static_cast<double>(columns.cols() - 1);
}

constexpr double kBestPairing = 0.02;  // measured: 0.05

double pairingOf(const std::vector<Eigen::MatrixXd>& runs) {
  if (runs.front().cols() % 4 != 0 || runs.front().cols() < 8) return 1;
  double pairs = 0, singles = 0;
  for (const Eigen::MatrixXd& span : runs) {
    pairs += 2 * squaresBeside(joined(span, [](const auto& a, const auto& b) -> Eigen::VectorXd {
               return (a + b) / 2;
             }));
    singles += squaresBeside(span);
  }
  return singles > 0 ? std::clamp(pairs / singles, kBestPairing, 1.0) : 1;
}

}  // namespace

Eigen::MatrixXd RunPool::deviations(std::size_t span) const {
  const Eigen::MatrixXd& all = runs[span];
  if (mirrored && all.cols() % 4 == 0) {
    const double scale = 1 / std::sqrt(2 * (2 - pairing));
    return joined(
        all, [scale](const auto& a, const auto& b) -> Eigen::VectorXd { return scale * (a - b); });
  }
  const auto n = static_cast<double>(all.cols());
  return (all.colwise() - all.rowwise().mean().eval()) * std::sqrt(n / std::max(1.0, n - 1));
}

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
    const double about_mean = (n - pairing) / (n - 1);
    const double drawn = about_mean * (once ? 1 / r - 1 / n : (1 - 1 / n) / r);
    const double widen = std::sqrt((1 / r + pairing / n) / drawn);
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

RunPool Ensemble::pool(const std::vector<EffectSetting>& causes, int runs) {
  RunPool pool = poolOf(causes, {joint_.exact(), StreamUse::Pool, runs});
  pool.mirrored = true;
  pool.pairing = pairingOf(pool.runs);
  return pool;
}

RunPool Ensemble::spread(const std::vector<EffectSetting>& causes, int runs) {
  return poolOf(causes, {joint_.coarse(), StreamUse::Spread, runs});
}

RunPool Ensemble::poolOf(const std::vector<EffectSetting>& causes, const PoolOf& of) {
  RunPool pool;
  const Eigen::VectorXd all = recalled([&] { return simulatedPool(causes, of); });
  pool.mean.resize(data_.size());
  for (const MotionSpan& span : data_.spans()) {
    pool.runs.push_back(
        all.segment(span.offset * of.runs, span.size() * of.runs).reshaped(span.size(), of.runs));
    pool.mean.segment(span.offset, span.size()) = pool.runs.back().rowwise().mean();
  }
  return pool;
}

// The runs of every span one after the other.
Eigen::VectorXd Ensemble::simulatedPool(const std::vector<EffectSetting>& causes,
                                        const PoolOf& of) {
  const std::vector<EffectSetting> all = withGiven(causes);
  Eigen::VectorXd values(data_.size() * of.runs);
  for (const MotionSpan& span : data_.spans()) {
    const std::size_t m = span.motion;
    for (int r = 0; r < of.runs; ++r) {
      values.segment(span.offset * of.runs + span.size() * r, span.size()) =
          of.joint.run(all, m, streamOf(of.use, m, r), noise_).reshaped();
    }
    used_ += of.runs * costOf(of.joint);
  }
  return values;
}

}  // namespace nao::validation
