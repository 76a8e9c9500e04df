// Every joint gets a random target of its whole range four times a second, at full stiffness: the
// robot throws itself about and falls. A simulator must survive that. Blown up is a run in which a
// number is not finite or one of the bounds below is passed; no real robot could pass them.
#include <array>
#include <cmath>

#include "core/random.h"
#include "validation/experiment.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

// Joints turn with 8 rad/s at most, a chain of three of them adds up to 10 m/s at the farthest
// point of a Nao; a fall from its height adds 3 m/s.
constexpr double kSpeedBound = 15;  // [m/s] of any body's centre of mass
// Twice the energy of the whole robot at 4 m/s.
constexpr double kEnergyBound = 100;        // [J] of translation
constexpr double kPenetrationBound = 0.05;  // [m] about the size of a foot's height
constexpr double kLying = 0.2;              // [m] torso below this: it has fallen
constexpr Duration kHold = 250ms;           // free choice: long enough for a joint to arrive

struct Run {
  double speed = 0;        // [m/s] largest
  double energy = 0;       // [J] largest
  double penetration = 0;  // [m] largest
  bool finite = true;
  bool fell = false;
  std::uint64_t hash = 0;

  bool blewUp() const {
    return !finite || !(speed < kSpeedBound) || !(energy < kEnergyBound) ||
           !(penetration < kPenetrationBound);
  }
};

class Thrash {
 public:
  Thrash(const ExperimentSettings& settings, std::shared_ptr<const RobotModel> model, Duration step,
         int number)
      : model_(std::move(model)),
        random_(settings.seed + static_cast<std::uint64_t>(number), "thrash"),
        world_(loadWorld(settings), {{"nao", model_, {}}}, step),
        command_{JointArray<double>(model_->jointCount()),
                 JointArray<double>(model_->jointCount(), 1.0)} {
    if (const Posture* posture = model_->findPosture("StandInit")) {
      world_.placeRobot(0, {}, &posture->angle);
    }
    while (world_.now().time_since_epoch() < settings.duration && world_.healthy()) stepOnce();
    found_.finite = world_.healthy();
    found_.hash = world_.hash();
  }
  const Run& found() const { return found_; }

 private:
  void stepOnce() {
    const Duration now = world_.now().time_since_epoch();
    if (now % kHold == Duration::zero()) chooseTargets();
    if (now % model_->cycle == Duration::zero()) {
      world_.setCommand(0, command_);
      look();
    }
    world_.step();
    found_.penetration = std::max(found_.penetration, world_.penetration(0));
  }

  void chooseTargets() {
    for (std::size_t j = 0; j < model_->jointCount(); ++j) {
      command_.angle[j] = random_.uniform(model_->actuators[j].lower, model_->actuators[j].upper);
    }
  }

  // Mean speeds over the last cycle.
  void look() {
    const std::vector<Pose> X_WB = world_.scene().robots[0].X_WB;
    double energy = 0;
    for (std::size_t b = 0; b < before_.size(); ++b) {
      const Body& body = model_->bodies[b];
      const Vec3 moved = X_WB[b] * body.p_BoBcm - before_[b] * body.p_BoBcm;
      const double speed = moved.norm() / toSeconds(model_->cycle);
      found_.speed = std::max(found_.speed, speed);
      energy += body.mass / 2 * speed * speed;
    }
    found_.energy = std::max(found_.energy, energy);
    found_.fell = found_.fell || X_WB[0].translation().z() < kLying;
    before_ = X_WB;
  }

  std::shared_ptr<const RobotModel> model_;
  Random random_;
  sim::World world_;
  JointCommand command_;
  std::vector<Pose> before_;
  Run found_;
};

struct Summary {
  Duration step{};
  std::vector<double> speed, energy, penetration;
  int blowups = 0;
  int falls = 0;
  std::uint64_t hash = 0;

  void add(const Run& run) {
    speed.push_back(run.speed);
    energy.push_back(run.energy);
    penetration.push_back(run.penetration);
    blowups += run.blewUp();
    falls += run.fell;
    hash = combineHash(hash, run.hash);
  }
};

Picture plot(const std::vector<Summary>& all, int runs) {
  const Ink inks[] = {Ink::Blue, Ink::Green, Ink::Vermilion};
  std::vector<double> number;
  for (int i = 0; i < runs; ++i) number.push_back(i + 1);
  Panel depth = makePanel("Largest penetration of the ground", "run", "depth [mm]");
  Panel speed = makePanel("Largest speed of any body", "run", "speed [m/s]");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string label = fixed(toSeconds(all[i].step) * 1e3, 0) + " ms";
    std::vector<double> depth_mm;
    for (const double d : all[i].penetration) depth_mm.push_back(d * 1e3);
    depth.series.push_back({label, number, depth_mm, Stroke::LinePoints, inks[i % 3]});
    speed.series.push_back({label, number, all[i].speed, Stroke::LinePoints, inks[i % 3]});
  }
  depth.key = speed.key = "outside";
  return {"Random commands over the full range", {depth, speed}, 1, 900, 700};
}

Row toRow(const Summary& s) {
  return {{"step_s", toSeconds(s.step)},
          {"blowups", static_cast<double>(s.blowups)},
          {"falls", static_cast<double>(s.falls)},
          {"speed_max_m_per_s", calcStatistics(s.speed).max},
          {"energy_max_J", calcStatistics(s.energy).max},
          {"penetration_max_m", calcStatistics(s.penetration).max}};
}

std::vector<std::string> toLine(const Summary& s) {
  return {fixed(toSeconds(s.step) * 1e3, 0),
          std::to_string(s.blowups),
          std::to_string(s.falls),
          fixed(calcStatistics(s.speed).max, 2),
          fixed(calcStatistics(s.energy).max, 1),
          fixed(calcStatistics(s.penetration).max * 1e3, 1)};
}

void fillReport(const ExperimentSettings& settings, const std::vector<Summary>& all,
                Report& report) {
  double blowups = 0;
  std::vector<Row> rows;
  TextTable table;
  table.title = std::to_string(settings.runs) + " runs of " +
                fixed(toSeconds(settings.duration), 0) + " s, random commands over the full range";
  table.head = {"step [ms]",       "blow-ups",       "falls",
                "speed max [m/s]", "energy max [J]", "penetration max [mm]"};
  for (const Summary& summary : all) {
    blowups += summary.blowups;
    report.hash = combineHash(report.hash, summary.hash);
    rows.push_back(toRow(summary));
    table.lines.push_back(toLine(summary));
  }
  report.figures = {{"blowups", blowups},
                    {"runs", static_cast<double>(settings.runs)},
                    {"duration_s", toSeconds(settings.duration)},
                    {"rows", std::move(rows)}};
  report.tables.push_back(std::move(table));
  report.remarks.push_back("Blown up: not finite, or beyond " + fixed(kSpeedBound, 0) + " m/s, " +
                           fixed(kEnergyBound, 0) + " J or " + fixed(kPenetrationBound * 1e3, 0) +
                           " mm in the ground.");
}

Outcome run(const ExperimentSettings& settings) {
  const auto model = loadRobot(settings);
  std::vector<Summary> all;
  for (const Duration step : {1ms, 2ms, 5ms}) {
    Summary summary;
    summary.step = step;
    for (int i = 0; i < settings.runs; ++i) summary.add(Thrash(settings, model, step, i).found());
    all.push_back(std::move(summary));
  }
  Outcome outcome;
  outcome.report = startReport("thrash", settings);
  fillReport(settings, all, outcome.report);
  outcome.picture = plot(all, settings.runs);
  return outcome;
}

}  // namespace

Experiment thrashExperiment() {
  Experiment e;
  e.name = "thrash";
  e.summary = "Random commands over the full range, with falls, at 1, 2 and 5 ms: does it blow up?";
  e.choices = {Choice::Robot, Choice::World, Choice::Seed, Choice::Runs, Choice::Duration};
  e.defaults.seed = 1;
  e.defaults.runs = 20;
  e.defaults.duration = 10s;
  e.run = run;
  return e;
}

}  // namespace nao::validation
