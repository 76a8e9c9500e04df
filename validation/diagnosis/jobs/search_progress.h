#pragma once

#include <cmath>

namespace nao::validation {

/// Which part of all a search has done, that does not know how long it takes. Of limbs and robots
/// in which one thing was hidden the scatter of the repeats took 0.1 to 0.2 of the time, looks and
/// null sets 0.3, then each phase (fits, the model anew) about a third of what was left.
class SearchProgress {
 public:
  /// One of several searches, that begins when `from` of all is done and is `share` of it.
  explicit SearchProgress(double from = 0, double share = 1) : from_(from), share_(share) {}

  /// Of the time of all: what its phases after the scatter of the repeats may take.
  double share() const { return share_ * kAhead; }

  /// As a phase begins.
  double nextPhase() { return from_ + share_ * (1 - kAhead * std::pow(kLeft, phases_++)); }

 private:
  static constexpr double kAhead = 0.85;  // of the first phase and those after it
  static constexpr double kLeft = 0.65;

  double from_, share_;
  int phases_ = 0;
};

}  // namespace nao::validation
