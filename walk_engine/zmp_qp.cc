#include "walk_engine/zmp_qp.h"

#include <cmath>

#include "core/check.h"

namespace nao::walk {
namespace {

constexpr double kJerkWeight = 1e-6;  // [s^5] as in Kajita's preview control, per 10 ms of it
constexpr double kJerkTick = 0.01;    // [s]
constexpr double kMoveWeight = 30;    // of a landing's displacement; free, 10-100
constexpr double kCaptureWeight = 1;  // of the capture point at the end; free, 0.1-10

Eigen::Vector3d carried(const Eigen::Vector3d& c, double jerk, double dt) {
  return {c[0] + dt * (c[1] + dt * (c[2] / 2 + dt * jerk / 6)), c[1] + dt * (c[2] + dt * jerk / 2),
          c[2] + dt * jerk};
}

}  // namespace

ZmpQp::ZmpQp(double com_height, double gravity)
    : lag_(com_height / gravity), decay_(std::sqrt(com_height / gravity)) {}

ComState ZmpQp::carryOn(const ComState& com, const Eigen::Vector2d& jerk, double dt) {
  return {carried(com.x, jerk.x(), dt), carried(com.y, jerk.y(), dt)};
}

Eigen::Vector2d ZmpQp::calcZmp(const ComState& com) const {
  return {com.x[0] - lag_ * com.x[2], com.y[0] - lag_ * com.y[2]};
}

Eigen::Vector2d ZmpQp::calcCapturePoint(const ComState& com) const {
  return {com.x[0] + decay_ * com.x[1], com.y[0] + decay_ * com.y[1]};
}

// How the instants depend on state and jerks; made anew only when their distances change.
void ZmpQp::layOut(const std::vector<ZmpSample>& samples) {
  bool same = times_.size() == samples.size();
  for (std::size_t k = 0; same && k < samples.size(); ++k) same = times_[k] == samples[k].dt;
  if (same) return;
  instants_ = static_cast<int>(samples.size());
  times_.clear();
  zmp_state_.setZero(instants_, 3);
  zmp_jerk_.setZero(instants_, instants_);
  Eigen::Matrix3d state = Eigen::Matrix3d::Identity();
  Eigen::MatrixXd jerk = Eigen::MatrixXd::Zero(3, instants_);
  Eigen::VectorXd effort(instants_);
  const Eigen::RowVector3d zmp(1, 0, -lag_);
  for (int k = 0; k < instants_; ++k) {
    const double dt = samples[static_cast<std::size_t>(k)].dt;
    NAO_CHECK(dt > 0);
    Eigen::Matrix3d A;
    A << 1, dt, dt * dt / 2, 0, 1, dt, 0, 0, 1;
    state = A * state;
    jerk = (A * jerk).eval();
    jerk.col(k) += Eigen::Vector3d(dt * dt * dt / 6, dt * dt / 2, dt);
    zmp_state_.row(k) = zmp * state;
    zmp_jerk_.row(k) = zmp * jerk;
    effort[k] = kJerkWeight * dt / kJerkTick;
    times_.push_back(dt);
  }
  const Eigen::RowVector3d capture(1, decay_, 0);
  end_state_ = capture * state;
  end_jerk_ = capture * jerk;
  Eigen::VectorXd weights = Eigen::Map<Eigen::VectorXd>(times_.data(), instants_) / kJerkTick;
  hessian_ = zmp_jerk_.transpose() * weights.asDiagonal() * zmp_jerk_ +
             kCaptureWeight / kJerkTick * end_jerk_.transpose() * end_jerk_;
  hessian_.diagonal() += effort;
}

ZmpQp::Plan ZmpQp::solve(const ComState& com, const std::vector<ZmpSample>& samples,
                         const CaptureGoal& end, const std::vector<LandingRange>& landings) {
  NAO_CHECK(!samples.empty() && landings.size() <= kLandings);
  layOut(samples);
  const int variables = 2 * instants_ + 2 * static_cast<int>(landings.size());
  long rows = 4 * static_cast<long>(landings.size());
  for (const ZmpSample& sample : samples) rows += static_cast<long>(sample.support.size());
  rows += static_cast<long>(end.support.size());
  problem_.H.setZero(variables, variables);
  problem_.g.setZero(variables);
  problem_.A.setZero(rows, variables);
  problem_.b.setZero(rows);
  rows_ = 0;
  addCost(com, samples, end, landings);
  addLandings(landings);
  addEdges(com, samples, end);
  const QpSolution* solution = &solver_.solve(problem_);
  Plan plan;
  plan.feasible = solution->status == QpStatus::Solved;
  for (double slack = 0.01; solution->status != QpStatus::Solved && slack < 2; slack *= 3) {
    problem_.b.tail(rows - 4 * static_cast<long>(landings.size())).array() -= slack;
    solver_.forget();
    solution = &solver_.solve(problem_);
  }
  plan.iterations = solution->iterations;
  plan.jerk = Eigen::Vector2d(solution->x[0], solution->x[instants_]);
  for (std::size_t s = 0; s < kLandings; ++s) {
    plan.moved[s].setZero();
    if (s < landings.size()) plan.moved[s] = solution->x.segment<2>(rowOf(static_cast<int>(s), 0));
  }
  return plan;
}

void ZmpQp::addCost(const ComState& com, const std::vector<ZmpSample>& samples,
                    const CaptureGoal& end, const std::vector<LandingRange>& ranges) {
  const int n = instants_;
  const int landings = static_cast<int>(ranges.size());
  for (int s = 0; s < landings; ++s) {
    problem_.H.diagonal().segment<2>(rowOf(s, 0)).setConstant(kMoveWeight / kJerkTick);
    problem_.g.segment<2>(rowOf(s, 0)) =
        kMoveWeight / kJerkTick * ranges[static_cast<std::size_t>(s)].moved;
  }
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector3d& c = axis == 0 ? com.x : com.y;
    const int first = axis * n;
    problem_.H.block(first, first, n, n) = hessian_;
    const auto pull = [&](const Eigen::RowVectorXd& row, double error, int step, double share,
                          double weight) {
      problem_.g.segment(first, n) += weight * error * row.transpose();
      if (step < 0 || step >= landings || share == 0) return;
      const int d = rowOf(step, axis);
      problem_.g[d] -= weight * error * share;
      problem_.H(d, d) += weight * share * share;
      problem_.H.row(d).segment(first, n) -= weight * share * row;
      problem_.H.col(d).segment(first, n) -= weight * share * row.transpose();
    };
    for (int k = 0; k < n; ++k) {
      const ZmpSample& sample = samples[static_cast<std::size_t>(k)];
      pull(zmp_jerk_.row(k), zmp_state_.row(k).dot(c) - sample.reference[axis], sample.step,
           sample.share, sample.dt / kJerkTick);
    }
    pull(end_jerk_, end_state_.dot(c) - end.reference[axis], end.step, 1,
         kCaptureWeight / kJerkTick);
  }
}

void ZmpQp::addLandings(const std::vector<LandingRange>& landings) {
  for (std::size_t s = 0; s < landings.size(); ++s) {
    const LandingRange& range = landings[s];
    const Eigen::Vector2d left(-range.forward.y(), range.forward.x());
    const int d = rowOf(static_cast<int>(s), 0);
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d& way = axis == 0 ? range.forward : left;
      problem_.A.row(rows_).segment<2>(d) = way;
      problem_.b[rows_++] = range.low[axis];
      problem_.A.row(rows_).segment<2>(d) = -way;
      problem_.b[rows_++] = -range.high[axis];
    }
  }
}

void ZmpQp::addEdges(const ComState& com, const std::vector<ZmpSample>& samples,
                     const CaptureGoal& end) {
  for (int k = 0; k < instants_; ++k) {
    const Eigen::Vector2d free(zmp_state_.row(k).dot(com.x), zmp_state_.row(k).dot(com.y));
    for (const SupportEdge& edge : samples[static_cast<std::size_t>(k)].support) {
      addEdge(edge, free, zmp_jerk_.row(k));
    }
  }
  const Eigen::Vector2d free(end_state_.dot(com.x), end_state_.dot(com.y));
  for (const SupportEdge& edge : end.support) addEdge(edge, free, end_jerk_);
}

// A point that is at `free` without jerks stays inside of the edge.
void ZmpQp::addEdge(const SupportEdge& edge, const Eigen::Vector2d& free,
                    const Eigen::RowVectorXd& jerk) {
  auto row = problem_.A.row(rows_);
  row.head(instants_) = -edge.normal.x() * jerk;
  row.segment(instants_, instants_) = -edge.normal.y() * jerk;
  if (edge.step >= 0 && rowOf(edge.step, 1) < row.size()) {
    row.segment<2>(rowOf(edge.step, 0)) = edge.share * edge.normal;
  }
  problem_.b[rows_++] = edge.normal.dot(free) - edge.offset;
}

}  // namespace nao::walk
