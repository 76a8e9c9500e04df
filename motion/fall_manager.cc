#include "motion/fall_manager.h"

#include <cmath>
#include <vector>

#include "motion/phases.h"
#include "motion/posture_family.h"
#include "motion/support_polygon.h"

namespace nao::motion {
namespace {

// Free choice: fast, as the ground is near, and without a jerk.
constexpr double kLimpTime = 0.1;  // [s]

// Free choices, by direction: arms to where the robot falls, head away from it, pelvis low so that
// there is less to fall. A right joint is its left one mirrored.
struct Row {
  const char* name;          // without its side
  bool mirrored;             // the right one has the other sign
  double front, back, side;  // [rad]
};
constexpr Row kRows[] = {
    {"HeadYaw", false, 0, 0, 0},
    {"HeadPitch", false, -0.3, 0.3, 0},
    {"ShoulderPitch", false, 0.6, 1.9, 1.4},
    {"ShoulderRoll", true, 0.3, 0.3, 0.4},
    {"ElbowYaw", true, -1.2, -1.2, -1.2},
    {"ElbowRoll", true, -1.0, -0.6, -0.9},
    {"HipYawPitch", false, 0, 0, 0},
    {"HipRoll", true, 0, 0, 0},
    {"HipPitch", false, -0.7, -0.9, -0.7},
    {"KneePitch", false, 1.4, 1.4, 1.4},
    {"AnklePitch", false, -0.7, -0.7, -0.7},
    {"AnkleRoll", true, 0, 0, 0},
};

double angleOf(const Row& row, const SensorFrame& measured) {
  if (std::abs(measured.angle_x) > std::abs(measured.angle_y)) return row.side;
  return measured.angle_y > 0 ? row.front : row.back;
}

}  // namespace

bool FallManager::update(const SensorFrame& measured, bool grounded, double dt) {
  detector_.update(measured, dt);
  if (!falling() && !fallen()) found_ = false;
  if (!enabled_ || found_ || !falling() || !grounded || !overbalances(measured)) return false;
  found_ = true;
  return true;
}

// Whether the centre of mass is beside the hull of the soles, seen along the vertical. A robot
// whose soles nobody knows has it beside them as soon as it is tilted far enough.
bool FallManager::overbalances(const SensorFrame& measured) {
  kinematics_.update(measured.angle);
  const Vec3 up = upInTorso(measured);
  const Eigen::Quaterniond R_HT = Eigen::Quaterniond::FromTwoVectors(up, Vec3::UnitZ());
  std::vector<Eigen::Vector2d> corners;
  for (const FootModel& foot : kinematics_.model().feet) {
    if (foot.outline.empty()) return true;
    const Pose X_TS = kinematics_.getPose(foot.body) * foot.X_BS;
    for (const Eigen::Vector2d& corner : foot.outline) {
      corners.push_back((R_HT * (X_TS * Vec3(corner.x(), corner.y(), 0))).head<2>());
    }
  }
  const Eigen::Vector2d com = (R_HT * kinematics_.calcCom()).head<2>();
  return depthIn(calcHull(corners), com) < 0;
}

void FallManager::archive(Archive& archive) {
  detector_.archive(archive);
  archive.value(enabled_);
  archive.value(found_);
}

std::unique_ptr<Phase> protectivePose(const RobotModel& model, const SensorFrame& measured) {
  Glide::Course course;
  course.target = JointArray<double>(model.jointCount());
  course.ramp = 0.04;  // free choice: the motors' own spin-up
  for (const Row& row : kRows) {
    for (const char* side : {"", "L", "R"}) {
      const auto joint = model.findJoint(std::string(side) + row.name);
      if (!joint) continue;
      const double sign = *side == 'R' && row.mirrored ? -1 : 1;
      course.joints.set(index(*joint));
      course.target[*joint] = sign * angleOf(row, measured);
    }
  }
  std::vector<ValuePtr<Phase>> phases;
  phases.emplace_back(std::make_unique<Glide>(course));
  phases.emplace_back(std::make_unique<RampStiffness>(0.0, kLimpTime));
  return std::make_unique<Sequence>(std::move(phases));
}

}  // namespace nao::motion
