#pragma once

#include <array>
#include <memory>
#include <vector>

#include "motion/body_solver.h"
#include "motion/cartesian.h"
#include "motion/phase.h"
#include "motion/support_polygon.h"
#include "motion/whole_body_request.h"

namespace nao::motion {

/// Whole-body control: what was asked of the joints in this cycle becomes the wish of a QP that
/// keeps the feet as they stand, the centre of mass over them and the effectors on their targets.
/// Off until told; away while the robot walks.
class WholeBody {
 public:
  explicit WholeBody(std::shared_ptr<const RobotModel> model);

  /// `angle`: the present command.
  void take(const WbEnable& request, const JointArray<double>& angle);
  void take(const WbFootState& request, const JointArray<double>& angle);
  void take(const WbBalance& request, const JointArray<double>& angle);
  void take(const WbEffector& request, const JointArray<double>& angle);
  void take(const WbEffectorTarget& request, const JointArray<double>& angle);
  void take(const WbOptimize& request, const JointArray<double>& angle);

  bool enabled() const { return on_; }

  /// For this cycle: these places too, by the whole body; `joints` have no wishes of their own.
  /// What is left of the way in the cycle before [m].
  double pursue(const std::vector<PlaceTask>& tasks, const JointSet& joints,
                const JointArray<double>& angle);

  /// One cycle of `dt` [s], if enabled: `angle`, what was asked for, becomes what the whole body
  /// can do, from `before`, the command of the last cycle. `asked` joints were asked to move,
  /// `limp` ones do not.
  void apply(double dt, const JointArray<double>& before, const JointSet& asked,
             const JointSet& limp, JointArray<double>& angle);

  void archive(Archive& archive);

 private:
  struct Led {  // an effector under control, or one that keeps its place
    PlaceTask task;
    bool led = false;
    bool kept = false;
  };
  void stand(const JointArray<double>& angle);
  std::optional<Foot> anchor() const;
  PlaceTask holdOf(std::size_t chain) const;
  bool anyLed() const;
  void addFeet(BodySolver::Demand& demand) const;
  void addBalance(BodySolver::Demand& demand);

  std::shared_ptr<const RobotModel> model_;
  BodySolver solver_;
  std::array<Effector, 2> soles_;
  bool on_ = false;
  bool by_effector_ = false;  // switched on by an effector's control, and off with it
  std::array<FootState, 2> states_{FootState::Free, FootState::Free};
  bool balance_ = false;
  Feet support_ = Feet::Both;
  Pose X_LR_ = Pose::Identity();  // the right sole in the left one, as they stand
  std::array<Led, 3> effectors_;
  JointArray<double> wish_;
  std::vector<PlaceTask> pursued_;
  JointSet pursuing_;
};

/// Where the soles' outlines of `feet` support, in the sole frame of the first of them.
Polygon calcSupport(const Kinematics& body, Feet feet);

/// The phase of WbGoToBalance: both soles stay to each other, the centre of mass moves over the
/// middle of the supporting feet at rest at both ends, the torso keeps its slope as well as it can.
class GoToBalance final : public Phase {
 public:
  GoToBalance(std::shared_ptr<const RobotModel> model, const WbGoToBalance& request);
  void begin(Body& body) override;
  Progress advance(double dt, const JointSet& mine, Body& body) override;
  std::string failure() const override;
  std::unique_ptr<Phase> clone() const override { return std::make_unique<GoToBalance>(*this); }
  void archive(Archive& archive) override;

 private:
  BodySolver solver_;
  WbGoToBalance request_;
  std::array<Effector, 2> soles_;
  std::vector<PlaceTask> tasks_;
  Eigen::Vector2d from_ = Eigen::Vector2d::Zero();  // [m] in the supporting sole
  Eigen::Vector2d to_ = Eigen::Vector2d::Zero();
  double elapsed_ = 0;
};

}  // namespace nao::motion
