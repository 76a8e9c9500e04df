#include "validation/diagnosis/extend/gain.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

#include "core/config.h"
#include "core/files.h"
#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/joint/prepared_set.h"
#include "validation/diagnosis/replay/whole_replay.h"

namespace nao::validation {
namespace {

// An error that grew by more than this part has grown: less is chance. Free choice.
constexpr double kWorse = 1.05;

std::vector<JointReplay> replayHung(const LogSet& set, std::shared_ptr<const RobotModel> model,
                                    const GainOptions& options) {
  const PreparedSet prepared = prepareSet(set, std::move(model), options.jobs);
  std::vector<JointReplay> replays(prepared.joints.size());
  inParallel(replays.size(), options.jobs, [&](std::size_t i) {
    const PreparedJoint& joint = prepared.joints[i];
    replays[i] =
        replayJoint(joint.simulator->exact(), {}, joint.noise, options.runs, {Split::Test});
  });
  return replays;
}

WholeReplay replayTest(const LogSet& set, std::shared_ptr<const RobotModel> model,
                       const GainOptions& options) {
  WholeReplay replay;
  if (!isOnItsFeet(set, *model)) {
    replay.joints = replayHung(set, std::move(model), options);
    return replay;
  }
  WholeOptions whole;
  whole.splits = {Split::Test};
  const WholeSimulator simulator(set, std::move(model), whole);
  return replayWhole(simulator, {}, runsOfEach(simulator, options.runs), options.jobs);
}

void requireSameJoints(const std::vector<JointReplay>& before,
                       const std::vector<JointReplay>& after, const std::string& robot) {
  const auto same = [](const JointReplay& a, const JointReplay& b) { return a.joint == b.joint; };
  if (!std::equal(before.begin(), before.end(), after.begin(), after.end(), same)) {
    throw InputError("--after " + robot + ": expected a robot with the same joints as before");
  }
}

// Over all joints: each counts alike.
double meanOf(const std::vector<JointReplay>& replays, double JointReplay::*error) {
  double sum = 0;
  for (const JointReplay& one : replays) sum += one.*error;
  return sum / static_cast<double>(replays.size());
}

double rootMeanSquare(const std::vector<JointReplay>& replays, double JointReplay::*error) {
  double sum = 0;
  for (const JointReplay& one : replays) sum += one.*error * one.*error;
  return std::sqrt(sum / static_cast<double>(replays.size()));
}

// Adds rows and table to the report. Returns the joints that got worse.
std::vector<std::string> addRows(const std::vector<JointReplay>& before,
                                 const std::vector<JointReplay>& after, Report& report) {
  TextTable table{"Test runs: error of the mean [mrad]",
                  {"joint", "before", "after", "floor", "mean absolute before", "after"},
                  {}};
  std::vector<Row> rows;
  std::vector<std::string> worse;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const JointReplay &a = before[i], &b = after[i];
    rows.push_back({{"joint", a.joint},
                    {"before_mae", a.mae},
                    {"after_mae", b.mae},
                    {"before_rmse", a.rmse},
                    {"after_rmse", b.rmse},
                    {"floor_rmse", a.floor}});
    table.lines.push_back({a.joint, fixed(1e3 * a.rmse, 2), fixed(1e3 * b.rmse, 2),
                           fixed(1e3 * a.floor, 2), fixed(1e3 * a.mae, 2), fixed(1e3 * b.mae, 2)});
    if (b.rmse > kWorse * a.rmse) worse.push_back(a.joint);
  }
  report.figures.push_back({"rows", std::move(rows)});
  report.tables.push_back(std::move(table));
  return worse;
}

// Likewise of the gait's numbers: worse is what is further off by more than repeats are.
std::vector<std::string> addGait(const WholeReplay& before, const WholeReplay& after,
                                 Report& report) {
  if (before.gait.empty()) return {};
  TextTable table{"Test runs: mean of the gait",
                  {"motion", "", "unit", "measured", "before", "after", "floor"},
                  {}};
  std::vector<Row> rows;
  std::vector<std::string> worse;
  for (std::size_t i = 0; i < before.gait.size(); ++i) {
    const GaitReplay &a = before.gait[i], &b = after.gait[i];
    rows.push_back({{"motion", a.motion},
                    {"name", a.name},
                    {"measured", a.measured},
                    {"before", a.measured + a.error},
                    {"after", b.measured + b.error},
                    {"floor", a.floor}});
    table.lines.push_back({a.motion, a.name, a.unit, fixed(a.measured, 4),
                           fixed(a.measured + a.error, 4), fixed(b.measured + b.error, 4),
                           fixed(a.floor, 4)});
    const double grown = std::abs(b.error) - kWorse * std::abs(a.error);
    if (grown > 0 && std::abs(b.error) > a.floor) worse.push_back(a.name + " in " + a.motion);
  }
  report.figures.push_back({"gait", std::move(rows)});
  report.tables.push_back(std::move(table));
  return worse;
}

void addFalls(const WholeReplay& before, const WholeReplay& after, Report& report) {
  if (before.fell + after.fell == 0) return;
  report.remarks.push_back("Of " + std::to_string(before.runs) + " simulated runs " +
                           std::to_string(before.fell) + " fell before, " +
                           std::to_string(after.fell) + " after.");
}

void addWorse(const std::vector<std::string>& worse, Report& report) {
  std::string names;
  for (const std::string& name : worse) names += (names.empty() ? "" : ", ") + name;
  report.remarks.push_back(names.empty() ? "Nothing got worse."
                                         : "Worse than before: " + names + ".");
}

}  // namespace

Report measureGain(const LogSet& set, std::shared_ptr<const RobotModel> before,
                   std::shared_ptr<const RobotModel> after, int openings,
                   const GainOptions& options) {
  Report report;
  report.command = "gain";
  report.robot = after->name;
  report.runs = options.runs;
  const WholeReplay old_replay = replayTest(set, std::move(before), options);
  const WholeReplay new_replay = replayTest(set, std::move(after), options);
  const std::vector<JointReplay>&old_errors = old_replay.joints, &new_errors = new_replay.joints;
  if (old_errors.empty()) throw InputError(set.name + ": no joint was commanded and measured");
  requireSameJoints(old_errors, new_errors, report.robot);
  const double floor = rootMeanSquare(old_errors, &JointReplay::floor);
  const double old_rmse = rootMeanSquare(old_errors, &JointReplay::rmse);
  const double new_rmse = rootMeanSquare(new_errors, &JointReplay::rmse);
  report.figures.push_back({"before_mae", meanOf(old_errors, &JointReplay::mae)});
  report.figures.push_back({"after_mae", meanOf(new_errors, &JointReplay::mae)});
  report.figures.push_back({"before_rmse", old_rmse});
  report.figures.push_back({"after_rmse", new_rmse});
  report.figures.push_back({"floor_rmse", floor});
  report.figures.push_back({"test_openings", static_cast<double>(openings)});
  std::vector<std::string> worse = addRows(old_errors, new_errors, report);
  const std::vector<std::string> gait = addGait(old_replay, new_replay, report);
  worse.insert(worse.end(), gait.begin(), gait.end());
  addWorse(worse, report);
  addFalls(old_replay, new_replay, report);
  report.remarks.push_back("Error " + fixed(1e3 * old_rmse, 2) + " -> " + fixed(1e3 * new_rmse, 2) +
                           " mrad on runs not used for anything else, floor " +
                           fixed(1e3 * floor, 2) + "; they were opened " +
                           std::to_string(openings) + (openings == 1 ? " time." : " times."));
  return report;
}

std::string testOpeningsFile(const std::string& set_folder) {
  return set_folder + "/test_openings.txt";
}

void requireOpenable(const LogSet& set, const std::string& set_folder) {
  requireRuns(set, {Split::Test});
  appendToFile("", testOpeningsFile(set_folder), "");
}

void openTestRuns(const LogSet& set, const std::string& set_folder, const std::string& by) {
  requireRuns(set, {Split::Test});
  appendToFile("", testOpeningsFile(set_folder), by + "\n");
}

int countTestOpenings(const std::string& set_folder) {
  std::ifstream in(testOpeningsFile(set_folder));
  int lines = 0;
  for (std::string line; std::getline(in, line);) ++lines;
  return lines;
}

}  // namespace nao::validation
