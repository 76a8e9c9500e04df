// Thesis section 5.3.2, figure 24: a circle of 0.60 m radius, walked by one velocity command that
// nobody corrects. The thesis replayed the commands of a real robot; none of its ten simulated
// circles closed.
#include <Eigen/Dense>
#include <cmath>

#include "validation/experiment.h"
#include "validation/trial.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kRadius = 0.60;   // [m]
constexpr double kSpeed = 0.08;    // [m/s] free: the full speed 0.095 would leave no step to turn
constexpr double kClosed = 0.20;   // [m] from the start, the bar
constexpr double kPatience = 1.5;  // times as long as the circle should take
constexpr Duration kPlotted = 100ms;

struct Circle {
  std::vector<TrialPoint> path;
  double side = 1;  // 1: to the left
  bool round = false;
  bool fell = false;
  double closure = 0;  // [m] from the start when it looks ahead again
  double radius = 0;   // [m] fitted
  double odometry_radius = 0;

  bool closed() const { return round && !fell && closure <= kClosed; }
};

// Kasa's fit: x^2 + y^2 = 2 a x + 2 b y + c by least squares, radius^2 = c + a^2 + b^2.
template <class Place>
double fitRadius(const std::vector<TrialPoint>& path, Place place) {
  Eigen::MatrixX3d left(path.size(), 3);
  Eigen::VectorXd right(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Pose2& p = place(path[i]);
    const auto row = static_cast<Eigen::Index>(i);
    left.row(row) << 2 * p.x, 2 * p.y, 1;
    right[row] = p.x * p.x + p.y * p.y;
  }
  const Vec3 s = left.colPivHouseholderQr().solve(right);
  return std::sqrt(s[2] + s[0] * s[0] + s[1] * s[1]);
}

// Every other run to the right.
Circle walkCircle(const ExperimentSettings& settings, int run, Report& report) {
  Circle circle;
  circle.side = run % 2 == 0 ? 1 : -1;
  Trial trial(settings, seedOf(settings, run));
  trial.standUp();
  trial.record(kPlotted);
  const double rate = kSpeed / kRadius;  // [rad/s]
  trial.ask(motion::Move{{kSpeed, 0, circle.side * rate}, {}});
  const double limit = kPatience * 2 * M_PI / rate;  // [s]
  while (!circle.round && !trial.fell() && trial.here().t < limit) {
    trial.wait(trial.model().cycle);
    circle.round = std::abs(trial.here().truth.theta) >= 2 * M_PI;
  }
  circle.fell = trial.fell();
  circle.closure = std::hypot(trial.here().truth.x, trial.here().truth.y);
  circle.path = trial.path();
  circle.radius = fitRadius(circle.path, [](const TrialPoint& p) { return p.truth; });
  circle.odometry_radius = fitRadius(circle.path, [](const TrialPoint& p) { return p.odometry; });
  report.hash = combineHash(report.hash, trial.simulation().hash());
  return circle;
}

Picture plot(const std::vector<Circle>& circles) {
  Panel panel = makePanel("Seen from above", "ahead [m]", "to the side of the circle [m]");
  for (const Circle& circle : circles) {
    Series way{"", {}, {}, Stroke::Line, Ink::Blue};
    for (const TrialPoint& point : circle.path) {
      way.x.push_back(point.truth.x);
      way.y.push_back(circle.side * point.truth.y);
    }
    panel.series.push_back(std::move(way));
  }
  Series wanted{"radius 0.60 m", {}, {}, Stroke::Dashed, Ink::Orange};
  for (int i = 0; i <= 90; ++i) {
    const double angle = i * 2 * M_PI / 90;
    wanted.x.push_back(kRadius * std::sin(angle));
    wanted.y.push_back(kRadius * (1 - std::cos(angle)));
  }
  panel.series.push_back(std::move(wanted));
  panel.series.front().label = "where it was, each run";
  panel.key = "outside";
  return {"A circle, open loop (thesis figure 24)", {panel}, 1, 900, 800};
}

Outcome run(const ExperimentSettings& settings) {
  Outcome outcome;
  Report& report = outcome.report;
  report = startReport("circle", settings);
  std::vector<Circle> circles;
  std::vector<double> radius, closure, odometry;
  double closed = 0, falls = 0;
  for (int i = 0; i < settings.runs; ++i) {
    const Circle circle = walkCircle(settings, i, report);
    radius.push_back(circle.radius);
    closure.push_back(circle.closure);
    odometry.push_back(circle.odometry_radius);
    closed += circle.closed();
    falls += circle.fell;
    circles.push_back(circle);
  }
  TextTable table = makeStatisticsTable("A circle of 0.60 m radius by one velocity command");
  report.figures = {{"closed", closed}, {"runs", static_cast<double>(settings.runs)}};
  addStatistics("radius_m", radius, 3, report, table);
  addStatistics("closure_error_m", closure, 3, report, table);
  addStatistics("odometry_radius_m", odometry, 3, report, table);
  report.figures.push_back({"falls", falls});
  table.lines.push_back({"closed of " + std::to_string(settings.runs), fixed(closed, 0)});
  table.lines.push_back({"falls", fixed(falls, 0)});
  report.tables.push_back(std::move(table));
  report.remarks.push_back(
      "Closed: within 0.20 m of the start when the robot has turned by 360 degrees.");
  outcome.picture = plot(circles);
  return outcome;
}

}  // namespace

Experiment circleExperiment() {
  return makeTrialExperiment("circle", "A circle walked open loop (thesis figure 24).", run);
}

}  // namespace nao::validation
