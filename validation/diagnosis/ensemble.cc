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

Halves RunPool::halves() const {
  Halves halves{Eigen::VectorXd(mean.size()), Eigen::VectorXd(mean.size())};
  Eigen::Index offset = 0;
  for (const Eigen::MatrixXd& columns : runs) {
    const auto every = [&](Eigen::Index first) -> Eigen::VectorXd {
      const Eigen::MatrixXd half = columns(Eigen::all, Eigen::seq(first, Eigen::last, 2));
      return half.rowwise().mean();
    };
    halves.first.segment(offset, columns.rows()) = every(0);
    halves.second.segment(offset, columns.rows()) = every(1);
    offset += columns.rows();
  }
  return halves;
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

Halves Ensemble::halves(const std::vector<EffectSetting>& causes, int runs) {
  return halvesOf(joint_.coarse(), causes, runs, noise_);
}

Halves Ensemble::roughHalves(const std::vector<EffectSetting>& causes, int runs) {
  return halvesOf(joint_.rough(), causes, runs, noise_);
}

Halves Ensemble::unroundedHalves(const std::vector<EffectSetting>& causes, int runs) {
  JointNoise noise = noise_;
  noise.quantum = 0;
  std::vector<EffectSetting> all = causes;
  const double own = joint_.present("encoder_quantum", "quantum");
  if (own != 0) all.push_back({"encoder_quantum", {{"quantum", -own}}, joint_.place(), ""});
  return halvesOf(joint_.rough(), all, runs, noise);
}

Halves Ensemble::halvesOf(const JointSimulator& joint, const std::vector<EffectSetting>& causes,
                          int runs, const JointNoise& noise) {
  NAO_CHECK(runs % 2 == 0 && runs > 0);
  return {recalled([&] { return meanOf(joint, causes, 0, runs, 2, noise); }),
          recalled([&] { return meanOf(joint, causes, 1, runs, 2, noise); })};
}

Eigen::VectorXd Ensemble::rough(const std::vector<EffectSetting>& causes) {
  return recalled([&] { return meanOf(joint_.rough(), causes, 0, 1, 1, noise_); });
}

Eigen::VectorXd Ensemble::roughOf(const std::vector<EffectSetting>& causes,
                                  const MotionSpan& span) {
  return recalled([&]() -> Eigen::VectorXd {
    ++used_;
    const std::uint64_t stream = streamOf(StreamUse::Mean, span.motion, 0);
    return joint_.rough().run(withGiven(causes), span.motion, stream, noise_).reshaped();
  });
}

// Of every `every`-th of the runs 0 to `runs` - 1, from the `first` on.
Eigen::VectorXd Ensemble::meanOf(const JointSimulator& joint,
                                 const std::vector<EffectSetting>& causes, int first, int runs,
                                 int every, const JointNoise& noise) {
  const std::vector<EffectSetting> all = withGiven(causes);
  const int count = (runs - first + every - 1) / every;
  std::vector<Eigen::MatrixXd> means;
  for (const MotionSpan& span : data_.spans()) {
    const std::size_t m = span.motion;
    Eigen::MatrixXd sum = joint.run(all, m, streamOf(StreamUse::Mean, m, first), noise);
    for (int r = first + every; r < runs; r += every) {
      sum += joint.run(all, m, streamOf(StreamUse::Mean, m, r), noise);
    }
    means.push_back(sum / count);
    used_ += count;
  }
  return data_.stack(means);
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
  const long cost = &joint == &joint_ ? 1 : kExactCost;
  RunPool pool;
  for (const MotionSpan& span : data_.spans()) {
    const std::size_t m = span.motion;
    Eigen::MatrixXd columns(span.size(), runs);
    for (int r = 0; r < runs; ++r) {
      columns.col(r) = joint.run(all, m, streamOf(StreamUse::Pool, m, r), noise_).reshaped();
    }
    pool.runs.push_back(std::move(columns));
    used_ += runs * cost;
  }
  return pool;
}

}  // namespace nao::validation
