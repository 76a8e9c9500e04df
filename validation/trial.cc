#include "validation/trial.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "runtime/ground_truth.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr double kFallenTilt = 45 * M_PI / 180;  // [rad] nobody comes back from there
constexpr double kFallenHeight = 0.22;  // [m] a Nao's torso hangs at 0.28 to 0.34 m when it walks
constexpr Duration kWakingUp = 15s;     // at most
constexpr Duration kSettling = 1s;      // the body swings on its gears' play for less
constexpr Duration kStopping = 5s;      // two slow steps and the weight back, at most

// The friction asked for takes the place of the one that a seed would draw.
std::shared_ptr<const RobotModel> changeRobot(const ExperimentSettings& settings,
                                              const Conditions& conditions) {
  RobotModel robot = *loadRobot(settings);
  if (conditions.friction > 0) {
    const auto isFloor = [](const EffectSetting& e) { return e.name == "floor_friction"; };
    robot.variation.erase(std::remove_if(robot.variation.begin(), robot.variation.end(), isFloor),
                          robot.variation.end());
  }
  if (conditions.mass_difference != 0) {
    const double all = robot.totalMass();
    const double part = conditions.mass_difference * all / (all - robot.bodies.front().mass);
    robot.effects.push_back({"link_mass", {{"part", part}}, {}, "the experiment"});
  }
  return std::make_shared<RobotModel>(std::move(robot));
}

std::shared_ptr<const WorldModel> changeWorld(const ExperimentSettings& settings,
                                              const Conditions& conditions) {
  WorldModel world = *loadWorld(settings);
  if (conditions.friction > 0) world.ground.friction = conditions.friction;
  if (conditions.slope != 0) {
    const double along = std::sin(conditions.slope);
    world.ground_normal = Vec3(-along * std::cos(conditions.uphill),
                               -along * std::sin(conditions.uphill), std::cos(conditions.slope));
  }
  return std::make_shared<WorldModel>(std::move(world));
}

sim::WorldOptions makeOptions(const ExperimentSettings& settings, std::uint64_t seed) {
  sim::WorldOptions options(settings.step);
  options.mode = settings.mode;
  options.seed = seed;
  return options;
}

// `place` with the heading that is nearest to `before`.
Pose2 unwrap(Pose2 place, double before) {
  place.theta = before + wrapAngle(place.theta - before);
  return place;
}

}  // namespace

struct Trial::Snapshot {
  std::shared_ptr<const runtime::Simulation::Snapshot> simulation;
  Watch watch;
};

Trial::Trial(const ExperimentSettings& settings, std::uint64_t seed, const Conditions& conditions)
    : Trial(settings, seed, changeRobot(settings, conditions), changeWorld(settings, conditions)) {}

Trial::Trial(const ExperimentSettings& settings, std::uint64_t seed,
             std::shared_ptr<const RobotModel> model)
    : Trial(settings, seed, std::move(model), loadWorld(settings)) {}

Trial::Trial(const ExperimentSettings& settings, std::uint64_t seed,
             std::shared_ptr<const RobotModel> model, std::shared_ptr<const WorldModel> world)
    : model_(std::move(model)),
      ground_normal_(world->ground_normal),
      simulation_(std::move(world), {{"nao", model_, {}}}, makeOptions(settings, seed)) {
  start();
}

void Trial::standUp() {
  waitFor(ask(motion::WakeUp{}), kWakingUp);
  waitFor(ask(motion::GoToPosture{"StandInit", 0.5}), kWakingUp);
  wait(kSettling);
  start();
}

void Trial::start() {
  watch_ = Watch();
  watch_.start = now();
  watch_.truth_start = floorPose();
  watch_.odometry_start = state()->position;
  path_.clear();
}

std::shared_ptr<const motion::MotionState> Trial::state() {
  return simulation_.robot(0).ports()->state.get();
}

motion::RequestId Trial::ask(const motion::MotionAction& action) {
  const motion::RequestId id = state()->last_accepted + 1;
  last_id_ = std::max(last_id_ + 1, id);
  NAO_CHECK(simulation_.robot(0).ports()->requests.post({last_id_, action}));
  return last_id_;
}

void Trial::wait(Duration time) {
  for (const SimTime end = now() + time; now() < end && simulation_.world().healthy();) cycle();
}

std::optional<motion::MotionOutcome> Trial::waitFor(motion::RequestId id, Duration limit) {
  for (const SimTime end = now() + limit; now() < end && simulation_.world().healthy();) {
    const auto at = std::find_if(outcomes_.begin(), outcomes_.end(),
                                 [id](const motion::MotionOutcome& o) { return o.id == id; });
    if (at != outcomes_.end()) return *at;
    cycle();
  }
  return std::nullopt;
}

bool Trial::waitForLandings(int landings, Duration limit) {
  for (const SimTime end = now() + limit; now() < end && simulation_.world().healthy();) {
    if (watch_.landings >= landings) return true;
    cycle();
  }
  return false;
}

void Trial::stopWalk() {
  waitFor(ask(motion::StopMove{}), kStopping);
  wait(kSettling);
}

void Trial::record(Duration interval) {
  record_interval_ = interval;
  path_.clear();
}

void Trial::cycle() {
  simulation_.advanceTo(now() + model_->cycle);
  for (motion::MotionOutcome& outcome : simulation_.robot(0).ports()->outcomes.drain()) {
    outcomes_.push_back(std::move(outcome));
  }
  look();
}

void Trial::look() {
  const Pose X_WT = bodies().front();
  const double upright = X_WT.linear().col(2).dot(ground_normal_);
  if (!simulation_.world().healthy() || upright < std::cos(kFallenTilt) ||
      X_WT.translation().dot(ground_normal_) < kFallenHeight) {
    watch_.fell = true;
  }
  const auto state = this->state();
  TrialPoint& here = watch_.here;
  here.t = toSeconds(now() - watch_.start);
  here.truth = unwrap(relativeTo(watch_.truth_start, floorPose()), here.truth.theta);
  here.odometry = unwrap(relativeTo(watch_.odometry_start, state->position), here.odometry.theta);
  countLandings(*state);
  if (record_interval_ > Duration::zero() &&
      (path_.empty() || here.t - path_.back().t >= toSeconds(record_interval_))) {
    path_.push_back(here);
  }
}

// Only the step under way is sure to happen.
void Trial::countLandings(const motion::MotionState& state) {
  if (watch_.lands && now() >= *watch_.lands) {
    ++watch_.landings;
    watch_.lands.reset();
  }
  for (const motion::Footstep& step : state.footsteps) {
    if (step.lands <= now()) continue;
    watch_.lands = step.lands;
    return;
  }
}

Pose2 Trial::floorPose() { return runtime::calcFloorPose(*model_, bodies()); }

std::shared_ptr<const Trial::Snapshot> Trial::snapshot() const {
  return std::make_shared<Snapshot>(Snapshot{simulation_.snapshot(), watch_});
}

void Trial::restore(const Snapshot& snapshot) {
  simulation_.restore(*snapshot.simulation);
  watch_ = snapshot.watch;
}

Experiment makeTrialExperiment(const char* name, const char* summary,
                               Outcome (*run)(const ExperimentSettings&)) {
  Experiment e;
  e.name = name;
  e.summary = summary;
  e.choices = {Choice::Robot, Choice::World, Choice::Step, Choice::Seed, Choice::Runs};
  e.defaults.seed = 1;
  e.defaults.runs = 10;
  e.run = run;
  return e;
}

std::uint64_t seedOf(const ExperimentSettings& settings, int run) {
  return settings.seed == 0 ? 0 : settings.seed + static_cast<std::uint64_t>(run);
}

TextTable makeStatisticsTable(std::string title) {
  return {std::move(title), {"", "mean", "sd", "min", "max"}, {}};
}

void addStatistics(const std::string& name, const std::vector<double>& values, int digits,
                   Report& report, TextTable& table) {
  const Statistics s = calcStatistics(values);
  report.figures.push_back({name, s});
  table.lines.push_back({name, fixed(s.mean, digits), fixed(s.sd, digits), fixed(s.min, digits),
                         fixed(s.max, digits)});
}

}  // namespace nao::validation
