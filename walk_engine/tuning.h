#pragma once

namespace nao::walk {

/// The numbers of the gait that ALMotion does not let a user choose. Those marked "free" were
/// chosen by walking the simulated nao_h21_v33 and nao_h25_v50 (tests/walk_engine).
struct Tuning {
  double double_support_share = 1.0 / 3;  // of a step's period; Aldebaran's
  double start_double_support = 0.6;      // [s] before the first foot lifts; Aldebaran's
  double end_double_support = 0.6;        // [s] after the last foot landed; Aldebaran's
  double preview = 1.2;                   // [s] Aldebaran's 0.8 at least; 0.8 walks as well
  double knee_bend = 0.08;        // hip lowered from straight, of the leg's length; free, 0.06-0.12
  double torso_pitch = 0.0;       // [rad] forward lean; free
  double zmp_x = 0.012;           // [m] target of the pressure ahead of the ankle; free, 0.01-0.02
  double zmp_y = -0.005;          // [m] the same, towards the outer edge; free
  double swing_settle = 0.03;     // of the swing, straight down at its end; free, 0-0.2
  double swing_reaction = 0.004;  // [s^2] how far the swinging leg's acceleration drives the
                                  // pressure off, per m/s^2 of the sole: about leg mass times
                                  // lever over weight (0.6 kg 0.27 m / 48 N = 0.0034 s^2), and
                                  // what the servos give way; free, 0.004-0.009
  double arm_swing = 2.5;         // [rad/m] shoulder pitch by foot ahead of the other; free
};

}  // namespace nao::walk
