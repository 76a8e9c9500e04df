#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/archive.h"
#include "motion/gait.h"
#include "walk_engine/step_rules.h"
#include "walk_engine/tuning.h"

namespace nao::walk {

/// What the steps are for.
struct Goal {
  enum class Kind { Stand, Velocity, Target, Steps };
  Kind kind = Kind::Stand;
  StepFractions fractions;               // of Velocity
  Pose2 target;                          // of Target: where R shall stand, in the odometry frame
  std::vector<motion::StepOrder> steps;  // of Steps: those that are not planned yet
  motion::GaitConfig config;

  void archive(Archive& archive);
};

using FeetPlaces = std::array<Pose2, 2>;  // soles by Foot, in the odometry frame

/// The frame R of feet at these places.
Pose2 robotPlace(const FeetPlaces& feet);

/// Where `swing` lands next on the way to the goal; nothing once the goal is reached and the feet
/// stand side by side.
std::optional<Pose2> calcNextPlace(const Goal& goal, const FeetPlaces& feet, Foot swing);

/// The foot to begin with: the one on the side the robot turns or goes to.
Foot chooseFirstFoot(const Goal& goal, const FeetPlaces& feet);

/// One step: the weight goes over to the supporting foot, then the other one swings.
struct PlannedStep {
  Foot swing = Foot::Left;
  Pose2 from, to;                    // of the swinging sole, in the odometry frame
  std::int64_t start = 0;            // [ticks]
  int double_support = 0;            // [ticks]
  int single_support = 0;            // [ticks]
  int shift = 0;                     // [ticks] end of the double support in which the weight moves
  double height = 0;                 // [m] of the swing
  bool arrives = false;              // where the goal wants that foot
  Eigen::Vector2d zmp_from, zmp_to;  // [m] moves over during the shift, then rests
  Eigen::Vector2d moved = Eigen::Vector2d::Zero();  // [m] part of `to` that answers a push
  std::int64_t lift() const { return start + double_support; }
  std::int64_t end() const { return lift() + single_support; }

  void archive(Archive& archive);
};

/// The steps from now on and the zero moment point they ask for, on a clock of ticks of one
/// control cycle each. The step under way changes only to
/// catch a push; later ones follow the newest goal. A robot that sways lands beside the place where
/// its last step was to go, and again when it steps there anew: some such steps on it stays where
/// it is. After the last step the point moves between the feet and stays there.
class FootstepPlan {
 public:
  FootstepPlan(const Tuning& tuning, double tick_seconds);

  /// Both feet stand here, the body is at rest; no steps.
  void reset(const FeetPlaces& feet, std::int64_t now);

  /// Plans towards `goal` after the step under way.
  void follow(const Goal& goal, std::int64_t now);

  /// Plans these steps: after those already ordered, or in their place (`clear`).
  void order(const std::vector<motion::StepOrder>& steps, bool clear, std::int64_t now);

  /// Moves the landing under way by `by` [m]; all later steps follow from there.
  void moveLanding(const Eigen::Vector2d& by);

  /// Under each foot that will carry the robot the zero moment point goes inward by so much [m]
  /// beyond the tuning's. The step under way stays.
  void setInset(double inset);

  /// Ends steps that are over at `now` and plans as far as `horizon`.
  void advance(std::int64_t now, std::int64_t horizon);

  /// The step under way, or nothing while standing.
  const PlannedStep* current() const { return steps_.empty() ? nullptr : &steps_.front(); }
  const std::vector<PlannedStep>& steps() const { return steps_; }

  /// Where the feet stand; a swinging foot counts where it lifted.
  const FeetPlaces& feet() const { return feet_; }
  /// The feet after the step under way.
  FeetPlaces nextFeet() const;

  Eigen::Vector2d calcZmp(std::int64_t tick) const;
  /// No steps, and the zero moment point has come to rest before `now`.
  bool atRest(std::int64_t now) const;

  void archive(Archive& archive);

 private:
  struct NextStep {
    Foot swing = Foot::Left;
    Pose2 to;
    double period = 0;  // [s]
  };

  Eigen::Vector2d settle(const Eigen::Vector2d& from, const Eigen::Vector2d& rest,
                         std::int64_t elapsed) const;
  bool append();
  bool hasArrived() const;
  std::optional<NextStep> chooseNext(const FeetPlaces& feet);
  std::vector<motion::StepOrder> withdrawOrders() const;
  FeetPlaces lastFeet() const;
  std::int64_t end() const;
  Eigen::Vector2d zmpOf(const Pose2& sole, Foot foot) const;
  Eigen::Vector2d zmpBetween(const FeetPlaces& feet) const;
  int ticks(double seconds) const;

  Tuning tuning_;
  double tick_seconds_;
  Goal goal_;
  FeetPlaces feet_;
  std::vector<PlannedStep> steps_;  // the first may be under way
  double inset_ = 0;                // [m]
  bool complete_ = true;            // the goal asks for no further steps
  int arrivals_ = 0;                // of steps to the newest goal
  bool rest_first_ = false;         // before the next step, the body comes to rest
  std::int64_t begin_ = 0;          // tick of the newest goal
  std::int64_t stand_since_ = 0;    // tick at which the last step ended
  Eigen::Vector2d stand_zmp_ = Eigen::Vector2d::Zero();  // [m] at that tick
};

}  // namespace nao::walk
