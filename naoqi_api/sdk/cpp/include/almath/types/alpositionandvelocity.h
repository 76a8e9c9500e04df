#pragma once

#include <vector>

#include <almath/types/alvectorspace.h>

namespace AL {
namespace Math {

/// A position q [rad or m] and how fast it changes, dq [1/s of it].
struct PositionAndVelocity : detail::VectorSpace<PositionAndVelocity, 2> {
  float q;
  float dq;

  PositionAndVelocity(float its_q = 0, float its_dq = 0) : q(its_q), dq(its_dq) {}

  static float PositionAndVelocity::*field(int i) {
    static float PositionAndVelocity::*const kFields[] = {&PositionAndVelocity::q,
                                                          &PositionAndVelocity::dq};
    return kFields[i];
  }
};

}  // namespace Math
}  // namespace AL
