#include "validation/diagnosis/noise_fit.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "validation/diagnosis/ensemble.h"
#include "validation/diagnosis/repeats.h"

namespace nao::validation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kLags = 30;  // rows: 0.3 s at 100 Hz, longer than a joint's noise remembers

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

// Sums over runs, each of which knows its own start from where the joint moves.
struct Sums {
  double squares = 0, samples = 0;
  double starts = 0, runs = 0;
  VectorXd covariance = VectorXd::Zero(kLags + 1);
  VectorXd pairs = VectorXd::Zero(kLags + 1);

  void add(const JointMotion& motion) {
    const VectorXd mean = meanOf(motion), rate = rateOf(mean, motion.dt);
    const auto repeats = static_cast<double>(motion.repeats.size());
    const double unbiased = repeats / (repeats - 1);
    for (const MatrixXd& run : motion.repeats) {
      VectorXd deviation = run.col(0) - mean;
      squares += unbiased * deviation.squaredNorm();
      samples += static_cast<double>(deviation.size());
      const double late = latenessOf(deviation, rate);
      starts += unbiased * late * late;
      deviation += late * rate;
      runs += 1;
      for (Index lag = 0; lag <= kLags && lag < deviation.size(); ++lag) {
        const Index n = deviation.size() - lag;
        covariance[lag] += unbiased * deviation.head(n).dot(deviation.tail(n));
        pairs[lag] += static_cast<double>(n);
      }
    }
  }
};

std::vector<JointMotion> simulatedRepeats(const JointSimulator& joint, const JointNoise& noise) {
  std::vector<JointMotion> all;
  for (std::size_t m = 0; m < joint.measured().size(); ++m) {
    JointMotion motion = joint.measured()[m];
    if (!counts(motion)) continue;
    for (std::size_t r = 0; r < motion.repeats.size(); ++r) {
      motion.repeats[r] =
          joint.run({}, m, streamOf(StreamUse::Noise, m, static_cast<int>(r)), noise);
    }
    all.push_back(std::move(motion));
  }
  return all;
}

// Parts of two shapes, not below 0, that come nearest to `wanted`.
struct Parts {
  double first = 0, second = 0, error = 0;
};

Parts nearest(const VectorXd& wanted, const VectorXd& a, const VectorXd& b) {
  const auto errorOf = [&](double x, double y) { return (wanted - x * a - y * b).squaredNorm(); };
  const double aa = a.dot(a), bb = b.dot(b), ab = a.dot(b), aw = a.dot(wanted), bw = b.dot(wanted);
  const double det = aa * bb - ab * ab;
  Parts best{std::max(0.0, aa > 0 ? aw / aa : 0), 0, 0};
  best.error = errorOf(best.first, 0);
  if (det <= 1e-12 * aa * bb) return best;
  const Parts both{(aw * bb - bw * ab) / det, (bw * aa - aw * ab) / det, 0};
  if (both.first < 0 || both.second < 0) return best;
  return {both.first, both.second, errorOf(both.first, both.second)};
}

VectorXd vectorOf(const std::vector<double>& list) {
  return Eigen::Map<const VectorXd>(list.data(), static_cast<Index>(list.size()));
}

// The torque and the jitter beside it that give the measured covariance, for one time.
struct Trial {
  JointNoise noise;
  double error = 0;
};

Trial tryTime(const JointSimulator& joint, const NoiseMoments& measured, JointNoise noise,
              double time) {
  constexpr int kRounds = 2;  // spread grows nearly in proportion to the torque
  Trial trial;
  noise.torque_time = time;
  noise.jitter = noise.start_sd = 0;
  VectorXd white = VectorXd::Zero(kLags + 1);
  white[0] = 1;
  const VectorXd wanted = vectorOf(measured.covariance);
  for (int round = 0; round < kRounds; ++round) {
    const NoiseMoments found = momentsOf(simulatedRepeats(joint, noise));
    const Parts parts = nearest(wanted, vectorOf(found.covariance), white);
    noise.torque_sd *= std::sqrt(std::clamp(parts.first, 1e-4, 1e4));
    trial = {noise, parts.error};
    trial.noise.jitter = std::sqrt(2 * parts.second);  // variance: half of its square
  }
  return trial;
}

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
  return {momentsOf(joint.measured()), momentsOf(simulatedRepeats(joint, noise))};
}

JointNoise fitNoise(const JointSimulator& joint, const JointNoise& first) {
  const NoiseMoments measured = momentsOf(joint.measured());
  if (measured.covariance.empty()) return first;
  JointNoise start = first;
  if (start.torque_sd <= 0) start.torque_sd = 0.02;  // [N m] anything that moves the joint
  Trial best;
  bool begun = false;
  for (const double time : {0.02, 0.05, 0.12, 0.3}) {
    const Trial trial = tryTime(joint, measured, start, time);
    if (begun && trial.error >= best.error) continue;
    best = trial;
    begun = true;
  }
  // Noise alone makes runs look late too: only what is more than that are starts.
  JointNoise noise = best.noise;
  const double apparent = momentsOf(simulatedRepeats(joint, noise)).start_sd;
  noise.start_sd =
      std::sqrt(std::max(0.0, measured.start_sd * measured.start_sd - apparent * apparent));
  return noise;
}

}  // namespace nao::validation
