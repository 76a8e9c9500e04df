#include "motion/body_solver.h"

#include <algorithm>
#include <cmath>

namespace nao::motion {
namespace {

constexpr double kDamping = 1e-6;    // [m^2] bends paths near singular poses only
constexpr double kHeld = 1e6;        // weight of an exact task where the equality can not be met
constexpr double kFarthest = 0.05;   // [m] longest error that is linear enough for one step
constexpr double kSlopeStep = 1e-3;  // [rad] far below the distance of a table's rows
constexpr double kRecovery = 0.1;    // [m/s] free: a centre of mass outside comes in at this speed

// The rotation vector of `rotation`.
Vec3 turnOf(const Mat3& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

double metric(const PlaceTask& task, int axis) { return axis < 3 ? 1 : task.radian; }

}  // namespace

BodySolver::BodySolver(std::shared_ptr<const RobotModel> model)
    : model_(std::move(model)), body_(model_), column_of_(model_->jointCount(), -1) {}

BodySolver::Twist BodySolver::calcTwist(int body) const {
  Twist twist = Twist::Zero(6, static_cast<long>(columns_.size()));
  for (int b = body; b > 0; b = model_->bodies[static_cast<std::size_t>(b)].parent) {
    const auto i = static_cast<std::size_t>(b);
    const int column = column_of_[index(model_->coordinates[i - 1].joint)];
    if (column < 0) continue;
    const Pose& X_TB = body_.getPose(b);
    const Vec3 axis = X_TB.linear() * model_->bodies[i].axis;
    twist.col(column).head<3>() += X_TB.translation().cross(axis);
    twist.col(column).tail<3>() += axis;
  }
  return twist;
}

BodySolver::Twist BodySolver::calcTwist(const PlaceTask& task) const {
  Twist twist = calcTwist(task.place.body) - calcTwist(task.base.body);
  const Mat3 R_BT = body_.calcPose(task.base).linear().transpose();
  const Vec3 p = body_.calcPose(task.place).translation();
  for (long i = 0; i < twist.cols(); ++i) {
    const Vec3 turn = twist.col(i).tail<3>();
    const Vec3 speed = twist.col(i).head<3>() + turn.cross(p);
    twist.col(i).head<3>() = R_BT * speed;
    twist.col(i).tail<3>() = R_BT * turn;
  }
  return twist;
}

BodySolver::Vec6 BodySolver::calcError(const PlaceTask& task) const {
  const Pose X_BF = body_.calcPose(task.base).inverse() * body_.calcPose(task.place);
  Vec6 error;
  error.head<3>() = task.X_BF.translation() - X_BF.translation();
  error.tail<3>() = turnOf(task.X_BF.linear() * X_BF.linear().transpose());
  for (int axis = 0; axis < 6; ++axis) {
    if (!(task.mask >> axis & 1)) error[axis] = 0;
  }
  return error;
}

double BodySolver::calcError(const Demand& demand, const JointArray<double>& angle) {
  body_.update(angle);
  double largest = 0;
  for (const PlaceTask& task : demand.places) {
    Vec6 error = calcError(task);
    error.tail<3>() *= task.radian;
    largest = std::max(largest, error.norm());
  }
  return largest;
}

Eigen::Matrix2Xd BodySolver::calcComJacobian(const ComTask& com, Eigen::Vector2d& place) const {
  const Pose X_FT = body_.calcPose(com.floor).inverse();
  const Vec3 c = body_.calcCom();
  place = (X_FT * c).head<2>();
  Eigen::Matrix3Xd speed = Eigen::Matrix3Xd::Zero(3, static_cast<long>(columns_.size()));
  double total = 0;
  for (std::size_t b = 0; b < model_->bodies.size(); ++b) {
    const Body& body = model_->bodies[b];
    total += body.mass;
    if (b == 0 || body.mass == 0) continue;
    const Twist twist = calcTwist(static_cast<int>(b));
    const Vec3 p = body_.getPose(static_cast<int>(b)) * body.p_BoBcm;
    for (long i = 0; i < twist.cols(); ++i) {
      const Vec3 turn = twist.col(i).tail<3>();
      speed.col(i) += body.mass * (twist.col(i).head<3>() + turn.cross(p));
    }
  }
  speed /= total;
  const Twist floor = calcTwist(com.floor.body);
  for (long i = 0; i < floor.cols(); ++i) {
    const Vec3 turn = floor.col(i).tail<3>();
    speed.col(i) -= floor.col(i).head<3>() + turn.cross(c);
  }
  return (X_FT.linear() * speed).topRows<2>();
}

void BodySolver::addRow(const Eigen::RowVectorXd& row, double bound) {
  rows_.push_back(row);
  bounds_.push_back(bound);
}

void BodySolver::addPlace(const PlaceTask& task, bool exact) {
  const Twist J = calcTwist(task);
  Vec6 error = calcError(task);
  Vec6 scaled = error;
  scaled.tail<3>() *= task.radian;
  if (!task.exact) error *= std::min(1.0, kFarthest / std::max(scaled.norm(), 1e-12));
  for (int axis = 0; axis < 6; ++axis) {
    if (!(task.mask >> axis & 1)) continue;
    if (task.exact && exact) {
      addRow(metric(task, axis) * J.row(axis), metric(task, axis) * error[axis]);
      continue;
    }
    const double weight =
        (task.exact ? kHeld : task.weight) * metric(task, axis) * metric(task, axis);
    problem_.H += weight * J.row(axis).transpose() * J.row(axis);
    problem_.g -= weight * error[axis] * J.row(axis).transpose();
  }
}

void BodySolver::addCom(const Demand& demand, bool recover) {
  Eigen::Vector2d place;
  const Eigen::Matrix2Xd J = calcComJacobian(*demand.com, place);
  if (demand.com->target) {
    const Eigen::Vector2d error = *demand.com->target - place;
    problem_.H += J.transpose() * J;
    problem_.g -= J.transpose() * error;
  }
  const auto& corners = demand.com->inside;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d edge = corners[(i + 1) % corners.size()] - corners[i];
    const Eigen::Vector2d inwards = Eigen::Vector2d(-edge.y(), edge.x()).normalized();
    const double depth = inwards.dot(place - corners[i]);
    const double wanted =
        depth < 0 ? (recover ? std::min(0.0, depth + kRecovery * demand.dt) : depth) : 0;
    addRow(inwards.transpose() * J, wanted - depth);
  }
}

void BodySolver::addRanges(const JointArray<double>& angle) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Actuator& motor = model_->actuators[columns_[i]];
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(static_cast<long>(columns_.size()));
    row[static_cast<long>(i)] = 1;
    addRow(row, std::min(0.0, motor.lower - angle[columns_[i]]));
    addRow(-row, std::min(0.0, angle[columns_[i]] - motor.upper));
  }
  for (const CoupledLimit& limit : model_->coupled_limits) addCoupled(limit, angle);
}

// A range that another joint's angle gives, along its slope there.
void BodySolver::addCoupled(const CoupledLimit& limit, const JointArray<double>& angle) {
  const int limited = column_of_[index(limit.limited)];
  if (limited < 0) return;
  const auto [low, high] = limit.rangeAt(angle[limit.driver]);
  Eigen::RowVectorXd above = Eigen::RowVectorXd::Zero(static_cast<long>(columns_.size()));
  above[limited] = 1;
  Eigen::RowVectorXd below = -above;
  const int driver = column_of_[index(limit.driver)];
  if (driver >= 0) {
    const auto before = limit.rangeAt(angle[limit.driver] - kSlopeStep);
    const auto behind = limit.rangeAt(angle[limit.driver] + kSlopeStep);
    above[driver] = -(behind.first - before.first) / (2 * kSlopeStep);
    below[driver] = (behind.second - before.second) / (2 * kSlopeStep);
  }
  addRow(above, std::min(0.0, low - angle[limit.limited]));
  addRow(below, std::min(0.0, angle[limit.limited] - high));
}

void BodySolver::finishRows(int equalities) {
  problem_.equalities = equalities;
  problem_.A.resize(static_cast<long>(rows_.size()), static_cast<long>(columns_.size()));
  problem_.b.resize(static_cast<long>(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    problem_.A.row(static_cast<long>(i)) = rows_[i];
    problem_.b[static_cast<long>(i)] = bounds_[i];
  }
}

void BodySolver::build(const Demand& demand, const JointArray<double>& angle, bool exact) {
  const auto size = static_cast<long>(columns_.size());
  problem_.H = kDamping * Eigen::MatrixXd::Identity(size, size);
  problem_.g = Eigen::VectorXd::Zero(size);
  rows_.clear();
  bounds_.clear();
  for (std::size_t i = 0; i < columns_.size() && demand.wish.size() > 0; ++i) {
    const double weight = demand.wish_weight[columns_[i]];
    const auto column = static_cast<long>(i);
    problem_.H(column, column) += weight;
    problem_.g[column] -= weight * (demand.wish[columns_[i]] - angle[columns_[i]]);
  }
  for (const PlaceTask& task : demand.places) addPlace(task, exact);
  const int equalities = static_cast<int>(rows_.size());
  if (demand.com) addCom(demand, exact);
  addRanges(angle);
  finishRows(equalities);
}

// Takes back what the step, straight in the joints, missed of the exact tasks, which are curved.
void BodySolver::correct(const Demand& demand, JointArray<double>& angle) {
  constexpr double kSmall = 1e-3;   // [m] more is no curvature
  constexpr double kSteady = 1e-9;  // keeps a stretched leg from being asked for the impossible
  body_.update(angle);
  for (const PlaceTask& task : demand.places) {
    if (!task.exact) continue;
    const Vec6 error = calcError(task);
    if (error.norm() > kSmall) continue;
    Twist J = calcTwist(task);
    for (int axis = 0; axis < 6; ++axis) {
      if (!(task.mask >> axis & 1)) J.row(axis).setZero();
    }
    const Eigen::Matrix<double, 6, 6> square =
        J * J.transpose() + kSteady * Eigen::Matrix<double, 6, 6>::Identity();
    const Eigen::VectorXd step = J.transpose() * square.ldlt().solve(error);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Actuator& motor = model_->actuators[columns_[i]];
      double& q = angle[columns_[i]];
      const double moved = q + step[static_cast<long>(i)];
      if (moved > motor.lower && moved < motor.upper) q = moved;
    }
  }
}

void BodySolver::step(const Demand& demand, JointArray<double>& angle) {
  body_.update(angle);
  columns_.clear();
  for (std::size_t i = 0; i < model_->jointCount(); ++i) {
    const bool moves = demand.joints.test(i) && !model_->actuators[i].coordinates.empty();
    column_of_[i] = moves ? static_cast<int>(columns_.size()) : -1;
    if (moves) columns_.push_back(i);
  }
  if (columns_.empty()) return;
  build(demand, angle, true);
  solver_.forget();
  const QpSolution* solution = &solver_.solve(problem_);
  if (solution->status != QpStatus::Solved) {
    build(demand, angle, false);
    solver_.forget();
    solution = &solver_.solve(problem_);
    if (solution->status != QpStatus::Solved) return;
  }
  double scale = 1;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double most = demand.fraction * model_->actuators[columns_[i]].max_velocity * demand.dt;
    const double way = std::abs(solution->x[static_cast<long>(i)]);
    if (way > most) scale = std::min(scale, most / way);
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    angle[columns_[i]] += scale * solution->x[static_cast<long>(i)];
  }
  correct(demand, angle);
}

}  // namespace nao::motion
