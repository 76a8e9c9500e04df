#include "validation/recorded/run_log.h"

#include "core/check.h"
#include "core/files.h"
#include "validation/log/robot_log_files.h"
#include "validation/log/simulated_rows.h"

namespace nao::validation {

RunLog::RunLog(runtime::Replayer& replayer, std::size_t robot, Stretch stretch)
    : replayer_(replayer), robot_(robot), stretch_(stretch) {
  replayer.simulation().tellCycles(
      robot, [this](const auto& sensors, const auto& command) { add(sensors, command); });
}

void RunLog::add(const SensorFrame& sensors, const JointCommand& command) {
  const Duration now = replayer_.elapsed();
  if (now < stretch_.from || now > stretch_.to) return;
  const Pose X_WT = replayer_.simulation().world().scene().robots[robot_].X_WB[0];
  addRow(replayer_.simulation().robot(robot_).model(), toSeconds(now), sensors, command, X_WT,
         run_);
}

LogSet RunLog::set(const std::string& source) const {
  const RobotModel& robot = replayer_.simulation().robot(robot_).model();
  LogSet set = simulatedSet(robot);
  set.name = "recorded run of " + replayer_.simulation().robotName(robot_);
  set.source = source;
  LogRun& run = set.runs.emplace_back(run_);
  for (double& time : run.t) time -= run_.t.front();  // a run's times count from its begin
  run.motion = "run";
  run.file = "run.csv";
  run.robot_id = replayer_.simulation().robotName(robot_);
  run.start_pose = robot.start_posture;
  return set;
}

void writeRows(const LogRun& run, const std::string& file) { writeFile("", file, formatRows(run)); }

}  // namespace nao::validation
