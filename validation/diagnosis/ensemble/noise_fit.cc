#include "validation/diagnosis/ensemble/noise_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.h"
#include "sim/effects/parameter.h"
#include "validation/diagnosis/ensemble/ensemble.h"
#include "validation/diagnosis/ensemble/repeats.h"

namespace nao::validation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kLags = 30;        // rows: 0.3 s at 100 Hz, longer than a joint's noise remembers
constexpr double kSticks = 0.1;  // of the usual variance: what is less is no shaking
constexpr double kTiny = 1e-18;  // [rad^2]
constexpr std::size_t kSimulated = 12;  // repeats, so that their moments are no guess themselves

// Of a joint whose robot's file says nothing; estimates, only where a fit begins.
constexpr double kUsualTorque = 0.018;  // of what the motor gives
constexpr double kUsualTime = 0.05;     // [s]
constexpr double kUsualStart = 1e-3;    // [s] orders and clocks meet about once per cycle

bool counts(const JointMotion& motion) {
  return motion.split != Split::Test && motion.repeats.size() > 1;
}

VectorXd meanOf(const JointMotion& motion) {
  VectorXd mean = VectorXd::Zero(motion.repeats.front().rows());
  for (const MatrixXd& run : motion.repeats) mean += run.col(0);
  return mean / static_cast<double>(motion.repeats.size());
}

// Of every run about the mean of the repeats, a column per run, scaled so that squares are not too
// small for the mean being theirs; what runs differ by as they come late, as each shows where the
// joint moves, is taken off.
MatrixXd deviationsOf(const JointMotion& motion, VectorXd* lateness = nullptr) {
  const VectorXd mean = meanOf(motion), rate = rateOf(mean, motion.dt);
  MatrixXd all(mean.size(), static_cast<Index>(motion.repeats.size()));
  if (lateness != nullptr) lateness->resize(all.cols());
  for (Index r = 0; r < all.cols(); ++r) {
    all.col(r) = motion.repeats[static_cast<std::size_t>(r)].col(0) - mean;
    const double late = latenessOf(all.col(r), rate);
    all.col(r) += late * rate;
    if (lateness != nullptr) (*lateness)[r] = late;
  }
  return all;
}

// Sums over runs.
struct Sums {
  double squares = 0, samples = 0;
  double starts = 0, runs = 0;
  VectorXd covariance = VectorXd::Zero(kLags + 1);
  VectorXd pairs = VectorXd::Zero(kLags + 1);

  void add(const JointMotion& motion) {
    VectorXd lateness;
    const MatrixXd deviations = deviationsOf(motion, &lateness);
    const auto repeats = static_cast<double>(motion.repeats.size());
    const double unbiased = repeats / (repeats - 1);
    const VectorXd mean = meanOf(motion);
    for (Index r = 0; r < deviations.cols(); ++r) {
      squares +=
          unbiased * (motion.repeats[static_cast<std::size_t>(r)].col(0) - mean).squaredNorm();
      samples += static_cast<double>(mean.size());
      const VectorXd deviation = deviations.col(r);
      for (Index lag = 0; lag <= kLags && lag < deviation.size(); ++lag) {
        const Index n = deviation.size() - lag;
        covariance[lag] += unbiased * deviation.head(n).dot(deviation.tail(n));
        pairs[lag] += static_cast<double>(n);
      }
    }
    starts += unbiased * lateness.squaredNorm();
    runs += repeats;
  }
};

std::vector<JointMotion> simulatedRepeats(const JointSimulator& joint,
                                          const std::vector<EffectSetting>& causes,
                                          const JointNoise& noise, std::size_t least = 0) {
  std::vector<JointMotion> all;
  for (std::size_t m = 0; m < joint.measured().size(); ++m) {
    JointMotion motion = joint.measured()[m];
    if (!counts(motion)) continue;
    motion.repeats.resize(std::max(least, motion.repeats.size()));
    for (std::size_t r = 0; r < motion.repeats.size(); ++r) {
      motion.repeats[r] =
          joint.run(causes, m, streamOf(StreamUse::Noise, m, static_cast<int>(r)), noise);
    }
    all.push_back(std::move(motion));
  }
  return all;
}

// Of every second of every motion, how the deviations go together with themselves some rows later:
// a row per second, a column per lag. Where a cause makes a joint shake or stick it does so in some
// seconds; the others tell the noise.
MatrixXd momentsBySecond(const std::vector<JointMotion>& motions) {
  std::vector<VectorXd> seconds;
  for (const JointMotion& motion : motions) {
    if (!counts(motion)) continue;
    const MatrixXd deviations = deviationsOf(motion);
    const auto length = static_cast<Index>(std::lround(1 / motion.dt));
    for (Index at = 0; at + length <= deviations.rows() && length > kLags; at += length) {
      VectorXd row(kLags + 1);
      for (Index lag = 0; lag <= kLags; ++lag) {
        const Index n = length - lag;
        row[lag] =
            deviations.middleRows(at, n).cwiseProduct(deviations.middleRows(at + lag, n)).sum() /
            static_cast<double>(n * (deviations.cols() - 1));
      }
      seconds.push_back(std::move(row));
    }
  }
  MatrixXd all(static_cast<Index>(seconds.size()), kLags + 1);
  for (std::size_t i = 0; i < seconds.size(); ++i) all.row(static_cast<Index>(i)) = seconds[i];
  return all;
}

// What lasts for more than one row is the torque's.
VectorXd lastingPart(const MatrixXd& moments) { return moments.middleCols(1, 4).rowwise().sum(); }

double median(VectorXd values) {
  if (values.size() == 0) return 0;
  const auto middle = values.data() + values.size() / 2;
  std::nth_element(values.data(), middle, values.data() + values.size());
  return *middle;
}

// Of what is measured beside what is simulated, second by second and each by its own size, so that
// a few that are far off count no more than others; those in which the joint sticks hardly count.
double distance(const MatrixXd& measured, const MatrixXd& simulated) {
  const VectorXd size = measured.col(0) + simulated.col(0);
  const double least = kSticks * median(size);
  double sum = 0;
  for (Index i = 0; i < size.size(); ++i) {
    const VectorXd beside = measured.row(i) - simulated.row(i);
    sum += beside.cwiseAbs().mean() / std::max({size[i], least, kTiny});
  }
  return sum;
}

// The torque and the jitter beside it that give the measured moments, for one correlation time.
struct Trial {
  JointNoise noise;
  double error = 0;
};

class NoiseSearch {
 public:
  NoiseSearch(const JointSimulator& joint, const std::vector<EffectSetting>& causes)
      : joint_(joint), causes_(causes), measured_(momentsBySecond(joint.measured())) {}

  // From the time that is likeliest beforehand up or down as long as it gets better; the torque
  // goes on from one time to the next.
  Trial from(const JointNoise& first) const {
    const auto begin = std::min_element(kTimes.begin(), kTimes.end(), [&](double a, double b) {
      return std::abs(std::log(a / first.torque_time)) < std::abs(std::log(b / first.torque_time));
    });
    Trial best = at(first, *begin);
    auto up = begin + 1;
    while (up != kTimes.end() && improve(best, *up)) ++up;
    if (up != begin + 1) return best;
    auto down = begin;
    while (down != kTimes.begin() && improve(best, *(down - 1))) --down;
    return best;
  }

 private:
  static constexpr std::array kTimes = {0.02, 0.03, 0.045, 0.07, 0.1, 0.15, 0.25};  // [s]
  static constexpr int kRounds = 2;  // spread grows nearly in proportion to the torque

  bool improve(Trial& best, double time) const {
    const Trial trial = at(best.noise, time);
    if (trial.error >= best.error) return false;
    best = trial;
    return true;
  }

  Trial at(JointNoise noise, double time) const {
    noise.torque_time = time;
    noise.jitter = 0;
    for (int round = 0; round < kRounds; ++round) {
      const double part = median(ratios(lastingPart(measured_), lastingPart(simulated(noise))));
      const double times = std::sqrt(std::clamp(part, 0.01, 100.0));
      noise.torque_sd = std::min(noise.torque_sd * times, most_);
    }
    MatrixXd found = simulated(noise);
    const double white = std::max(0.0, median(measured_.col(0) - found.col(0)));
    found.col(0).array() += white;
    noise.jitter = std::sqrt(2 * white);  // variance: half of its square
    return {noise, distance(measured_, found)};
  }

  MatrixXd simulated(const JointNoise& noise) const {
    return momentsBySecond(simulatedRepeats(joint_, causes_, noise, kSimulated));
  }
  // Of seconds in which the joint is stuck neither here nor there.
  static VectorXd ratios(const VectorXd& measured, const VectorXd& simulated) {
    VectorXd all(measured.size());
    Index n = 0;
    for (Index i = 0; i < all.size(); ++i) {
      if (simulated[i] > 0 && measured[i] > 0) all[n++] = measured[i] / simulated[i];
    }
    return all.head(n);
  }

  const JointSimulator& joint_;
  const std::vector<EffectSetting>& causes_;
  MatrixXd measured_;
  // [N m] A joint that sticks asks for any.
  double most_ = sim::parameterOf(sim::standardEffects(), "process_noise", "sd").max;
};

// Of the robot's file, which gives them all.
double numberOf(const EffectSetting& effect, const char* name, double otherwise) {
  const auto at = effect.parameters.find(name);
  return at == effect.parameters.end() ? otherwise : at->second;
}

}  // namespace

JointNoise nominalNoise(const RobotModel& model, Joint joint) {
  const Actuator& motor = model.actuators[index(joint)];
  JointNoise noise;
  noise.torque_sd = kUsualTorque * motor.efficiency * motor.stall_torque;
  noise.torque_time = kUsualTime;
  noise.start_sd = kUsualStart;
  if (model.noise.empty()) return noise;
  noise.start_sd = model.start_sd;
  noise.torque_sd = 0;
  for (const EffectSetting& effect : model.noise) {
    const auto& on = effect.joints;
    if (!on.empty() && std::find(on.begin(), on.end(), joint) == on.end()) continue;
    if (effect.name == "process_noise") {
      noise.torque_sd = numberOf(effect, "sd", noise.torque_sd);
      noise.torque_time = numberOf(effect, "time", kUsualTime);
    }
    if (effect.name == "encoder_jitter") noise.jitter = numberOf(effect, "amplitude", 0);
  }
  return noise;
}

NoiseMoments momentsOf(const std::vector<JointMotion>& motions) {
  Sums sums;
  for (const JointMotion& motion : motions) {
    if (counts(motion)) sums.add(motion);
  }
  NoiseMoments moments;
  if (sums.samples == 0) return moments;
  moments.sd = std::sqrt(sums.squares / sums.samples);
  moments.start_sd = std::sqrt(sums.starts / sums.runs);
  for (Index lag = 0; lag <= kLags; ++lag) {
    moments.covariance.push_back(sums.covariance[lag] / std::max(1.0, sums.pairs[lag]));
  }
  return moments;
}

NoiseComparison compareNoise(const JointSimulator& joint, const JointNoise& noise) {
  return {momentsOf(joint.measured()), momentsOf(simulatedRepeats(joint, {}, noise))};
}

JointNoise fitNoise(const JointSimulator& joint, const JointNoise& first,
                    const std::vector<EffectSetting>& causes) {
  const NoiseMoments measured = momentsOf(joint.measured());
  if (measured.covariance.empty()) return first;
  JointNoise start = first;
  if (start.torque_sd <= 0) start.torque_sd = 0.02;  // [N m] anything that moves the joint
  start.start_sd =
      measured.start_sd;  // what a shift leaves of a late start looks like a slow torque
  const Trial best = NoiseSearch(joint.coarse(), causes).from(start);
  // Noise alone makes runs look late too: only what is more than that are starts.
  JointNoise noise = best.noise;
  noise.start_sd = 0;
  const double apparent =
      momentsOf(simulatedRepeats(joint.coarse(), causes, noise, 2 * kSimulated)).start_sd;
  noise.start_sd =
      std::sqrt(std::max(0.0, measured.start_sd * measured.start_sd - apparent * apparent));
  return noise;
}

}  // namespace nao::validation
