#include "walk_engine/stance.h"

#include "walk_engine/step_rules.h"

namespace nao::walk {
namespace {

// The centre of mass moves by about 0.8 of what the torso moves: each iteration takes the error
// to a fifth, four from the last cycle's solution leave less than a micrometre.
constexpr int kIterations = 4;

}  // namespace

StanceSolver::StanceSolver(std::shared_ptr<const RobotModel> model)
    : ik_(model), kinematics_(model) {
  torso_to_sole_ = -kinematics_.calcSole(Foot::Left).translation().z();
  p_TCom_ = kinematics_.calcCom();
}

bool StanceSolver::solve(const StanceDemand& demand, JointArray<double>& angle) {
  Pose& X_OT = X_OT_;
  motion::LegSolution legs;
  for (int i = 0; i < kIterations; ++i) {
    X_OT.linear() = rotationFromRpy(demand.roll, demand.pitch, yaw_);
    X_OT.translation() = demand.com - X_OT.linear() * p_TCom_;
    const double turn = ik_.calcEqualYaw(X_OT, demand.X_OS[0], demand.X_OS[1]);
    yaw_ += turn;
    X_OT.linear() = rotationFromRpy(demand.roll, demand.pitch, yaw_);
    const Pose X_TO = X_OT.inverse();
    legs = ik_.solve(X_TO * demand.X_OS[0], X_TO * demand.X_OS[1]);
    ik_.apply(legs, angle);
    kinematics_.update(angle);
    p_TCom_ = kinematics_.calcCom();
  }
  return legs.withinReach();
}

double StanceSolver::calcComHeight(double knee_bend, double pitch, JointArray<double> angle) {
  Pose X_OT = translation(Vec3(0, 0, torso_to_sole_ - knee_bend * ik_.legLength()));
  X_OT.linear() = rotationFromRpy(0, pitch, 0);
  const Pose left = translation(Vec3(0, kFootSeparation / 2, 0));
  const Pose right = translation(Vec3(0, -kFootSeparation / 2, 0));
  ik_.apply(ik_.solve(X_OT.inverse() * left, X_OT.inverse() * right), angle);
  kinematics_.update(angle);
  return (X_OT * kinematics_.calcCom()).z();
}

std::array<Pose, 2> StanceSolver::calcSoles(const JointArray<double>& angle) {
  kinematics_.update(angle);
  const Pose X_RT = kinematics_.calcRobotFrame().inverse();
  return {X_RT * kinematics_.calcSole(Foot::Left), X_RT * kinematics_.calcSole(Foot::Right)};
}

void StanceSolver::archive(Archive& archive) {
  archive.numbers(X_OT_.matrix());
  archive.value(yaw_);
  archive.numbers(p_TCom_);
}

}  // namespace nao::walk
