#include "validation/log/floor_motions.h"

#include <cmath>

#include "core/check.h"
#include "validation/log/excitation.h"

namespace nao::validation {
namespace {

constexpr double kPi = 3.14159265358979323846;
// Free choices, tried on the simulated robots: half of what makes one of them lift a sole.
constexpr double kSquat = 0.15;  // [rad] of hip and ankle; the knee bends twice that
constexpr double kSway = 0.07;   // [rad] of hips and ankles, opposite to each other
constexpr double kArms = 0.4;    // [rad]

// How far, 0 to 1, into a squat; -1 to 1 from foot to foot; -1 to 1 of the arms.
struct Sway {
  double squat = 0, side = 0, arms = 0;
};

double wave(double frequency, double t) { return std::sin(2 * kPi * frequency * t); }
double dip(double frequency, double t) { return 0.5 - 0.5 * std::cos(2 * kPi * frequency * t); }

Sway calcSway(const std::string& name, double t) {
  if (name == "squat") return {dip(0.25, t), 0, 0};
  if (name == "sway") return {0, wave(0.25, t), 0};
  if (name == "arms") return {0, 0, wave(0.5, t)};
  if (name == "squat_fast") return {std::min(1.0, 1.5 * dip(0.5, t)), 0, 0};
  return {dip(0.4, t), 0.7 * wave(0.25, t), wave(0.3, t)};
}

void add(const RobotModel& model, JointArray<double>& angle, const char* name, double by) {
  const auto joint = model.findJoint(name);
  if (joint) angle[*joint] += by;
}

}  // namespace

const std::vector<FloorMotion>& standingMotions() {
  static const std::vector<FloorMotion> kMotions{{"squat", Split::Fit, 8, {}},
                                                 {"sway", Split::Fit, 8, {}},
                                                 {"arms", Split::Fit, 8, {}},
                                                 {"squat_fast", Split::Select, 8, {}},
                                                 {"mixed", Split::Test, 8, {}}};
  return kMotions;
}

const std::vector<FloorMotion>& walkingMotions() {
  static const std::vector<FloorMotion> kMotions{
      {"walk_forward", Split::Fit, 12, Pose2{0.5, 0, 0}},
      {"walk_aside", Split::Fit, 12, Pose2{0, 0.2, 0}},
      {"turn_left", Split::Fit, 12, Pose2{0, 0, kPi / 2}},
      {"walk_curve", Split::Select, 12, Pose2{0.4, 0.1, 0.5}},
      {"turn_right", Split::Test, 12, Pose2{0, 0, -kPi / 2}},
      {"walk_diagonal", Split::Test, 12, Pose2{0.3, -0.1, 0}}};
  return kMotions;
}

JointArray<double> calcFloorAngles(const RobotModel& model, const FloorMotion& motion, double t) {
  const Posture* stand = model.findPosture("StandInit");
  if (!stand) throw InputError(model.name + ": expected a posture StandInit, found none");
  JointArray<double> angle = stand->angle;
  const double envelope = calcEnvelope(t, motion.duration);
  if (motion.walk || envelope <= 0) return angle;
  const Sway sway = calcSway(motion.name, t);
  for (const std::string side : {"L", "R"}) {
    const double squat = envelope * kSquat * sway.squat, lean = envelope * kSway * sway.side;
    add(model, angle, (side + "HipPitch").c_str(), -squat);
    add(model, angle, (side + "KneePitch").c_str(), 2 * squat);
    add(model, angle, (side + "AnklePitch").c_str(), -squat);
    add(model, angle, (side + "HipRoll").c_str(), lean);
    add(model, angle, (side + "AnkleRoll").c_str(), -lean);
    const double swing = envelope * kArms * sway.arms * (side == "L" ? 1 : -1);
    add(model, angle, (side + "ShoulderPitch").c_str(), swing);
  }
  return angle;
}

}  // namespace nao::validation
