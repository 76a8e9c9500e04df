#pragma once

#include "core/archive.h"

namespace nao::motion {

/// A way from 0 to 1 in the least time its top speed allows: the speed rises smoothly during
/// `ramp`, stays, and falls as it rose. Its speed never passes 1 / way_time.
class SpeedProfile {
 public:
  /// `way_time` [s]: how long the way would take at top speed throughout; 0: no way to go.
  /// `ramp` [s]: cut to way_time.
  SpeedProfile(double way_time, double ramp);

  double duration() const { return way_time_ + ramp_; }  // [s]

  /// The part of the way done at `time` [s], 0 to 1.
  double at(double time) const;

  void archive(Archive& archive) {
    archive.value(way_time_);
    archive.value(ramp_);
  }

 private:
  double way_time_;
  double ramp_;
};

}  // namespace nao::motion
