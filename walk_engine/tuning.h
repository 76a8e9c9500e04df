#pragma once

namespace nao::walk {

/// The numbers of the gait that ALMotion does not let a user choose. Those marked "free" were
/// chosen by walking the simulated nao_h21_v33 and nao_h25_v50 (tests/walk_engine).
struct Tuning {
  double double_support_share = 0.25;  // of a step's period; Aldebaran publishes 1/3; free
  double start_double_support = 0.6;   // [s] before the first foot lifts; Aldebaran's
  double end_double_support = 0.6;     // [s] after the last foot landed; Aldebaran's
  double preview = 1.2;                // [s] Aldebaran's 0.8 at least
  double knee_bend = 0.06;             // of the leg's length, hip lowered from straight; free
  double torso_pitch = 0.0;            // [rad] forward lean; free
  double zmp_x = 0.015;                // [m] target point of the pressure in the sole; free
  double zmp_y = 0.0;                  // [m] the same, towards the outer edge; free
  double swing_lead = 0.08;            // of the swing, straight up at its start; free
  double swing_settle = 0.12;          // of the swing, straight down at its end; free
  double arm_swing = 2.5;              // [rad/m] shoulder pitch by foot ahead of the other; free
  double swing_ease = 1;               // 0 cosine to 1 minimum jerk; free
  double swing_reaction = 0;           // [s^2] shift of the pressure by the foot's acceleration
  double lead_speed = 1;
  double lead_torque = 1;
  double servo_lead = 1;  // 1 with ServoLead, 0 without
};

}  // namespace nao::walk
