#include "validation/diagnosis/extend/replay_set.h"

#include <algorithm>

#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/joint/prepared_set.h"
#include "validation/diagnosis/replay/whole_replay.h"

namespace nao::validation {
namespace {

Row rowOf(const JointReplay& replay, double real_sd, double nominal_sd) {
  return {{"joint", replay.joint},
          {"rmse_rad", replay.rmse},
          {"floor_rad", replay.floor},
          {"misfit", replay.misfit},
          {"unexplained_share", replay.share},
          {"noise_free_rmse_rad", replay.noise_free_rmse},
          {"real_sd_rad", real_sd},
          {"nominal_sd_rad", nominal_sd}};
}

Row rowOf(const PreparedJoint& joint, const JointReplay& replay) {
  Row row = rowOf(replay, joint.moments.measured.sd, joint.moments.simulated.sd);
  row.insert(row.end(), {{"fitted_sd_rad", replay.simulated_sd},
                         {"fitted_torque_sd_nm", joint.noise.torque_sd},
                         {"fitted_torque_time_s", joint.noise.torque_time},
                         {"fitted_start_sd_s", joint.noise.start_sd},
                         {"fitted_jitter_rad", joint.noise.jitter}});
  return row;
}

std::vector<std::string> lineOf(const PreparedJoint& joint, const JointReplay& replay) {
  return {replay.joint,
          fixed(1e3 * replay.rmse, 2),
          fixed(1e3 * replay.floor, 2),
          fixed(replay.misfit, 2),
          fixed(100 * replay.share, 0),
          fixed(1e3 * joint.moments.measured.sd, 2),
          fixed(1e3 * joint.moments.simulated.sd, 2),
          fixed(1e3 * replay.simulated_sd, 2),
          fixed(joint.noise.torque_sd, 3),
          fixed(1e3 * joint.noise.start_sd, 2)};
}

void addMisfits(const std::vector<JointReplay>& replays, Report& report) {
  double largest = 0, sum = 0;
  for (const JointReplay& replay : replays) {
    largest = std::max(largest, replay.misfit);
    sum += replay.misfit;
  }
  report.figures.push_back({"misfit_max", largest});
  const auto count = static_cast<double>(std::max<std::size_t>(1, replays.size()));
  report.figures.push_back({"misfit_mean", sum / count});
  report.remarks.push_back(
      "misfit: error of the means over what the spreads of both explain; 1 is a perfect model.");
}

void addGait(const WholeReplay& replay, Report& report) {
  TextTable table{
      "Mean of the gait", {"motion", "for", "", "unit", "measured", "simulated", "floor"}, {}};
  std::vector<Row> rows;
  for (const GaitReplay& one : replay.gait) {
    rows.push_back({{"motion", one.motion},
                    {"split", one.split},
                    {"name", one.name},
                    {"measured", one.measured},
                    {"simulated", one.measured + one.error},
                    {"floor", one.floor}});
    table.lines.push_back({one.motion, one.split, one.name, one.unit, fixed(one.measured, 4),
                           fixed(one.measured + one.error, 4), fixed(one.floor, 4)});
  }
  report.figures.push_back({"gait", std::move(rows)});
  report.tables.push_back(std::move(table));
}

// Of a robot on its feet.
Report replayWholeSet(const LogSet& set, std::shared_ptr<const RobotModel> model,
                      const ReplayOptions& options) {
  Report report;
  report.command = "replay";
  report.robot = model->name;
  const WholeSimulator simulator(set, std::move(model));
  const WholeReplay replay =
      replayWhole(simulator, {}, runsOfEach(simulator, options.runs), options.jobs);
  report.runs = replay.runs;
  report.step_s = toSeconds(simulator.step(Pace::Exact));
  TextTable table{
      "Measured against simulated: mean of repeats, and their spread",
      {"joint", "error [mrad]", "floor", "misfit", "unexplained [%]", "SD real", "SD nominal"},
      {}};
  std::vector<Row> rows;
  for (const JointReplay& one : replay.joints) {
    rows.push_back(rowOf(one, one.real_sd, one.simulated_sd));
    table.lines.push_back({one.joint, fixed(1e3 * one.rmse, 2), fixed(1e3 * one.floor, 2),
                           fixed(one.misfit, 2), fixed(100 * one.share, 0),
                           fixed(1e3 * one.real_sd, 2), fixed(1e3 * one.simulated_sd, 2)});
  }
  report.figures.push_back({"rows", std::move(rows)});
  report.tables.push_back(std::move(table));
  addGait(replay, report);
  addMisfits(replay.joints, report);
  if (replay.fell > 0) {
    report.remarks.push_back(std::to_string(replay.fell) + " of " + std::to_string(replay.runs) +
                             " simulated runs fell.");
  }
  return report;
}

}  // namespace

Report replaySet(const LogSet& set, std::shared_ptr<const RobotModel> model,
                 const ReplayOptions& options) {
  requireRuns(set, {Split::Fit, Split::Select});
  if (isOnItsFeet(set, *model)) {
    return replayWholeSet(set, std::move(model), options);
  }
  const std::string robot = model->name;
  const PreparedSet prepared = prepareSet(set, std::move(model), options.jobs);
  std::vector<JointReplay> replays(prepared.joints.size());
  inParallel(replays.size(), options.jobs, [&](std::size_t i) {
    const PreparedJoint& joint = prepared.joints[i];
    replays[i] =
        replayJoint(*joint.simulator, {}, joint.noise, options.runs, {Split::Fit, Split::Select});
  });
  Report report;
  report.command = "replay";
  report.robot = robot;
  report.runs = options.runs;
  report.step_s = toSeconds(prepared.set->rigStep());
  TextTable table{"Measured against simulated: mean of repeats, and their spread",
                  {"joint", "error [mrad]", "floor", "misfit", "unexplained [%]", "SD real",
                   "SD nominal", "SD fitted", "torque [N m]", "start [ms]"},
                  {}};
  std::vector<Row> rows;
  for (std::size_t i = 0; i < replays.size(); ++i) {
    rows.push_back(rowOf(prepared.joints[i], replays[i]));
    table.lines.push_back(lineOf(prepared.joints[i], replays[i]));
  }
  report.figures.push_back({"rows", rows});
  report.tables.push_back(std::move(table));
  addMisfits(replays, report);
  return report;
}

}  // namespace nao::validation
