#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/ensemble/joint_simulator.h"
#include "validation/diagnosis/maths/halves.h"

namespace nao::validation {

class EnsembleTape;
class JointData;
struct MotionSpan;

/// What a run's random numbers are for: streams of different use never meet.
enum class StreamUse : std::uint64_t { Mean = 1, Pool = 2, Spread = 4, Noise = 5, Replay = 6 };

/// Many runs of every motion with one model, all alike but for their noise.
struct RunPool {
  std::vector<Eigen::MatrixXd> runs;  // by span; a column per run, signal by signal, row by row
  Eigen::VectorXd mean;               // stacked as JointData
  bool mirrored = false;              // in pairs (run_noise.h)
  /// The mean's variance over that of as many runs that know nothing of each other: mirrored ones
  /// leave a twentieth of it, a quarter where encoders round.
  double pairing = 1;

  /// As many runs of their own would make as certain a mean.
  double worth() const { return static_cast<double>(runs.front().cols()) / pairing; }
  /// Independent deviations of single runs of a span, of their full variance, a column each:
  /// differences of the pairs, or, where there are none, from the mean.
  Eigen::MatrixXd deviations(std::size_t span) const;
  /// What a set measured again would differ from `mean`, were the mean's runs others: the mean of
  /// as many runs of each span as it has repeats, drawn by `seed` (different ones, as long as they
  /// are not nearly all), widened by what the mean itself is uncertain. Two runs or more.
  Eigen::VectorXd measuredAgain(const JointData& data, std::uint64_t seed) const;
};

/// Which motions are simulated: those that numbers are fitted to, or those that choose between
/// causes as well.
enum class Over { Fit, All };

/// The stream of one repeat of one motion: the same for every list of causes. Runs that a mean is
/// made of mirror each other in pairs (run_noise.h), those that only show how runs differ do not.
constexpr std::uint64_t streamOf(StreamUse use, std::size_t motion, int repeat) {
  const bool paired = use != StreamUse::Spread && use != StreamUse::Noise;
  const auto run = static_cast<std::uint64_t>(repeat);
  return (static_cast<std::uint64_t>(use) << 56) | (static_cast<std::uint64_t>(motion) << 40) |
         (paired ? run : (run / 2) * 4 + run % 2);
}

/// Predicts the mean of a joint's noisy runs, stacked as its JointData, and counts the runs. What
/// is compared with the measurement comes from a pool of exact() runs; what causes change, from
/// runs before an encoder rounds them: of a mean that moves by a tenth of a count, rounded readings
/// are mostly chance. Causes that alter the rounding itself are seen with it. One thread.
class Ensemble {
 public:
  /// `granted`: how many runs may be simulated in all.
  Ensemble(const JointSimulator& joint, const JointData& data, const JointNoise& noise,
           long granted);

  /// Mean of `runs` runs per motion in coarse steps, an even number, by the runs of even and of odd
  /// streams, to subtract from another of as many: the same random numbers for every list of
  /// causes. Over fit motions it ends where they do.
  Halves halves(const std::vector<EffectSetting>& causes, int runs, Over motions = Over::All);
  /// The same of rough and of exact runs, and of one rough run of the fit motions.
  Halves roughHalves(const std::vector<EffectSetting>& causes, int runs, Over motions = Over::All);
  Halves exactHalves(const std::vector<EffectSetting>& causes, int runs, Over motions = Over::All);
  Eigen::VectorXd rough(const std::vector<EffectSetting>& causes);
  /// Of one motion alone.
  Eigen::VectorXd roughOf(const std::vector<EffectSetting>& causes, const MotionSpan& span);
  /// `runs` exact runs per motion, as an encoder reports them.
  RunPool pool(const std::vector<EffectSetting>& causes, int runs);
  /// The same of runs in coarse steps that know nothing of each other: how runs differ.
  RunPool spread(const std::vector<EffectSetting>& causes, int runs);

  /// Fits the noise anew, with these causes in the model: what shakes a joint or holds it is no
  /// noise of its own.
  void learnNoise(const std::vector<EffectSetting>& causes);
  void setNoise(const JointNoise& noise) { noise_ = noise; }

  /// Causes that every model has from now on, such as what all joints share.
  void setGiven(std::vector<EffectSetting> given) { given_ = std::move(given); }

  const std::vector<EffectSetting>& given() const { return given_; }

  /// From now on what is asked is taken from the tape, as far as it goes, and added to it; null:
  /// simulated. The tape must outlive its use.
  void setTape(EnsembleTape* tape) { tape_ = tape; }
  /// Told after every ensemble how many runs there were so far.
  void setWatch(std::function<void(long)> watch) { watch_ = std::move(watch); }

  std::vector<Joint> carried() const { return joint_.carried(); }
  const JointNoise& noise() const { return noise_; }
  const JointData& data() const { return data_; }
  long used() const { return used_; }
  /// Whether all runs granted have been used.
  bool spent() const { return used_ >= granted_; }

 private:
  struct Prediction {  // of what, with which noise
    std::vector<EffectSetting> causes;
    JointNoise noise;
  };

  Eigen::VectorXd recalled(const std::function<Eigen::VectorXd()>& simulate);
  struct PoolOf {
    const JointSimulator& joint;
    StreamUse use;
    int runs;
  };
  RunPool poolOf(const std::vector<EffectSetting>& causes, const PoolOf& of);
  Eigen::VectorXd simulatedPool(const std::vector<EffectSetting>& causes, const PoolOf& of);
  Halves halvesOf(const JointSimulator& joint, const std::vector<EffectSetting>& causes, int runs,
                  Over motions);
  Eigen::VectorXd meanOf(const JointSimulator& joint, const Prediction& of, Over motions, int first,
                         int runs, int every);
  long costOf(const JointSimulator& joint) const;
  Prediction unrounded(const std::vector<EffectSetting>& causes) const;
  std::vector<EffectSetting> withGiven(const std::vector<EffectSetting>& causes) const;

  const JointSimulator& joint_;
  const JointData& data_;
  JointNoise noise_;
  std::vector<EffectSetting> given_;
  long granted_, used_ = 0;
  EnsembleTape* tape_ = nullptr;
  std::function<void(long)> watch_;
};

}  // namespace nao::validation
