#pragma once

#include <utility>
#include <vector>

#include "validation/log/robot_log.h"

// A joint's signals on an even grid of time, and how alike two of them are.
namespace nao::validation {

/// `values` at 0, dt, 2 dt ... after the first time, linear between samples; NaNs are bridged.
/// Empty if less than two are known, or if they are a hundred times rarer than that.
std::vector<double> resample(const std::vector<double>& t, const Column& values, double dt);

/// Sums for a coefficient of correlation over several pieces, each about its own mean.
class Correlation {
 public:
  /// Compares a[i] with b[i + lag] where both are there and `use` (empty: all) holds.
  void add(const std::vector<double>& a, const std::vector<double>& b, int lag,
           const std::vector<bool>& use = {});
  /// -1 to 1; 0 where one of the two stands still.
  double value() const;
  /// Of b on a: b changes by this much for 1 of a.
  double slope() const;

 private:
  double aa_ = 0, bb_ = 0, ab_ = 0;
};

/// Differences over two steps, half: (x[i+1] - x[i-1]) / 2, 0 at the ends.
std::vector<double> differences(const std::vector<double>& values);

/// The step of which all values are whole multiples (apart from an offset) [rad]; 0: none, or too
/// few values to tell.
double findQuantum(std::vector<double> values);

/// Where the whole counts of `quantum` [rad] lie that all values are: beside 0 by at most half of
/// one [rad], as of a zero that was set in software. 0 if the values are no such counts.
double findPhase(const std::vector<double>& values, double quantum);

}  // namespace nao::validation
