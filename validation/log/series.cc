#include "validation/log/series.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace nao::validation {

std::vector<double> resample(const std::vector<double>& t, const Column& values, double dt) {
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const bool later = known.empty() || t[i] > t[known.back()];
    if (later && !std::isnan(values[i])) known.push_back(i);
  }
  std::vector<double> even;
  if (known.size() < 2 || !(dt > 0)) return even;
  const double steps = (t[known.back()] - t.front()) / dt;
  if (!(steps < 100 * static_cast<double>(t.size()))) return even;  // a clock that jumped
  const auto rows = static_cast<std::size_t>(steps + 1e-6) + 1;
  std::size_t k = 1;
  for (std::size_t row = 0; row < rows; ++row) {
    const double time = t.front() + static_cast<double>(row) * dt;
    while (k + 1 < known.size() && t[known[k]] < time) ++k;
    const std::size_t a = known[k - 1], b = known[k];
    const double part = std::clamp((time - t[a]) / (t[b] - t[a]), 0.0, 1.0);
    even.push_back(values[a] + part * (values[b] - values[a]));
  }
  return even;
}

void Correlation::add(const std::vector<double>& a, const std::vector<double>& b, int lag,
                      const std::vector<bool>& use) {
  double n = 0, sum_a = 0, sum_b = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto j = static_cast<std::ptrdiff_t>(i) + lag;
    if (j < 0 || j >= static_cast<std::ptrdiff_t>(b.size())) continue;
    if (!use.empty() && !use[static_cast<std::size_t>(j)]) continue;
    const double x = a[i] - a.front(), y = b[static_cast<std::size_t>(j)] - b.front();
    n += 1, sum_a += x, sum_b += y, aa += x * x, bb += y * y, ab += x * y;
  }
  if (n < 2) return;
  aa_ += aa - sum_a * sum_a / n;
  bb_ += bb - sum_b * sum_b / n;
  ab_ += ab - sum_a * sum_b / n;
}

double Correlation::value() const {
  constexpr double kStill = 1e-12;  // [rad^2] sum of squares of rounding errors
  return aa_ > kStill && bb_ > kStill ? ab_ / std::sqrt(aa_ * bb_) : 0;
}

double Correlation::slope() const { return aa_ > 0 ? ab_ / aa_ : 0; }

std::vector<double> differences(const std::vector<double>& values) {
  std::vector<double> result(values.size(), 0);
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    result[i] = (values[i + 1] - values[i - 1]) / 2;
  }
  return result;
}

double findQuantum(std::vector<double> values) {
  constexpr double kRounding = 1e-7;  // [rad] two values nearer than this are one
  constexpr double kNear = 0.15;      // of a step: on the grid, though rounded to decimals
  constexpr double kMost = 0.95;      // of the differences are; a third would be by chance
  constexpr std::size_t kEnough = 8;  // differences to tell by
  constexpr double kLargest = 30;     // steps; larger differences tell nothing
  values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return std::isnan(x); }),
               values.end());
  std::sort(values.begin(), values.end());
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] - values[i - 1] > kRounding) steps.push_back(values[i] - values[i - 1]);
  }
  if (steps.size() < kEnough) return 0;
  std::sort(steps.begin(), steps.end());
  // The smaller ones are one step; what all say then makes it exact.
  double quantum = steps[steps.size() / 8];
  double sum_kd = 0, sum_kk = 0;
  for (const double d : steps) {
    const double k = std::round(d / quantum);
    if (k >= 1 && k <= kLargest) sum_kd += k * d, sum_kk += k * k;
  }
  quantum = sum_kd / sum_kk;
  std::size_t near = 0, all = 0;
  for (const double d : steps) {
    if (d / quantum > kLargest) continue;
    ++all;
    if (std::abs(d / quantum - std::round(d / quantum)) < kNear && d > quantum / 2) ++near;
  }
  return all >= kEnough && static_cast<double>(near) > kMost * static_cast<double>(all) ? quantum
                                                                                        : 0;
}

double findPhase(const std::vector<double>& values, double quantum) {
  constexpr double kTogether = 0.98;  // sum of unit vectors over their number; by chance about 0
  constexpr double kNone = 1e-3;      // of a count: rounding of decimals
  std::complex<double> sum = 0;
  double count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += std::polar(1.0, 2 * M_PI * value / quantum);
    ++count;
  }
  if (count == 0 || std::abs(sum) < kTogether * count) return 0;
  const double part = std::arg(sum) / (2 * M_PI);
  return std::abs(part) < kNone ? 0 : part * quantum;
}

}  // namespace nao::validation
