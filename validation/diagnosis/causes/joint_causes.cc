// The catalogue of causes at the joint level. `starts` span what a Nao's or a hobby servo's joint
// shows at all (free choices: from a few times the size of interest to a gross fault); a fit moves
// on from there. `spread` is what two healthy robots of one kind differ by: mass 2 %, inertia 5 %,
// friction 10 %, gains 2 %, zero 0.1 degree at most, taken as uniform.
#include <algorithm>
#include <cmath>

#include "validation/diagnosis/causes/causes.h"

namespace nao::validation {
namespace {

const double kUniform = 1 / std::sqrt(3.0);  // SD of a number uniform within +-1

// A cause of one number.
Cause one(const std::string& effect, const std::string& parameter, std::vector<double> starts,
          const std::string& sentence, const std::string& separate) {
  Cause cause;
  cause.id = cause.effect = effect;
  cause.free = {{parameter, std::move(starts), Form::Offset, "", 0, 0, 0, 0}};
  cause.sentence = sentence;
  cause.separate = separate;
  return cause;
}

Cause part(const std::string& effect, const std::string& parameter, std::vector<double> starts,
           const std::string& sentence, const std::string& separate) {
  Cause cause = one(effect, parameter, std::move(starts), sentence, separate);
  cause.id = effect + "." + parameter;
  return cause;
}

Cause spread(Cause cause, double most) {
  cause.spread = most * kUniform;
  return cause;
}
Cause forAll(Cause cause) {
  cause.scope = Scope::Robot;
  return cause;
}
Cause byGrid(Cause cause) {
  cause.linear = false;
  return cause;
}
// A part, all of which is a law as good as any.
Cause wholly(Cause cause) {
  cause.whole = true;
  return cause;
}
// A stop: it does nothing until the motion reaches it, and a little further on it cuts off all. A
// joint that reads as much wrong is stopped at the same angle.
Cause reached(Cause cause, double inwards) {
  cause.linear = false;
  cause.stop = true;
  cause.twins = {"encoder_offset"};
  for (double moved = 0.02; moved < 3; moved *= 1.12) cause.scan.push_back(inwards * moved);
  return cause;
}
// A delay: the start of every run is free as well, so that bends alone tell it.
Cause late(Cause cause) {
  cause.linear = false;
  for (double delay = 0.002; delay < 0.08; delay *= 1.2) {
    cause.scan.push_back(delay);
    cause.scan.push_back(-delay);
  }
  return cause;
}

Cause shaped(Cause cause, const std::string& parameter, std::vector<double> starts) {
  cause.free.push_back({parameter, std::move(starts), Form::Offset, "", 0, 0, 0, 0});
  return cause;
}

void addFriction(std::vector<Cause>& all) {
  all.push_back(shaped(one("coulomb_friction", "torque", {0.1, 0.03, 0.3, -0.05},
                           "{joint} has {value} of dry friction more than the model",
                           "the same slow sweep with two loads and at two speeds"),
                       "creep", {0, 0.01}));
  all.push_back(one("viscous_friction", "coefficient", {0.05, 0.3, -0.05},
                    "{joint} is damped by {value} more than the model",
                    "a fall with the motor switched off"));
  all.push_back(byGrid(shaped(shaped(one("stribeck_friction", "torque", {0.1, 0.4},
                                         "{joint} sticks near standstill with {value}",
                                         "slow triangles with and without load"),
                                     "speed", {0, 0.3}),
                              "exponent", {0, -1})));
  all.push_back(shaped(one("load_friction", "share", {0.1, 0.3},
                           "{joint}'s friction grows by {value} of the torque its gear carries",
                           "the same sweep with a light and a heavy load"),
                       "of_motor", {0, 1}));
  all.push_back(shaped(one("friction_asymmetry", "torque", {0.1, -0.1, 0.4, -0.4},
                           "{joint} has {value} of friction in one direction only",
                           "rest after approaching a place from either side"),
                       "creep", {0, 0.01}));
  for (Cause& friction : all) friction.family = "friction";
  all.push_back(one("torque_bias", "torque", {0.1}, "a constant torque of {value} acts on {joint}",
                    "the same motion with the base turned by 90 degrees"));
}

void addMotor(std::vector<Cause>& all) {
  all.push_back(byGrid(one("torque_limit", "part", {-0.3, -0.6, 0.3, -0.8},
                           "{joint}'s motor gives {value} of its torque",
                           "a static load ramp up to where the joint gives in")));
  all.push_back(forAll(byGrid(part("voltage_sag", "drop", {0.2, 0.45, -0.2},
                                   "the battery of {joint}'s motor is {value} below nominal",
                                   "a fast sweep without load, and the battery's voltage"))));
  Cause sinking = part("voltage_sag", "slope", {0.03, 0.08, -0.03},
                       "the voltage at {joint} sinks by {value} of nominal",
                       "the same motion early and late in a long run");
  sinking.smallest_mean = 0.02;  // as of a drop
  all.push_back(forAll(byGrid(sinking)));
  Cause ripple = one("cogging", "torque", {0.2}, "{joint}'s torque ripples by {value} as it turns",
                     "slow motion over all of the range, one way and back");
  std::vector<double> per_turn;  // from 12, as the effect has it
  for (const double periods : {2, 4, 6, 8, 10, 12, 16, 20, 24}) per_turn.push_back(periods - 12);
  ripple.ripples = true;
  all.push_back(shaped(shaped(ripple, "per_turn", per_turn), "phase", {0, M_PI / 2}));
  all.push_back(byGrid(shaped(one("thermal_derating", "part", {0.5, 0.9},
                                  "{joint}'s motor loses {value} of its torque as it warms up",
                                  "the same motion cold and hot"),
                              "time", {0, -55})));
}

void addServo(std::vector<Cause>& all) {
  all.push_back(spread(one("kp_error", "part", {0.2, -0.3, 0.6},
                           "{joint}'s proportional gain is off by {value} of nominal",
                           "the same load at two stiffness gains, and the current"),
                       0.02));
  all.push_back(spread(one("kd_error", "part", {0.3, -0.4, 1.0},
                           "{joint}'s derivative gain is off by {value} of nominal",
                           "free oscillation after a step, and the current"),
                       0.02));
  all.push_back(one("integral_gain", "gain", {10, 40},
                    "{joint}'s servo integrates its error with {value}", "long holds under load"));
  all.push_back(byGrid(shaped(one("servo_deadband", "width", {0.01, 0.004, 0.025},
                                  "{joint}'s servo ignores errors up to {value}",
                                  "slow small triangles under a load of either sign"),
                              "ease", {0, 1})));
  all.push_back(wholly(byGrid(one("duty_root", "part", {0.5, 1.0},
                                  "{joint}'s duty grows by {value} with the root of the error",
                                  "the same load at two gains"))));
  all.push_back(spread(
      one("motor_inertia", "part", {0.5, -0.4}, "{joint}'s rotor is heavier by {value} of nominal",
          "fast sweeps with and without a known mass"),
      0.05));
}

void addGear(std::vector<Cause>& all) {
  all.push_back(byGrid(shaped(one("backlash", "width", {0.02, 0.007, 0.05, -0.008},
                                  "{joint}'s gear has {value} of play more than the model",
                                  "a slow triangle through zero load"),
                              "compliance", {0, 0.002})));
  all.push_back(byGrid(
      shaped(one("gear_compliance", "compliance", {0.004, 0.015, 0.06},
                 "{joint}'s gear twists by {value}", "a static load sweep seen from outside"),
             "damping", {0, -0.15})));
  all.push_back(one("cable_spring", "stiffness", {0.5, -0.3},
                    "a cable or skin pulls {joint} back with {value}",
                    "the same motion with the base turned by 90 degrees"));
  all.push_back(reached(
      part("joint_stop", "upper", {-0.1, -0.3, -0.6}, "{joint}'s upper stop is moved by {value}",
           "a slow approach to the stop from inside"),
      -1));
  all.push_back(reached(
      part("joint_stop", "lower", {0.1, 0.3, 0.6}, "{joint}'s lower stop is moved by {value}",
           "a slow approach to the stop from inside"),
      1));
  for (const char* end : {"upper", "lower"}) {
    all.push_back(
        byGrid(shaped(part("coupled_stop", end, {0.5, -0.5, 0.15, -0.15},
                           std::string("{joint}'s ") + end +
                               " stop moves inwards by {value} where the joint it hangs on is bent",
                           "hold this joint's command, sweep the other"),
                      "place", {0, -0.6, 0.6})));
    all.back().coupled = true;
    all.back().stop = true;
  }
}

void addLoad(std::vector<Cause>& all) {
  Cause offset = spread(one("encoder_offset", "angle", {0.01, 0.15, -0.15},
                            "{joint}'s encoder reads {value} too much",
                            "two orientations of the base, or an outer measurement"),
                        0.1 * M_PI / 180);
  for (double angle = 0.03; angle < 0.6; angle *= 1.1) {  // [rad] a gross one meets a stop at once
    offset.scan.push_back(angle);
    offset.scan.push_back(-angle);
  }
  offset.twins = {"ground_tilt.x", "ground_tilt.y", "joint_stop.upper", "joint_stop.lower"};
  all.push_back(offset);
  // Of a light link 0.2 hardly shows: what is tied to it may be many times as heavy.
  all.push_back(spread(shaped(one("link_mass", "part", {0.2, -0.2, 5},
                                  "the link on {joint} is heavier by {value} of nominal",
                                  "slow and fast motion with a known mass added"),
                              "inertia", {0, -1}),  // from 1, as of a link that is denser all over
                       0.02));
  all.back().spread_beyond = true;
  all.back().of_link = true;
  for (const char* axis : {"x", "y", "z"}) {
    // [m] Far off, a light link's mass turns as a larger inertia to either side.
    all.push_back(part("link_com", axis, {0.02, 0.1, -0.1},
                       "the link on {joint} has its mass off by {value}",
                       "slow motion in two orientations of the base"));
    all.back().of_link = true;
  }
  all.push_back(one("payload", "mass", {0.2, 1.0}, "{joint}'s link carries {value}",
                    "slow and fast motion, the load at two places"));
  all.back().of_link = true;
  all.push_back(forAll(one("gravity_scale", "scale", {0.2, -0.2},
                           "gravity acts on {joint} with {value} of nominal",
                           "slow and fast motion: mass has inertia")));
  all.back().one_for_all = true;
  for (const char* axis : {"x", "y"}) {
    all.push_back(forAll(part("ground_tilt", axis, {0.05}, "{joint}'s base is tilted by {value}",
                              "the same motion after the robot has turned by 90 degrees")));
    all.back().twins = {"encoder_offset"};
    all.back().one_for_all = true;
  }
}

void addTiming(std::vector<Cause>& all) {
  all.push_back(forAll(late(one("command_latency", "delay", {0.01, 0.03, -0.006},
                                "commands reach {joint} {value} later than the model says",
                                "the current as a third clock"))));
  all.push_back(forAll(late(one("sensor_delay", "delay", {0.01, 0.03, -0.005},
                                "{joint}'s angle is reported {value} later than the model says",
                                "the current as a third clock"))));
  Cause hold =
      byGrid(one("command_hold", "interval", {0.03, 0.015, 0.06, 0.1},
                 "{joint} takes new commands only every {value}", "a log at a higher rate"));
  hold.beats = true;
  all.push_back(forAll(hold));
  all.push_back(forAll(byGrid(one("command_filter", "time", {0.005, 0.015, 0.05},
                                  "{joint}'s command is smoothed over {value}",
                                  "steps and fast sweeps: a lag, not a delay"))));
  Cause rate =
      byGrid(shaped(one("rate_limit", "rate", {0.2, 0.7},
                        "{joint}'s command moves at most with {value}", "steps of two sizes"),
                    "ease", {0, 0.001}));
  rate.free[0].form = Form::Inverse;
  rate.free[0].smallest = 0.02;  // [s/rad] a limit of 50 rad/s, which no motor here follows
  // Nothing is to be seen of a limit that commands do not reach, and most things of a lower one.
  for (double x = 0.05; x < 2; x *= 1.15) rate.scan.push_back(x);
  all.push_back(forAll(rate));
  all.push_back(byGrid(one("encoder_quantum", "quantum", {0.02, 0.008},
                           "{joint}'s angle is read in steps of {value}",
                           "the smallest differences between samples")));
}

}  // namespace

const std::vector<Cause>& jointCauses() {
  static const std::vector<Cause> causes = [] {
    std::vector<Cause> all;
    addFriction(all);
    addMotor(all);
    addServo(all);
    addGear(all);
    addLoad(all);
    addTiming(all);
    const auto unknown = [](const Cause& cause) {
      return sim::standardEffects().find(cause.effect) == nullptr;
    };
    all.erase(std::remove_if(all.begin(), all.end(), unknown), all.end());
    return all;
  }();
  return causes;
}

const std::vector<Cause>& benchCauses() {
  static const std::vector<Cause> causes = [] {
    std::vector<Cause> all = jointCauses();
    for (Cause& cause : all) {
      for (const char* id : {"servo_deadband", "coulomb_friction", "load_friction",
                             "friction_asymmetry", "backlash", "gear_compliance"}) {
        if (cause.id == id) cause.free.resize(1);  // without repeats: no shape
      }
    }
    all.push_back(one("quadratic_load_friction", "coefficient", {0.3, 1, 2},
                      "{joint}'s friction grows by {value} with the square of its gear's torque",
                      "the same sweep with three loads"));
    all.push_back(shaped(one("directional_load_friction", "motoring", {0.1, 0.3},
                             "{joint}'s gear loses {value} of what it carries when it drives",
                             "lifting and lowering the same load"),
                         "braking", {0.05, 0.2}));
    return all;
  }();
  return causes;
}

}  // namespace nao::validation
