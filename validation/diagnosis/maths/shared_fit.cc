#include "validation/diagnosis/maths/shared_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace nao::validation {
namespace {

constexpr double kWidth = 0.3, kShrink = 0.35;  // of the number, per round
constexpr int kNarrowed = 3, kMostRounds = 8, kHalvings = 5;

double sum(const std::vector<double>& gains) {
  return std::accumulate(gains.begin(), gains.end(), 0.0);
}

}  // namespace

SharedFit::SharedFit(std::function<std::vector<double>(double)> gains_at, double lower,
                     double upper)
    : gains_at_(std::move(gains_at)), lower_(lower), upper_(upper) {}

void SharedFit::narrow(double centre) {
  double width = kWidth * std::abs(centre);
  for (int round = 0, narrowed = 0; round < kMostRounds && narrowed < kNarrowed; ++round) {
    if (width <= 0) return;
    const double low = gainAt(centre - width), mid = gainAt(centre), high = gainAt(centre + width),
                 bend = low - 2 * mid + high;
    const double move =
        bend < 0 ? (low - high) / (2 * bend) * width : (high > low ? width : -width);
    centre += std::clamp(move, -2 * width, 2 * width);
    const bool between = bend < 0 && std::abs(move) <= width;
    width = between ? kShrink * width : kWidth * std::abs(centre);
    if (between) ++narrowed;
  }
  gainAt(centre);
}

void SharedFit::tryAll(const std::vector<double>& numbers) {
  for (const double x : numbers) gainAt(x);
}

void SharedFit::halve(double width) {
  for (int round = 0; round < kHalvings; ++round, width /= 2) {
    const double centre = best();
    gainAt(centre - width);
    gainAt(centre + width);
  }
}

double SharedFit::best() const {
  return std::max_element(
             tried_.begin(), tried_.end(),
             [](const auto& a, const auto& b) { return sum(a.second) < sum(b.second); })
      ->first;
}

double SharedFit::gain() const { return sum(gains()); }

double SharedFit::gainAt(double x) {
  x = std::clamp(x, lower_, upper_);
  auto found = tried_.find(x);
  if (found == tried_.end()) found = tried_.emplace(x, gains_at_(x)).first;
  return sum(found->second);
}

}  // namespace nao::validation
