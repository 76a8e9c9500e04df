// A Nao stands in StandInit. Nothing moves it, so whatever moves is the simulator's.
#include <cmath>

#include "validation/experiment.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""s;

constexpr double kDegree = M_PI / 180;
constexpr SimTime kSettled = SimTime(1s);  // until then the legs give way under the weight

struct Standing {
  double drift_m = 0;                  // largest
  double tilt_change_deg = 0;          // largest
  double penetration_m = 0;            // largest, over all of the time
  std::vector<double> t, drift, tilt;  // [s], [m], [deg] by cycle
  std::map<std::string, double> draw;
  std::uint64_t hash = 0;
};

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

class Stand {
 public:
  Stand(const ExperimentSettings& settings, const std::string& robot)
      : world_(make(settings, robot)) {
    const RobotModel& model = *world_.robot(0).model;
    const Posture* posture = model.findPosture("StandInit");
    if (!posture) throw InputError("robot " + robot + ": expected a posture StandInit to stand in");
    const JointCommand command{posture->angle, JointArray<double>(model.jointCount(), 1.0)};
    world_.placeRobot(0, {}, &command.angle);
    while (world_.now().time_since_epoch() < settings.duration && world_.healthy()) {
      if (world_.now().time_since_epoch() % model.cycle == Duration::zero()) {
        world_.setCommand(0, command);
        look();
      }
      world_.step();
      found_.penetration_m = std::max(found_.penetration_m, world_.penetration(0));
    }
    found_.hash = world_.hash();
    found_.draw = world_.draw();
  }
  const Standing& found() const { return found_; }

 private:
  static sim::World make(const ExperimentSettings& settings, const std::string& robot) {
    sim::WorldOptions options(settings.step);
    options.mode = settings.mode;
    options.seed = settings.seed;
    return {
        loadWorld(settings), {{"nao", loadRobotModel(settings.robots_dir, robot), {}}}, options};
  }

  void look() {
    const Pose X_WT = world_.scene().robots[0].X_WB[0];
    if (world_.now() < kSettled) return;
    if (found_.t.empty()) settled_ = X_WT;
    const Vec3 moved = X_WT.translation() - settled_.translation();
    found_.t.push_back(toSeconds(world_.now()));
    found_.drift.push_back(moved.head<2>().norm());
    found_.tilt.push_back(angleBetween(X_WT.linear().col(2), settled_.linear().col(2)) / kDegree);
    found_.drift_m = std::max(found_.drift_m, found_.drift.back());
    found_.tilt_change_deg = std::max(found_.tilt_change_deg, found_.tilt.back());
  }

  sim::World world_;
  Pose settled_ = Pose::Identity();
  Standing found_;
};

Picture plot(const std::vector<std::pair<std::string, Standing>>& all) {
  Panel drift = makePanel("Drift of the torso since t = 1 s", "time [s]", "drift [mm]");
  Panel tilt = makePanel("Change of its tilt", "time [s]", "tilt [deg]");
  const Ink inks[] = {Ink::Blue, Ink::Orange};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [name, s] = all[i];
    std::vector<double> drift_mm;
    for (const double d : s.drift) drift_mm.push_back(d * 1e3);
    drift.series.push_back({name, s.t, drift_mm, Stroke::Line, inks[i % 2]});
    tilt.series.push_back({name, s.t, s.tilt, Stroke::Line, inks[i % 2]});
  }
  drift.key = tilt.key = "top right";
  return {"Standing still", {drift, tilt}, 1, 900, 700};
}

// The robot asked for and, beside an ideal one, its documented twin; modes other than the implicit
// one have ideal drives alone.
std::vector<std::string> robotsToStand(const std::string& robot, sim::Mode mode) {
  if (mode != sim::Mode::Implicit) return {robot};
  const std::string ideal = "_ideal";
  if (robot.size() <= ideal.size()) return {robot};
  const std::size_t at = robot.size() - ideal.size();
  if (robot.compare(at, ideal.size(), ideal) != 0) return {robot};
  return {robot, robot.substr(0, at)};
}

void fillReport(const ExperimentSettings& settings,
                const std::vector<std::pair<std::string, Standing>>& all, Report& report) {
  TextTable table;
  table.title = "Standing in StandInit for " + fixed(toSeconds(settings.duration), 0) +
                " s: the largest change since t = 1 s";
  table.head = {"robot", "drift [mm]", "tilt [deg]", "penetration [mm]"};
  std::vector<Row> rows;
  for (const auto& [robot, s] : all) {
    report.hash = combineHash(report.hash, s.hash);
    for (const auto& [name, value] : s.draw) report.draw[robot + "." + name] = value;
    rows.push_back({{"robot", robot},
                    {"drift_m", s.drift_m},
                    {"drift_at_end_m", s.drift.empty() ? 0 : s.drift.back()},
                    {"tilt_change_deg", s.tilt_change_deg},
                    {"penetration_max_m", s.penetration_m}});
    table.lines.push_back({robot, fixed(s.drift_m * 1e3, 4), fixed(s.tilt_change_deg, 4),
                           fixed(s.penetration_m * 1e3, 3)});
  }
  const Standing& first = all.front().second;
  report.figures = {{"drift_m", first.drift_m},
                    {"tilt_change_deg", first.tilt_change_deg},
                    {"penetration_max_m", first.penetration_m},
                    {"duration_s", toSeconds(settings.duration)},
                    {"rows", std::move(rows)}};
  report.tables.push_back(std::move(table));
}

Outcome run(const ExperimentSettings& settings) {
  std::vector<std::pair<std::string, Standing>> all;
  for (const std::string& robot : robotsToStand(settings.robot, settings.mode)) {
    all.emplace_back(robot, Stand(settings, robot).found());
  }
  Outcome outcome;
  outcome.report = startReport("stand", settings);
  fillReport(settings, all, outcome.report);
  outcome.picture = plot(all);
  return outcome;
}

}  // namespace

Experiment standExperiment() {
  Experiment e;
  e.name = "stand";
  e.summary = "A Nao stands still: how far does it drift?";
  e.choices = {Choice::Robot, Choice::World, Choice::Step,
               Choice::Mode,  Choice::Seed,  Choice::Duration};
  e.defaults.robot = "nao_h21_v33_ideal";
  e.defaults.duration = 60s;
  e.run = run;
  return e;
}

}  // namespace nao::validation
