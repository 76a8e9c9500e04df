// Thesis section 5.4, table 2 and figure 28: how many robots, at what speed, and where the time
// goes. The thesis counts frames per second of its whole program on a PC of 2008; we count
// simulated seconds per second of one core. Comparable is how the cost grows with the robots.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.h"
#include "runtime/simulation.h"
#include "validation/experiment.h"
#include "validation/process.h"
#include "validation/profiler.h"
#include "validation/walk_recording.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr std::array<int, 5> kRobots{1, 2, 4, 8, 22};
constexpr int kProfiled = 4;  // robots, as in figure 28
constexpr int kParts = 9;     // a cost is the median of so many parts of the duration
constexpr std::array<int, 5> kThesisRobots{0, 1, 2, 3, 4};
constexpr std::array<double, 5> kThesisBase{320, 120, 100, 65, 50};  // frames per second
constexpr std::array<double, 5> kThesisPlay{320, 110, 55, 30, 10};

class Team {
 public:
  Team(const ExperimentSettings& settings, const std::shared_ptr<const RobotModel>& model,
       int robots, sim::WorldOptions options)
      : simulation_(std::make_unique<runtime::Simulation>(
            loadWorld(settings), robotsInRows(model, robots), std::move(options))) {}

  void ask(motion::RequestId id, const motion::MotionAction& action) {
    for (std::size_t i = 0; i < simulation_->robotCount(); ++i) {
      NAO_CHECK(simulation_->robot(i).ports()->requests.post({id, action}));
    }
  }
  /// With services that read what the robots tell.
  void wait(Duration time) {
    const SimTime end = simulation_->now() + time;
    while (simulation_->now() < end) {
      simulation_->advanceTo(
          std::min(end, simulation_->now() + simulation_->robot(0).model().cycle));
      for (std::size_t i = 0; i < simulation_->robotCount(); ++i) {
        simulation_->robot(i).ports()->outcomes.drain();
        simulation_->robot(i).ports()->touches.drain();
      }
    }
  }

  /// Simulated seconds per second of one core: the median of several parts.
  double measure(Duration time) {
    const Duration cycle = simulation_->robot(0).model().cycle;
    const Duration part = std::max(cycle, time / kParts / cycle * cycle);
    std::vector<double> factors;
    for (int i = 0; i < kParts; ++i) {
      const double before = threadCpuSeconds();
      wait(part);
      factors.push_back(toSeconds(part) / (threadCpuSeconds() - before));
    }
    std::nth_element(factors.begin(), factors.begin() + kParts / 2, factors.end());
    return factors[kParts / 2];
  }

  /// The same cycles as wait(), under a profiler that the world's watch also tells.
  void profile(Duration time, Profiler& profiler) {
    sim::World& world = simulation_->world();
    for (const SimTime end = world.now() + time; world.now() < end;) {
      for (std::size_t i = 0; i < world.robotCount(); ++i) tickIfDue(i, profiler);
      profiler.begin();
      world.step();
    }
  }

  bool stands() { return allStand(simulation_->world()); }
  std::uint64_t hash() const { return simulation_->hash(); }

 private:
  void tickIfDue(std::size_t i, Profiler& profiler) {
    sim::World& world = simulation_->world();
    const Duration cycle = simulation_->robot(i).model().cycle;
    if (world.now().time_since_epoch() % cycle != Duration::zero()) return;
    profiler.begin();
    const SensorFrame frame = world.readSensors(i);
    profiler.begin();
    const JointCommand command = simulation_->robot(i).tick(frame);
    profiler.endedMotion();
    world.setCommand(i, command);
  }

  std::unique_ptr<runtime::Simulation> simulation_;
};

struct Load {
  int robots = 0;
  double standing = 0;  // simulated seconds per second of one core
  double walking = 0;
  double memory_mb = 0;  // per robot
  bool fell = false;
  std::uint64_t hash = 0;

  double microsecondsPerRobotStep(Duration step) const {
    return toSeconds(step) / walking / robots * 1e6;
  }
};

// The team stays alive, so that the next one can not reuse its memory.
Load measureLoad(const ExperimentSettings& settings, int robots, std::vector<Team>& teams) {
  const auto model = loadRobot(settings);
  if (model->feet.size() != 2) {
    throw InputError("robot " + settings.robot + ": expected two feet to walk on");
  }
  Load load;
  load.robots = robots;
  const std::size_t before = residentMemory();
  teams.emplace_back(settings, model, robots, settings.step);
  Team& team = teams.back();
  team.ask(1, motion::WakeUp{});
  team.wait(4s);
  load.standing = team.measure(settings.duration);
  team.ask(2, motion::MoveToward{1, 0, 0, {}});
  team.wait(1s);
  load.walking = team.measure(settings.duration);
  load.memory_mb = static_cast<double>(residentMemory() - before) * 1e-6 / robots;
  load.fell = !team.stands();
  load.hash = team.hash();
  return load;
}

// Microseconds per robot and step of each part, while the robots walk.
std::vector<Profiler::Part> profileTeam(const ExperimentSettings& settings) {
  Profiler profiler;
  sim::WorldOptions options(settings.step);
  options.watch = [&profiler](sim::Phase phase) { profiler.ended(phase); };
  Team team(settings, loadRobot(settings), kProfiled, options);
  team.ask(1, motion::WakeUp{});
  team.wait(4s);
  team.ask(2, motion::MoveToward{1, 0, 0, {}});
  team.wait(1s);
  profiler = Profiler();
  team.profile(settings.duration, profiler);
  std::vector<Profiler::Part> parts = profiler.parts();
  const double steps = toSeconds(settings.duration) / toSeconds(settings.step);
  for (Profiler::Part& part : parts) part.seconds *= 1e6 / (steps * kProfiled);
  return parts;
}

// What each robot adds to the thesis' frame, over what the first one added.
std::vector<double> thesisGrowth(const std::array<double, 5>& fps) {
  std::vector<double> growth;
  const double first = 1 / fps[1] - 1 / fps[0];
  for (std::size_t i = 1; i < fps.size(); ++i) {
    growth.push_back((1 / fps[i] - 1 / fps[0]) / kThesisRobots[i] / first);
  }
  return growth;
}

Panel plotSpeed(const std::vector<Load>& loads) {
  Panel panel = makePanel("Speed on one core", "robots", "simulated seconds per second");
  std::vector<double> n, standing, walking;
  for (const Load& load : loads) {
    n.push_back(load.robots);
    standing.push_back(load.standing);
    walking.push_back(load.walking);
  }
  panel.log_x = panel.log_y = true;
  panel.x_ticks = n;
  panel.y_range = {0.5, 1000};
  panel.series = {{"standing", n, standing, Stroke::LinePoints, Ink::Sky},
                  {"walking", n, walking, Stroke::LinePoints, Ink::Blue},
                  {"real time", {n.front(), n.back()}, {1, 1}, Stroke::Dashed, Ink::Black}};
  return panel;
}

Panel plotGrowth(const std::vector<Load>& loads) {
  Panel panel = makePanel("Cost of each robot, over that of a robot alone", "robots", "times");
  std::vector<double> n, ours;
  for (const Load& load : loads) {
    n.push_back(load.robots);
    ours.push_back(loads.front().walking / load.walking / load.robots);
  }
  const std::vector<double> thesis_n(kThesisRobots.begin() + 1, kThesisRobots.end());
  panel.log_x = true;
  panel.x_ticks = n;
  panel.y_range = {0, 4.5};
  panel.key = "top right";
  panel.series = {
      {"ours, walking", n, ours, Stroke::LinePoints, Ink::Blue},
      {"thesis, standing", thesis_n, thesisGrowth(kThesisBase), Stroke::Dashed, Ink::Thesis},
      {"thesis, playing", thesis_n, thesisGrowth(kThesisPlay), Stroke::LinePoints, Ink::Thesis}};
  return panel;
}

Panel plotParts(const std::vector<Profiler::Part>& parts) {
  Panel panel = makePanel("Where the time goes: four robots walking", "", "µs per robot and step");
  Series bars{"", {}, {}, Stroke::Bars, Ink::Green};
  for (const Profiler::Part& part : parts) {
    bars.x.push_back(static_cast<double>(bars.x.size()));
    bars.y.push_back(part.seconds);
    panel.categories.push_back(part.name);
  }
  panel.series = {bars};
  return panel;
}

void fillTables(const ExperimentSettings& settings, const std::vector<Load>& loads,
                const std::vector<Profiler::Part>& parts, Report& report) {
  TextTable table{
      "Robots on one core",
      {"robots", "standing [x real time]", "walking [x real time]", "µs per robot and step",
       "MB per robot", "thesis fps, standing", "thesis fps, playing"},
      {}};
  std::vector<Row> rows;
  for (const Load& load : loads) {
    const double step_us = load.microsecondsPerRobotStep(settings.step);
    rows.push_back({{"robots", static_cast<double>(load.robots)},
                    {"realtime_factor_one_core", load.walking},
                    {"realtime_factor_standing", load.standing},
                    {"memory_mb", load.memory_mb},
                    {"robot_step_cpu_us", step_us}});
    const auto at = std::find(kThesisRobots.begin(), kThesisRobots.end(), load.robots);
    const auto i = static_cast<std::size_t>(at - kThesisRobots.begin());
    const bool known = at != kThesisRobots.end();
    table.lines.push_back({std::to_string(load.robots), fixed(load.standing, 1),
                           fixed(load.walking, 1), fixed(step_us, 2), fixed(load.memory_mb, 2),
                           known ? fixed(kThesisBase[i], 0) : "",
                           known ? fixed(kThesisPlay[i], 0) : ""});
  }
  TextTable costs{
      "Where the time goes: four robots walking", {"part", "µs per robot and step"}, {}};
  std::vector<Row> part_rows;
  for (const Profiler::Part& part : parts) {
    part_rows.push_back({{"part", part.name}, {"robot_step_cpu_us", part.seconds}});
    costs.lines.push_back({part.name, fixed(part.seconds, 3)});
  }
  report.tables = {std::move(table), std::move(costs)};
  report.figures = {{"realtime_factor_22_robots_with_motion", loads.back().walking},
                    {"rows", std::move(rows)},
                    {"part_rows", std::move(part_rows)}};
}

Outcome run(const ExperimentSettings& settings) {
  std::vector<Team> teams;
  measureLoad(settings, 1, teams);  // what the program itself loads is no robot's memory
  std::vector<Load> loads;
  for (const int robots : kRobots) loads.push_back(measureLoad(settings, robots, teams));
  const std::vector<Profiler::Part> parts = profileTeam(settings);

  Outcome outcome;
  Report& report = outcome.report;
  report = startReport("robots", settings);
  fillTables(settings, loads, parts, report);
  for (const Load& load : loads) {
    report.hash = combineHash(report.hash, load.hash);
    if (load.fell) report.remarks.push_back("With " + std::to_string(load.robots) + " one fell.");
  }
  report.remarks.push_back(
      "With sensors, motion and walk engines, without cameras. The thesis' frames are of a whole "
      "program on a Core i7-920; physics was half of it.");
  outcome.picture = {"Robots and speed (thesis section 5.4)",
                     {plotSpeed(loads), plotGrowth(loads), plotParts(parts)},
                     1,
                     900,
                     1250};
  return outcome;
}

}  // namespace

Experiment robotsExperiment() {
  Experiment e;
  e.name = "robots";
  e.summary = "Speed and memory of 1 to 22 robots, and where the time goes (thesis table 2).";
  e.choices = {Choice::Robot, Choice::World, Choice::Step, Choice::Duration};
  e.defaults.duration = 3s;
  e.run = run;
  return e;
}

}  // namespace nao::validation
