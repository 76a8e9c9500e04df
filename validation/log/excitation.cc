#include "validation/log/excitation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nao::validation {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kGolden = 0.6180339887498949;  // 1 / golden ratio
constexpr double kRise = 0.5;                   // [s] of the envelope; free choice
// Their square roots are independent of each other over the rationals, so multiples of them spread
// evenly in any number of dimensions.
constexpr std::array<double, 32> kPrimes{2,  3,  5,  7,   11,  13,  17,  19,  23,  29, 31,
                                         37, 41, 43, 47,  53,  59,  61,  67,  71,  73, 79,
                                         83, 89, 97, 101, 103, 107, 109, 113, 127, 131};
// Of the top speed, a free choice: sines stay where the motor still has torque to follow.
constexpr double kSineSpeed = 0.7;
constexpr double kSmallStep = 0.06;  // [rad] raw: beyond what leg servos can pull at once
constexpr double kStepSize = 0.8;    // of the half range
constexpr std::size_t kSmallEvery = 3;

double fraction(double x) { return x - std::floor(x); }

/// 0 at 0, 1, 0, -1, 0 at 1, in straight lines.
double zigzag(double phase) {
  const double x = fraction(phase + 0.25);
  return x < 0.5 ? 4 * x - 1 : 3 - 4 * x;
}

/// The part of the half range that a sine of this frequency [Hz] may have.
double calcAmplitude(const Pace& pace, double frequency, double part) {
  const double fastest = kSineSpeed * pace.max_speed / (2 * kPi * frequency * pace.half_range);
  return part * std::min(1.0, fastest);
}

double sine(const Pace& pace, double frequency, double part, double phase, double t) {
  return calcAmplitude(pace, frequency, part) * std::sin(2 * kPi * (frequency * t + phase));
}

/// The frequency [Hz] at which a sine of this part of the half range is as fast as sines may be,
/// or a bit less; within what shows inertia and delays without wearing the gears.
double chooseFast(const Pace& pace, double part, double lowest, std::size_t salt) {
  constexpr double kHighest = 4.5;  // [Hz] free choice
  const double fastest = kSineSpeed * pace.max_speed / (2 * kPi * part * pace.half_range);
  return std::clamp(fastest, lowest, kHighest) * pace.choose(0.75, 1, salt);
}

/// Frequency rising from `from` to `to` [Hz] over `length` [s], smaller as it gets faster.
double sweep(const Pace& pace, double from, double to, double length, double t) {
  const double rate = std::log(to / from) / length;
  const double now = from * std::exp(rate * t);
  const double phase = from * (std::exp(rate * t) - 1) / rate + pace.choose(0, 1, 11);
  return calcAmplitude(pace, now, 0.7) * std::sin(2 * kPi * phase);
}

/// Where the k-th hold of a stair is: every third a small step from the one before, the others so
/// far apart that a ramp takes most of a hold at the most.
double calcHold(const Pace& pace, double hold, std::size_t k, std::size_t salt) {
  const bool small = k % kSmallEvery == 2;
  const double order = static_cast<double>(small ? k : k + 1);
  const double reach = std::min(kStepSize, 0.35 * pace.ramp_speed * hold / pace.half_range);
  const double stride = pace.choose(0.28, 0.45, salt + 2);
  const double level = reach * (2 * fraction(order * stride + pace.choose(0, 1, salt)) - 1);
  return small ? level + kSmallStep / pace.half_range : level;
}

/// Holds of `hold` [s]; each begins with a fast ramp, every third with the small step, raw.
double climb(const Pace& pace, double hold, std::size_t salt, double t) {
  const auto k = static_cast<std::size_t>(std::max(t, 0.0) / hold);
  const double goal = calcHold(pace, hold, k, salt);
  if (k % kSmallEvery == 2) return goal;
  const double from = k == 0 ? 0 : calcHold(pace, hold, k - 1, salt);
  const double since = t - static_cast<double>(k) * hold;
  const double way = pace.ramp_speed / pace.half_range * since;
  return from + std::clamp(goal - from, -way, way);
}

/// From end to end in straight lines with a hold at each end.
double trapezoid(double phase) { return std::clamp(2 * zigzag(phase), -1.0, 1.0); }

}  // namespace

double Pace::choose(double low, double high, std::size_t salt) const {
  return low + (high - low) * fraction(static_cast<double>(joint + 1) * std::sqrt(kPrimes[salt]));
}

double calcEnvelope(double t, double length) {
  if (t <= 0 || t >= length) return 0;
  const double x = std::min({t / kRise, (length - t) / kRise, 1.0});
  return x * x * (3 - 2 * x);
}

double triangles(const Pace& pace, double t) {
  return zigzag(t / pace.choose(2.2, 4.2, 1) + pace.choose(0, 1, 2));
}

double tones(const Pace& pace, double t) {
  return sine(pace, pace.choose(0.3, 0.7, 3), 0.55, pace.choose(0, 1, 4), t) +
         sine(pace, chooseFast(pace, 0.45, 1.5, 5), 0.45, pace.choose(0, 1, 6), t);
}

double reach(const Pace& pace, double t) {
  // A joint whose range depends on another holds its ends while that one goes from end to end.
  const double period = pace.limited ? pace.choose(1.3, 1.8, 7) : pace.choose(3.6, 5.4, 7);
  return trapezoid(t / period + pace.choose(0, 1, 8));
}

double stairs(const Pace& pace, double t) { return climb(pace, pace.choose(0.5, 0.85, 9), 10, t); }

double varied(const Pace& pace, double t) {
  constexpr double kThird = 2;  // [s]
  const double since = std::fmod(t, kThird);
  const double envelope = calcEnvelope(since, kThird);
  if (t < kThird) {
    const double period = pace.choose(1.5, 2.2, 12), slope = 8 / period;
    const double part = std::min(1.0, kSineSpeed * pace.max_speed / (slope * pace.half_range));
    return envelope * part * trapezoid(t / period + pace.choose(0, 1, 13));
  }
  if (t < 2 * kThird) {
    return envelope * (sine(pace, pace.choose(0.5, 0.9, 14), 0.6, pace.choose(0, 1, 15), t) +
                       sine(pace, chooseFast(pace, 0.4, 1.7, 16), 0.4, pace.choose(0, 1, 17), t));
  }
  return envelope * sweep(pace, pace.choose(0.6, 1, 18), pace.choose(3, 5, 19), kThird, since);
}

double crossing(const Pace& pace, double t) {
  constexpr double kHalf = 3;  // [s]
  if (t < kHalf) {
    const double phase = t / pace.choose(1.6, 3, 20) + pace.choose(0, 1, 21);
    return calcEnvelope(t, kHalf) * zigzag(phase);
  }
  return climb(pace, pace.choose(0.4, 0.7, 22), 23, t - kHalf);
}

double quick(const Pace& pace, double t) {
  return sine(pace, pace.choose(0.2, 0.35, 24), 0.55, pace.choose(0, 1, 25), t) +
         sine(pace, pace.choose(0.8, 1.2, 26), 0.15, pace.choose(0, 1, 27), t) +
         sine(pace, chooseFast(pace, 0.15, 1.9, 28), 0.15, pace.choose(0, 1, 29), t) +
         sine(pace, pace.choose(2.4, 3.4, 30), 0.15, pace.choose(0, 1, 31), t);
}

}  // namespace nao::validation
