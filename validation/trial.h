#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "motion/motion_request.h"
#include "motion/motion_state.h"
#include "runtime/simulation.h"
#include "validation/experiment.h"

namespace nao::validation {

/// What one run changes about the ground and the body. The robot's motion does not hear of it.
struct Conditions {
  double friction = 0;         // of the ground; 0: as the world and the seed say
  double slope = 0;            // [rad] the ground climbs by this
  double uphill = 0;           // [rad] in this direction, from the robot's x axis to its left
  double mass_difference = 0;  // the robot is heavier by this part, all of it in head and limbs
};

/// A place since Trial::start(), with headings that go on beyond half a turn.
struct TrialPoint {
  double t = 0;    // [s]
  Pose2 truth;     // of frame R
  Pose2 odometry;  // likewise, as ALMotion.getRobotPosition tells it
};

/// One robot in a world of its own, driven as a client of ALMotion would drive it and watched as
/// only a simulator can. Its clock is the world's; the same seed gives the same run to the last
/// bit.
class Trial {
 public:
  /// Crouched, motors off. @throws InputError as loadRobot() and loadWorld().
  Trial(const ExperimentSettings& settings, std::uint64_t seed, const Conditions& conditions = {});
  /// With this robot in place of the settings' one, and the settings' ground.
  Trial(const ExperimentSettings& settings, std::uint64_t seed,
        std::shared_ptr<const RobotModel> model);

  /// Motors on, up into StandInit, a moment of rest; then start().
  void standUp();
  /// From now on places count from here, and what fell before is forgotten.
  void start();

  motion::RequestId ask(const motion::MotionAction& action);
  void wait(Duration time);
  /// Until the request has ended, `limit` at most; nothing if it goes on.
  std::optional<motion::MotionOutcome> waitFor(motion::RequestId id, Duration limit);
  /// Until so many feet have landed since the walk began or waited before, `limit` at most.
  bool waitForLandings(int landings, Duration limit);
  /// Ends a walk and waits until both feet stand and the body has settled.
  void stopWalk();

  SimTime now() const { return simulation_.now(); }
  const RobotModel& model() const { return *model_; }
  runtime::Simulation& simulation() { return simulation_; }
  std::shared_ptr<const motion::MotionState> state();
  /// Where everything is; row i is body i of the model.
  std::vector<Pose> bodies() { return simulation_.world().scene().robots[0].X_WB; }

  const TrialPoint& here() const { return watch_.here; }
  /// The torso leant by 45 degrees or hung lower than any walk or stand lets it.
  bool fell() const { return watch_.fell; }
  int landings() const { return watch_.landings; }

  /// Keeps every point from now on, every `interval`.
  void record(Duration interval);
  const std::vector<TrialPoint>& path() const { return path_; }

  /// Goes back to `snapshot` of this trial; the path is left alone.
  struct Snapshot;
  std::shared_ptr<const Snapshot> snapshot() const;
  void restore(const Snapshot& snapshot);

 private:
  struct Watch {
    Pose2 truth_start, odometry_start;
    SimTime start{};
    TrialPoint here;
    bool fell = false;
    int landings = 0;
    std::optional<SimTime> lands;  // the foot in the air
  };
  Trial(const ExperimentSettings& settings, std::uint64_t seed,
        std::shared_ptr<const RobotModel> model, std::shared_ptr<const WorldModel> world);
  void cycle();
  void look();
  void countLandings(const motion::MotionState& state);
  Pose2 floorPose();

  std::shared_ptr<const RobotModel> model_;
  Vec3 ground_normal_;
  runtime::Simulation simulation_;
  motion::RequestId last_id_ = 0;
  std::vector<motion::MotionOutcome> outcomes_;

  Watch watch_;
  Duration record_interval_{};
  std::vector<TrialPoint> path_;
};

/// An experiment of seeded trials: ten runs from seed 1 on, of the documented robot.
Experiment makeTrialExperiment(const char* name, const char* summary,
                               Outcome (*run)(const ExperimentSettings&));

/// The seed of run 0, 1, ... of an experiment: settings.seed and those after it; 0 stays 0.
std::uint64_t seedOf(const ExperimentSettings& settings, int run);

/// Adds a figure with mean, sd, min and max over runs, and a line for a person to `table`.
void addStatistics(const std::string& name, const std::vector<double>& values, int digits,
                   Report& report, TextTable& table);
/// The table that addStatistics() fills.
TextTable makeStatisticsTable(std::string title);

}  // namespace nao::validation
