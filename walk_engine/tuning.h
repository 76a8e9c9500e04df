#pragma once

namespace nao::walk {

/// The numbers of the gait that ALMotion does not let a user choose. Those marked "free" were
/// chosen by walking the simulated nao_h21_v33 and nao_h25_v50 (tests/walk_engine).
struct Tuning {
  double double_support_share = 1.0 / 3;  // of a step's period; Aldebaran's
  double start_double_support = 0.6;      // [s] before the first foot lifts; Aldebaran's
  double end_double_support = 0.6;        // [s] after the last foot landed; Aldebaran's
  double zmp_lead = 0.03;                 // [s] the pressure is asked for early, as commands come
                                          // late; free, 0.02-0.03
  double support_margin = 0.01;           // [m] the pressure keeps inside of the soles; free
  double knee_bend = 0.1;         // hip lowered from straight, of the leg's length; free: from 0.09
                                  // on steps of 0.08 m with a turn are within reach
  double torso_pitch = 0.0;       // [rad] forward lean; free
  double zmp_x = 0.015;           // [m] target of the pressure ahead of the ankle; free, 0.01-0.02
  double zmp_y = -0.005;          // [m] the same, towards the outer edge; free, -0.01 to -0.004:
                                  // from 0 on some drawn joint zeros let the sway grow
  double swing_settle = 0.03;     // of the swing, straight down at its end; free, 0-0.2
  double swing_reaction = 0.004;  // [s^2] how far the swinging leg's acceleration drives the
                                  // pressure off, per m/s^2 of the sole: about leg mass times
                                  // lever over weight, 0.6 kg 0.27 m / 48 N; free, 0.003-0.005
  double arm_swing = 2.5;         // [rad/m] shoulder pitch by foot ahead of the other; free
  double roll_damping = 0.06;     // [s] ankle roll per roll rate of the torso; free, 0.02-0.06: up
                                  // to there a gyroscope 30 ms late still does no harm
  double pitch_damping = 0.035;   // [s] ankle pitch per pitch rate; free, 0.02-0.05
  double hip_follow = 0.02;   // [s] carrying hip's roll per roll rate of the torso, with the fall;
                              // free, 0.015-0.04: from 0.05 on it rocks the body
  double level_time = 0.3;    // [s] in which a foot learns that its sole is not level; 0: never;
                              // free, 0.25-0.4: without it a quarter of the seeded walks of
                              // 0.48 m end more than 3 degrees off
  double usual_lean = 0.035;  // [rad] out over the carrying foot in undisturbed steps; free
  double sway_gain = 0.3;     // [m/rad] the pressure goes inward for what is beyond; 0: never; free
  double sway_memory = 0.7;   // of it that the next step keeps; free
  double usual_sway = 0.018;  // [m] of the capture point in undisturbed steps; free
  double step_gain = 2;       // of what is beyond, answered by the next landing; 0: never; free
  double lift_speed = 0.09;  // [m/s] height by the time of the swing: a higher one takes longer, as
                             // a knee can not go faster; free, 0.07-0.1: from 0.12 on the foot
                             // is still in the air when the weight comes
  double swing_speed = 0.6;  // [m/s] mean of the swinging foot: a longer way takes longer, as
                             // the motors give less torque when fast; free
};

/// The same gait without an answer to what it senses.
inline Tuning openLoop(Tuning tuning) {
  tuning.roll_damping = tuning.pitch_damping = tuning.hip_follow = tuning.level_time = 0;
  tuning.sway_gain = tuning.step_gain = 0;
  return tuning;
}

}  // namespace nao::walk
