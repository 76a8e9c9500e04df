#pragma once

namespace nao::sim {

/// How a world computes its steps.
enum class Mode {
  Implicit,   // linearly implicit Euler: fast, steady at 1 to 5 ms
  Rk4,        // Runge and Kutta's fourth order: for undamped truths, up to about 1.5 ms
  Reference,  // Simbody's error-controlled Runge-Kutta-Merson: what the others are held against
};

}  // namespace nao::sim
