#pragma once

#include <cstddef>

namespace nao::validation {

/// What makes a joint's excitation its own: frequencies, phases and orders of steps follow from
/// its number, spread so that no two joints share them.
struct Pace {
  std::size_t joint = 0;
  double half_range = 1;  // [rad] from the middle to the ends
  double max_speed = 1;   // [rad/s]
  double ramp_speed = 1;  // [rad/s] of ramps
  bool limited = false;   // its range depends on another joint

  /// Between `low` and `high`; `salt`, 0 to 31, tells the uses apart.
  double choose(double low, double high, std::size_t salt) const;
};

/// Where a joint is in its range `t` [s] into a motion: -1 and 1 are the ends, 0 the middle. Sines
/// are made smaller where the joint would exceed a part of its top speed.
double triangles(const Pace& pace, double t);
double tones(const Pace& pace, double t);
double reach(const Pace& pace, double t);
double stairs(const Pace& pace, double t);
double varied(const Pace& pace, double t);
double crossing(const Pace& pace, double t);
double quick(const Pace& pace, double t);

/// 1 within a motion of this length [s], from 0 and to 0 smoothly over 0.5 s at its ends.
double calcEnvelope(double t, double length);

}  // namespace nao::validation
