// Thesis section 5.4: in USARSim the sonars of four Naos cost 6 to 20 ms a frame, for they shoot
// many rays. Here: how well do ours measure, against distances that geometry knows, and what do
// they cost?
#include <algorithm>
#include <array>
#include <cmath>

#include "validation/experiment.h"
#include "validation/profiler.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr int kRobots = 4;
constexpr std::array<double, 8> kDistances{0.3, 0.4, 0.6, 0.75, 1.0, 1.5, 2.0, 2.45};  // [m]
constexpr double kThick = 0.1;            // [m] of walls
constexpr double kBall = 0.1;             // [m] radius
constexpr double kThesisIdle_ms = 6;      // of a frame: 9 ms with, 3 ms without sonar
constexpr double kThesisPlaying_ms = 20;  // 80 and 60 ms

Shape wall(const Vec3& size, const Pose& X_WS) {
  Shape shape;
  shape.kind = Shape::Kind::Box;
  shape.size = size;
  shape.X_BS = X_WS;
  return shape;
}

/// A thing whose nearest point within the cone of a receiver is at a known distance.
struct Target {
  const char* name;
  double nearest;  // [m] from this distance on it stands clear of the robot
  /// Puts it `distance` [m] away from the receiver at `X_WR`; `side` is +1 left, -1 right.
  Shape (*place)(const Pose& X_WR, double side, double distance);
};

// Square to the robot: its nearest point is straight ahead, 22.5 degrees off the receiver's axis.
Shape placeAhead(const Pose& X_WR, double, double distance) {
  const Vec3 p = X_WR.translation() + Vec3(distance + kThick / 2, 0, 0);
  return wall({kThick, 6, 4}, translation(p));
}

// Along the axis: its nearest point in the cone is on the rim, 30 degrees off, at 2 s.
Shape placeBeside(const Pose& X_WR, double side, double distance) {
  const double s = distance * std::sin(M_PI / 6);
  return wall({10, kThick, 4}, X_WR * translation({5, side * (s + kThick / 2), 0}));
}

Shape ballAt(const Pose& X_WR, double bearing, double distance) {
  Shape shape;
  shape.size.x() = kBall;
  const double r = distance + kBall;
  shape.X_BS = X_WR * translation({r * std::cos(bearing), r * std::sin(bearing), 0});
  return shape;
}
Shape placeOnAxis(const Pose& X_WR, double, double distance) { return ballAt(X_WR, 0, distance); }
Shape placeAside(const Pose& X_WR, double side, double distance) {
  return ballAt(X_WR, side * 0.45, distance);
}

const Target kTargets[] = {{"wall ahead", 0.3, placeAhead},
                           {"ball on the axis", 0.3, placeOnAxis},
                           {"ball 26 degrees aside", 0.3, placeAside},
                           {"wall along the axis", 0.6, placeBeside}};

class Stage {
 public:
  explicit Stage(const ExperimentSettings& settings)
      : settings_(settings), model_(loadRobot(settings)) {
    if (model_->sonar.receivers.size() < 2) {
      throw InputError("robot " + settings.robot + ": expected two sonar receivers");
    }
  }
  const SonarModel& sonar() const { return model_->sonar; }

  /// Where a receiver is once the robot stands.
  Pose receiver(std::size_t i) const {
    const sim::World world = stand({});
    const Frame& frame = model_->frames[static_cast<std::size_t>(model_->sonar.receivers[i])];
    return world.scene().robots[0].X_WB[static_cast<std::size_t>(frame.body)] * frame.X_BF;
  }

  /// The first echo [m] that a receiver hears of one thing.
  double listen(std::size_t receiver, const Shape& thing) {
    sim::World world = stand(thing);
    return world.readSensors(0).sonar[receiver][0];
  }

  /// What the sonars of four robots in two rows that face each other cost a cycle [us].
  double measureCost(std::uint64_t& hash) const;

 private:
  JointCommand command() const {
    const Posture* posture = model_->findPosture("StandInit");
    if (!posture) throw InputError("robot " + model_->name + ": expected a posture StandInit");
    return {posture->angle, JointArray<double>(model_->jointCount(), 1.0)};
  }

  // A robot that has stood for half a second, and was then asked for nothing yet.
  sim::World stand(const std::optional<Shape>& thing) const {
    auto model = std::make_shared<WorldModel>();
    if (thing) model->obstacles.push_back({"thing", *thing, {}});
    sim::World world(model, {{"nao", model_, {}}}, settings_.step);
    const JointCommand hold = command();
    world.placeRobot(0, {}, &hold.angle);
    while (world.now() < SimTime(500ms)) {
      world.setCommand(0, hold);
      world.step();
    }
    return world;
  }

  ExperimentSettings settings_;
  std::shared_ptr<const RobotModel> model_;
};

double Stage::measureCost(std::uint64_t& hash) const {
  Profiler profiler;
  sim::WorldOptions options(settings_.step);
  options.watch = [&profiler](sim::Phase phase) { profiler.ended(phase); };
  const std::array<Pose2, kRobots> places{
      {{-0.6, 0, 0}, {-0.6, 1, 0}, {0.6, 0, M_PI}, {0.6, 1, M_PI}}};
  std::vector<sim::RobotSetup> robots;
  for (const Pose2& place : places) {
    robots.push_back({"nao" + std::to_string(robots.size()), model_, place});
  }
  auto field = std::make_shared<WorldModel>(*loadWorld(settings_));
  if (field->balls.empty()) field->balls.push_back({});
  sim::World world(field, robots, options);
  const JointCommand hold = command();
  int cycles = 0;
  for (std::size_t i = 0; i < kRobots; ++i) world.placeRobot(i, places[i], &hold.angle);
  for (; world.now().time_since_epoch() < settings_.duration; ++cycles) {
    const SimTime end = world.now() + model_->cycle;
    for (std::size_t i = 0; i < kRobots; ++i) {
      profiler.begin();
      world.readSensors(i);
      world.setCommand(i, hold);
    }
    while (world.now() < end) world.step();
  }
  hash = world.hash();
  return profiler.seconds(sim::Phase::Sonar) * 1e6 / cycles;
}

struct Readings {
  const char* name;
  std::vector<double> expected, heard, error_mm;
  double largest = 0;  // [m]
};

Readings measure(const Target& target, const std::array<Pose, 2>& receivers, Stage& stage) {
  Readings readings{target.name, {}, {}, {}, 0};
  for (const double distance : kDistances) {
    if (distance < target.nearest || distance < stage.sonar().min_range) continue;
    if (distance > stage.sonar().max_range) continue;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      const Shape thing = target.place(receivers[i], i == 0 ? 1 : -1, distance);
      const double heard = stage.listen(i, thing);
      readings.expected.push_back(distance);
      readings.heard.push_back(heard);
      readings.error_mm.push_back((heard - distance) * 1e3);
      readings.largest = std::max(readings.largest, std::abs(heard - distance));
    }
  }
  return readings;
}

// Balls at 45 degrees off the axis must stay unheard.
int countFalseEchoes(const std::array<Pose, 2>& receivers, Stage& stage) {
  int heard = 0;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const double side = i == 0 ? 1 : -1;
    for (const double distance : {0.4, 0.7}) {
      const Shape thing = ballAt(receivers[i], side * M_PI / 4 * 1.2, distance);
      heard += stage.listen(i, thing) < stage.sonar().max_range;
    }
  }
  return heard;
}

Picture plot(const std::vector<Readings>& all) {
  Panel panel =
      makePanel("First echo of one thing: heard minus geometry", "distance [m]", "error [mm]");
  panel.y_range = {-15, 15};
  const Ink inks[] = {Ink::Blue, Ink::Green, Ink::Purple, Ink::Vermilion};
  for (std::size_t i = 0; i < all.size(); ++i) {
    panel.series.push_back(
        {all[i].name, all[i].expected, all[i].error_mm, Stroke::Points, inks[i % 4]});
  }
  for (const double bar : {-10.0, 10.0}) {
    panel.series.push_back({bar > 0 ? "1 cm" : "",
                            {kDistances.front(), kDistances.back()},
                            {bar, bar},
                            Stroke::Dashed,
                            Ink::Black});
  }
  panel.key = "outside";
  return {"Sonar (thesis section 5.4)", {panel}, 1, 900, 460};
}

void fillReport(const std::vector<Readings>& all, double cost_us, int false_echoes,
                Report& report) {
  TextTable table{
      "First echo of one thing, both receivers", {"thing", "readings", "largest error [mm]"}, {}};
  std::vector<Row> rows;
  double largest = 0;
  for (const Readings& r : all) {
    largest = std::max(largest, r.largest);
    table.lines.push_back({r.name, std::to_string(r.expected.size()), fixed(r.largest * 1e3, 3)});
    rows.push_back({{"thing", std::string(r.name)},
                    {"expected_m", r.expected},
                    {"heard_m", r.heard},
                    {"max_error_m", r.largest}});
  }
  report.tables.push_back(std::move(table));
  report.figures = {{"max_error_m", largest},
                    {"false_echoes", static_cast<double>(false_echoes)},
                    {"cpu_us_per_cycle_4_robots", cost_us},
                    {"thesis_idle_us_per_frame_4_robots", kThesisIdle_ms * 1e3},
                    {"thesis_playing_us_per_frame_4_robots", kThesisPlaying_ms * 1e3},
                    {"rows", std::move(rows)}};
  report.remarks.push_back("The sonars of four Naos cost " + fixed(cost_us, 1) +
                           " µs a cycle of 10 ms; in the thesis 6 ms a frame idle, 20 ms playing.");
}

Outcome run(const ExperimentSettings& settings) {
  Stage stage(settings);
  const std::array<Pose, 2> receivers{stage.receiver(0), stage.receiver(1)};
  std::vector<Readings> all;
  for (const Target& target : kTargets) all.push_back(measure(target, receivers, stage));
  Outcome outcome;
  outcome.report = startReport("sonar", settings);
  const double cost_us = stage.measureCost(outcome.report.hash);
  fillReport(all, cost_us, countFalseEchoes(receivers, stage), outcome.report);
  outcome.picture = plot(all);
  return outcome;
}

}  // namespace

Experiment sonarExperiment() {
  Experiment e;
  e.name = "sonar";
  e.summary = "How well the sonars measure, and what they cost (thesis section 5.4).";
  e.choices = {Choice::Robot, Choice::World, Choice::Step, Choice::Duration};
  e.defaults.robot = "nao_h21_v33_ideal";
  e.defaults.duration = 5s;
  e.run = run;
  return e;
}

}  // namespace nao::validation
