#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/archive.h"

namespace nao::sim {

/// Some numbers as they were a while ago, a fraction of a sample included. Per sample: put() each
/// of them, read late() or lateWhole(), then next(). Before the first sample everything was as it.
class DelayLine {
 public:
  /// `delay` in samples; down to -1: ahead of the latest, as the last two go on.
  DelayLine(std::size_t numbers, double delay)
      : numbers_(numbers),
        whole_(static_cast<std::size_t>(std::max(0.0, std::floor(delay + kRounding)))),
        part_(delay - static_cast<double>(whole_)),
        values_(numbers * slots()) {}

  void put(std::size_t i, double value) {
    values_[newest_ * numbers_ + i] = value;
    for (std::size_t slot = 0; begun_ == 0 && slot < slots(); ++slot) {
      values_[slot * numbers_ + i] = value;
    }
  }
  /// Linear between two samples.
  double late(std::size_t i) const {
    const double later = at(i, whole_);
    return later + part_ * (at(i, whole_ + 1) - later);
  }
  /// The later of the two, for what does not pass through values in between.
  double lateWhole(std::size_t i) const { return at(i, whole_); }
  void next() {
    if (++newest_ == slots()) newest_ = 0;
    begun_ = 1;
  }

  void archive(Archive& archive) {
    archive.value(newest_);
    archive.value(begun_);
    archive.list(values_);
  }

 private:
  static constexpr double kRounding = 1e-9;  // a delay of whole samples is one after a division too

  std::size_t slots() const { return whole_ + 2; }
  double at(std::size_t i, std::size_t ago) const {
    const std::size_t slot = newest_ < ago ? newest_ + slots() - ago : newest_ - ago;
    return values_[slot * numbers_ + i];
  }

  std::size_t numbers_;
  std::size_t whole_;           // samples of delay
  double part_;                 // of one sample more
  std::size_t newest_ = 0;      // slot of this sample
  std::size_t begun_ = 0;       // 0: this is the first
  std::vector<double> values_;  // by slot, then by number
};

}  // namespace nao::sim
