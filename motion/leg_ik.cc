#include "motion/leg_ik.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/check.h"

namespace nao::motion {
namespace {

constexpr double kSame = 1e-9;  // [m] axes closer than this meet; also for directions

Mat3 turn(double angle, const Vec3& axis) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}
Mat3 turnX(double angle) { return turn(angle, Vec3::UnitX()); }
Mat3 turnY(double angle) { return turn(angle, Vec3::UnitY()); }

// Angle in the x-z plane, positive about y, from straight down (0, 0, -1).
double angleFromDown(double x, double z) { return std::atan2(-x, -z); }

// The knee's bend when hip and ankle are `distance` apart; stretched or folded where it can not be.
double calcKnee(const Vec3& thigh, const Vec3& tibia, double distance, bool& reached) {
  const double a = thigh.norm();
  const double b = tibia.norm();
  const double cosine = (distance * distance - a * a - b * b) / (2 * a * b);
  if (cosine > 1 + kSame || cosine < -1 - kSame) reached = false;
  const double bend = std::acos(std::clamp(cosine, -1.0, 1.0));  // 0 stretched
  return bend + angleFromDown(thigh.x(), thigh.z()) - angleFromDown(tibia.x(), tibia.z());
}

bool within(double value, double lower, double upper) {
  return value >= lower - kSame && value <= upper + kSame;
}

}  // namespace

bool LegIk::fits(const RobotModel& model) {
  Leg leg;
  return model.feet.size() == 2 && findLeg(model, model.feet[0], leg) &&
         findLeg(model, model.feet[1], leg);
}

LegIk::LegIk(std::shared_ptr<const RobotModel> model) : model_(std::move(model)) {
  if (model_->feet.size() != 2 || !findLeg(*model_, model_->feet[0], legs_[0]) ||
      !findLeg(*model_, model_->feet[1], legs_[1])) {
    throw InputError(model_->name +
                     ": legs are not a Nao's (hip yaw-pitch, roll and pitch through "
                     "one point, knee, ankle pitch and roll through one point)");
  }
}

// Walks up from the foot: six hinges to the root, of the kinds the formulas below stand on.
bool LegIk::findLeg(const RobotModel& model, const FootModel& foot, Leg& leg) {
  const std::array<Vec3, 6> axes = {Vec3::Zero(),  Vec3::UnitX(), Vec3::UnitY(),
                                    Vec3::UnitY(), Vec3::UnitY(), Vec3::UnitX()};
  std::array<Vec3, 6> offset;
  int body = foot.body;
  for (std::size_t i = 6; i-- > 0;) {
    if (body <= 0) return false;
    const Body& link = model.bodies[static_cast<std::size_t>(body)];
    const Joint joint = model.coordinates[static_cast<std::size_t>(body) - 1].joint;
    if (!link.X_PB.linear().isIdentity(kSame)) return false;
    if (i > 0 && !link.axis.isApprox(axes[i], kSame)) return false;
    leg.joint[i] = joint;
    leg.lower[i] = model.actuators[index(joint)].lower;
    leg.upper[i] = model.actuators[index(joint)].upper;
    leg.axis = link.axis;
    offset[i] = link.X_PB.translation();
    body = link.parent;
  }
  leg.p_THip = offset[0];
  leg.thigh = offset[3];
  leg.tibia = offset[4];
  leg.X_SA = foot.X_BS.inverse();
  const bool yaw_pitch = std::abs(leg.axis.x()) < kSame && std::abs(leg.axis.z()) > 0.1;
  const bool meet =
      offset[1].norm() < kSame && offset[2].norm() < kSame && offset[5].norm() < kSame;
  const bool planar = std::abs(leg.thigh.y()) < kSame && std::abs(leg.tibia.y()) < kSame;
  return body == 0 && yaw_pitch && meet && planar && leg.thigh.z() < 0 && leg.tibia.z() < 0;
}

// Seen from the ankle, the hip's direction gives the ankle roll, the distance the knee, and then
// the ankle pitch; what rotation is left belongs to the hip: R = R(yaw) Rx(roll) Ry(pitch).
double LegIk::calcYawDemand(const Leg& leg, const Pose& X_TA) {
  const Vec3 p_AH = X_TA.inverse() * leg.p_THip;
  const double ankle_roll = std::atan2(p_AH.y(), p_AH.z());
  const double height = std::hypot(p_AH.y(), p_AH.z());
  bool reached = true;
  const double knee = calcKnee(leg.thigh, leg.tibia, p_AH.norm(), reached);
  const Vec3 p_KH = -(leg.tibia + turnY(-knee) * leg.thigh);  // hip from the ankle, in the tibia
  const double ankle_pitch =
      angleFromDown(-p_KH.x(), -p_KH.z()) - angleFromDown(-p_AH.x(), -height);
  const Mat3 R_hip = X_TA.linear() * turnX(-ankle_roll) * turnY(-ankle_pitch - knee);
  // With Q turning z onto the axis, Q^T R = Rz(yaw) Rx(roll - tilt) Ry(pitch): Euler angles z-x-y.
  const double sign = leg.axis.z() < 0 ? -1 : 1;
  const double tilt = std::atan2(-sign * leg.axis.y(), sign * leg.axis.z());
  const Mat3 R = turnX(-tilt) * R_hip;
  return sign * std::atan2(-R(0, 1), R(1, 1));
}

bool LegIk::solveLeg(const Leg& leg, const Pose& X_TA, double yaw, std::array<double, 6>& q) {
  bool reached = true;
  // The hip's roll and pitch and the knee bring the ankle to its place.
  q[0] = std::clamp(yaw, leg.lower[0], leg.upper[0]);
  const Mat3 R_yaw = turn(q[0], leg.axis);
  const Vec3 p = R_yaw.transpose() * (X_TA.translation() - leg.p_THip);
  q[1] = std::atan2(p.y(), -p.z());
  q[3] = calcKnee(leg.thigh, leg.tibia, p.norm(), reached);
  const Vec3 stretched = leg.thigh + turnY(q[3]) * leg.tibia;  // hip to ankle, in the thigh
  q[2] =
      angleFromDown(p.x(), -std::hypot(p.y(), p.z())) - angleFromDown(stretched.x(), stretched.z());
  for (std::size_t i = 0; i < 4; ++i) {
    if (!within(q[i], leg.lower[i], leg.upper[i])) reached = false;
    q[i] = std::clamp(q[i], leg.lower[i], leg.upper[i]);
  }
  // The ankle's pitch and roll lay the sole along its normal: n = Ry(q4) Rx(q5) z.
  const Mat3 R_TTibia = R_yaw * turnX(q[1]) * turnY(q[2] + q[3]);
  const Vec3 n = R_TTibia.transpose() * X_TA.linear().col(2);
  q[5] = std::asin(std::clamp(-n.y(), -1.0, 1.0));
  q[4] = std::atan2(n.x(), n.z());
  for (std::size_t i = 4; i < 6; ++i) {
    if (!within(q[i], leg.lower[i], leg.upper[i])) reached = false;
    q[i] = std::clamp(q[i], leg.lower[i], leg.upper[i]);
  }
  return reached;
}

LegSolution LegIk::solve(const Pose& X_TLs, const Pose& X_TRs, double left_share) const {
  const std::array<Pose, 2> X_TA = {X_TLs * legs_[0].X_SA, X_TRs * legs_[1].X_SA};
  LegSolution found;
  for (std::size_t i = 0; i < 2; ++i) found.yaw_demand[i] = calcYawDemand(legs_[i], X_TA[i]);
  const double yaw = left_share * found.yaw_demand[0] + (1 - left_share) * found.yaw_demand[1];
  for (std::size_t i = 0; i < 2; ++i) {
    found.reachable[i] = solveLeg(legs_[i], X_TA[i], yaw, found.angle[i]);
  }
  return found;
}

double LegIk::calcEqualYaw(const Pose& X_WT, const Pose& X_WLs, const Pose& X_WRs) const {
  const auto difference = [&](double angle) {
    Pose X_WTurned = X_WT;
    X_WTurned.linear() = turn(angle, Vec3::UnitZ()) * X_WT.linear();
    const Pose X_TW = X_WTurned.inverse();
    return calcYawDemand(legs_[0], X_TW * X_WLs * legs_[0].X_SA) -
           calcYawDemand(legs_[1], X_TW * X_WRs * legs_[1].X_SA);
  };
  // Secant: the difference is nearly linear in the angle, with a slope of about 2.8.
  double a = 0;
  double at_a = difference(a);
  double b = -at_a / 2.8;
  for (int i = 0; i < 12; ++i) {
    const double at_b = difference(b);
    if (std::abs(at_b) < 1e-13 || at_b == at_a) break;
    const double next = b - at_b * (b - a) / (at_b - at_a);
    a = b;
    at_a = at_b;
    b = next;
  }
  return std::abs(b) < M_PI / 3 ? b : 0;
}

void LegIk::apply(const LegSolution& solution, JointArray<double>& angle) const {
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 6; ++k) angle[legs_[i].joint[k]] = solution.angle[i][k];
  }
}

}  // namespace nao::motion
