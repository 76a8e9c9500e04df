// Thesis section 5.2.1, table 1. A block falls; what it should have fallen without damping in
// 9.81 m/s^2 over what it fell is the "correction". The thesis' columns are those expected
// distances (its rows with damping only fit so), in Unreal units of 4 mm.
#include <array>
#include <cmath>

#include "validation/block.h"
#include "validation/experiment.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kEarth = 9.81;          // [m/s^2] -2452.5 uu at 250 uu a metre
constexpr double kUnrealDefault = 4.16;  // [m/s^2] -520 uu, rigid body gravity scale 2
constexpr std::size_t kDistances = 6;
using Distances = std::array<double, kDistances>;
constexpr Distances kDistance_uu{1024, 2048, 4096, 8192, 16384, 32768};
constexpr double kUnrealPerMetre = 250;

struct Setting {
  const char* name;
  double gravity;  // [m/s^2]
  double damping;  // [1/s]
  Distances thesis;
};
constexpr std::array<Setting, 4> kSettings{
    {{"4.16 m/s², damping 0.1", kUnrealDefault, 0.1, {2.44, 2.46, 2.50, 2.56, 2.65, 2.78}},
     {"4.16 m/s², damping 0", kUnrealDefault, 0, {2.36, 2.36, 2.36, 2.36, 2.37, 2.37}},
     {"9.81 m/s², damping 0.1", kEarth, 0.1, {1.06, 1.06, 1.08, 1.10, 1.13, 1.19}},
     {"9.81 m/s², damping 0", kEarth, 0, {1.03, 1.02, 1.01, 1.01, 1.01, 1.00}}}};

struct Method {
  const char* name;
  sim::Mode mode;
  Duration step;
};

// When a block should have fallen so far, to the nearest 10 ms: a multiple of every step.
Duration fallTime(double distance_uu) {
  const double t = std::sqrt(2 * distance_uu / kUnrealPerMetre / kEarth);
  return 10ms * std::llround(t / 0.01);
}

double expectedDistance(Duration time) {
  const double t = toSeconds(time);
  return kEarth / 2 * t * t;
}

// z'' = g - c z' from rest; for small c t its series, since the closed form cancels.
double exactDistance(const Setting& s, Duration time) {
  const double t = toSeconds(time);
  const double x = s.damping * t;
  if (x < 1e-3) return s.gravity * t * t * (0.5 - x / 6 + x * x / 24);
  return s.gravity / s.damping * (t + std::expm1(-x) / s.damping);
}

struct Fall {
  Distances measured{};  // [m]
  std::uint64_t hash = 0;
};

Fall dropBlock(const Setting& setting, const Method& method) {
  auto world = std::make_shared<WorldModel>();
  world->gravity = setting.gravity;
  sim::WorldOptions options(method.step);
  options.mode = method.mode;
  sim::World sim(world, {{"block", fallingBlock(setting.damping), {}}}, options);
  const auto height = [&] { return sim.scene().robots[0].X_WB[0].translation().z(); };
  const double start = height();
  Fall fall;
  for (std::size_t i = 0; i < kDistances; ++i) {
    while (sim.now().time_since_epoch() < fallTime(kDistance_uu[i])) sim.step();
    fall.measured[i] = start - height();
  }
  fall.hash = sim.hash();
  return fall;
}

class Gravity {
 public:
  explicit Gravity(const ExperimentSettings& settings) {
    outcome_.report = startReport("gravity", settings);
    outcome_.report.robot = "block";
    const Method rk4{"rk4", sim::Mode::Rk4, settings.step};
    const Method reference{"reference", sim::Mode::Reference, settings.step};
    for (const Method& method : {rk4, reference}) runTrue(method);
    for (const Duration step : {1ms, 2ms, 5ms}) {
      runImplicit({"implicit", sim::Mode::Implicit, step});
    }
    finish();
  }
  Outcome take() { return std::move(outcome_); }

 private:
  Fall drop(const Setting& setting, const Method& method) {
    const Fall fall = dropBlock(setting, method);
    outcome_.report.hash = combineHash(outcome_.report.hash, fall.hash);
    return fall;
  }

  void addRow(const Setting& s, const Method& m, const std::vector<double>& corrections,
              const std::vector<double>& errors) {
    rows_.push_back({{"mode", std::string(m.name)},
                     {"step_s", toSeconds(m.step)},
                     {"gravity_m_per_s2", s.gravity},
                     {"linear_damping_per_s", s.damping},
                     {"distance_uu", std::vector<double>(kDistance_uu.begin(), kDistance_uu.end())},
                     {"correction", corrections},
                     {"closed_form_error", errors},
                     {"thesis_correction", std::vector<double>(s.thesis.begin(), s.thesis.end())}});
  }

  // Runs one row of the table; returns its largest relative distance from the closed form.
  double runRow(const Setting& setting, const Method& method, std::vector<double>& corrections) {
    const Fall fall = drop(setting, method);
    std::vector<double> errors;
    double largest = 0;
    for (std::size_t i = 0; i < kDistances; ++i) {
      const Duration t = fallTime(kDistance_uu[i]);
      corrections.push_back(expectedDistance(t) / fall.measured[i]);
      errors.push_back(exactDistance(setting, t) / fall.measured[i] - 1);
      largest = std::max(largest, std::abs(errors.back()));
    }
    addRow(setting, method, corrections, errors);
    return largest;
  }

  void runTrue(const Method& method) {
    for (const Setting& setting : kSettings) {
      std::vector<double> corrections;
      const double error = runRow(setting, method, corrections);
      double& worst = setting.damping > 0 ? worst_damped_ : worst_;
      worst = std::max(worst, error);
      if (method.mode == sim::Mode::Rk4) addLines(setting, corrections);
    }
  }

  void addLines(const Setting& setting, const std::vector<double>& corrections) {
    std::vector<std::string> ours{setting.name, "ours"};
    std::vector<std::string> thesis{"", "thesis"};
    for (std::size_t i = 0; i < kDistances; ++i) {
      ours.push_back(fixed(corrections[i], 6));
      thesis.push_back(fixed(setting.thesis[i], 2));
    }
    table_.push_back(std::move(ours));
    table_.push_back(std::move(thesis));
    corrections_.push_back(corrections);
  }

  void runImplicit(const Method& method) {
    std::vector<double> corrections;
    const double error = runRow(kSettings.back(), method, corrections);
    std::vector<std::string> line{fixed(toSeconds(method.step) * 1e3, 0) + " ms"};
    for (const double correction : corrections) line.push_back(fixed(correction, 6));
    implicit_table_.push_back(std::move(line));
    implicit_x_.push_back(toSeconds(method.step) * 1e3);
    implicit_error_.push_back(error);
  }

  void finish();
  void plot();

  Outcome outcome_;
  std::vector<Row> rows_;
  std::vector<std::vector<std::string>> table_, implicit_table_;
  std::vector<std::vector<double>> corrections_;  // of the table's four rows
  std::vector<double> implicit_x_, implicit_error_;
  double worst_ = 0;
  double worst_damped_ = 0;
};

std::vector<std::string> withDistances(std::vector<std::string> head) {
  for (const double d : kDistance_uu) head.push_back(fixed(d, 0));
  return head;
}

void Gravity::finish() {
  Report& report = outcome_.report;
  report.tables.push_back(
      {"Correction = expected / measured distance, by expected distance "
       "[uu, 250 to the metre]; rk4 (thesis: table 1)",
       withDistances({"gravity, linear damping [1/s]", ""}), table_});
  report.tables.push_back(
      {"The same in implicit steps, 9.81 m/s² without damping: falls with the "
       "step (first order)",
       withDistances({"step"}), implicit_table_});
  report.figures = {
      {"correction_max_error", worst_},           {"damped_correction_max_error", worst_damped_},
      {"implicit_error_1ms", implicit_error_[0]}, {"implicit_error_2ms", implicit_error_[1]},
      {"implicit_error_5ms", implicit_error_[2]}, {"rows", std::move(rows_)}};
  char text[200];
  std::snprintf(text, sizeof text,
                "rk4 and reference: largest relative error against the closed form %.1e undamped, "
                "%.1e damped.",
                worst_, worst_damped_);
  report.remarks.push_back(text);
  report.remarks.push_back(
      "The thesis' 1.03 at short falls came from its timer; we measure in simulated time.");
  plot();
}

void Gravity::plot() {
  const Ink inks[] = {Ink::Blue, Ink::Green, Ink::Vermilion, Ink::Black};
  Panel table;
  table.title = "A falling block: ours (lines) and the thesis (circles)";
  table.x_label = "expected distance [uu]";
  table.y_label = "correction: expected / measured";
  table.log_x = true;
  table.x_ticks.assign(kDistance_uu.begin(), kDistance_uu.end());
  table.key = "outside";
  for (std::size_t i = 0; i < kSettings.size(); ++i) {
    const std::vector<double> x(kDistance_uu.begin(), kDistance_uu.end());
    const Distances& thesis = kSettings[i].thesis;
    table.series.push_back({kSettings[i].name, x, corrections_[i], Stroke::LinePoints, inks[i]});
    table.series.push_back({i + 1 == kSettings.size() ? "thesis, table 1" : "",
                            x,
                            {thesis.begin(), thesis.end()},
                            Stroke::Points,
                            Ink::Thesis});
  }
  Panel order;
  order.title = "Implicit steps: the error falls with the step";
  order.x_label = "step [ms]";
  order.y_label = "largest relative error";
  order.log_x = order.log_y = true;
  order.x_ticks = implicit_x_;
  order.key = "top left";
  std::vector<double> slope;
  for (const double step : implicit_x_) slope.push_back(implicit_error_[0] * step);
  order.series = {{"implicit", implicit_x_, implicit_error_, Stroke::LinePoints, Ink::Blue},
                  {"in proportion to the step", implicit_x_, slope, Stroke::Dashed, Ink::Orange}};
  outcome_.picture = {"Gravity (thesis section 5.2.1)", {table, order}, 1, 900, 900};
}

}  // namespace

Experiment gravityExperiment() {
  Experiment e;
  e.name = "gravity";
  e.summary = "Drops a block: measured against expected distance (thesis table 1).";
  e.choices = {Choice::Step};
  e.run = [](const ExperimentSettings& settings) { return Gravity(settings).take(); };
  return e;
}

}  // namespace nao::validation
