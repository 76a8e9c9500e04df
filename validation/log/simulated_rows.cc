#include "validation/log/simulated_rows.h"

#include "validation/merge_effects.h"

namespace nao::validation {
namespace {

void addJoints(const RobotModel& robot, const SensorFrame& sensors, const JointCommand& command,
               LogRun& run) {
  for (std::size_t j = 0; j < robot.jointCount(); ++j) {
    const Actuator& actuator = robot.actuators[j];
    if (actuator.coordinates.empty()) continue;
    run.columns["cmd." + actuator.name].push_back(command.angle[j]);
    run.columns["cmd_stiffness." + actuator.name].push_back(command.stiffness[j]);
    run.columns["q." + actuator.name].push_back(sensors.angle[j]);
    run.columns["cur." + actuator.name].push_back(sensors.current[j]);
  }
}

void addBody(const SensorFrame& sensors, LogRun& run) {
  const char* const axes[] = {"x", "y", "z"};
  const double angles[] = {sensors.angle_x, sensors.angle_y, sensors.angle_z};
  for (int i = 0; i < 3; ++i) {
    run.columns[std::string("imu.acc.") + axes[i]].push_back(sensors.accelerometer[i]);
    run.columns[std::string("imu.gyr.") + axes[i]].push_back(sensors.gyroscope[i]);
    run.columns[std::string("imu.ang.") + axes[i]].push_back(angles[i]);
  }
  const char* const cells[] = {"fl", "fr", "rl", "rr"};
  for (std::size_t i = 0; i < 4; ++i) {
    run.columns[std::string("fsr.L.") + cells[i]].push_back(sensors.feet[0].force[i]);
    run.columns[std::string("fsr.R.") + cells[i]].push_back(sensors.feet[1].force[i]);
  }
}

void addTruth(const Pose& X_WT, LogRun& run) {
  const Eigen::Quaterniond q_WT(X_WT.linear());
  run.columns["gt.base.x"].push_back(X_WT.translation().x());
  run.columns["gt.base.y"].push_back(X_WT.translation().y());
  run.columns["gt.base.z"].push_back(X_WT.translation().z());
  run.columns["gt.base.qw"].push_back(q_WT.w());
  run.columns["gt.base.qx"].push_back(q_WT.x());
  run.columns["gt.base.qy"].push_back(q_WT.y());
  run.columns["gt.base.qz"].push_back(q_WT.z());
}

}  // namespace

void addRow(const RobotModel& robot, double t, const SensorFrame& sensors,
            const JointCommand& command, const Pose& X_WT, LogRun& run) {
  run.t.push_back(t);
  addJoints(robot, sensors, command, run);
  addBody(sensors, run);
  addTruth(X_WT, run);
}

LogSet simulatedSet(const RobotModel& robot) {
  LogSet set;
  set.name = "simulated " + robot.name + " on its feet";
  set.source = "simulated";
  set.licence = "as the project";
  set.robot = robot.name;
  set.version = robot.version;
  set.environment.floor = "flat";
  set.clock = {"simulated", "issued", "measured"};
  set.rate = 1 / toSeconds(robot.cycle);
  for (const Actuator& actuator : robot.actuators) {
    if (actuator.coordinates.empty()) continue;
    set.joints.emplace_back();
    set.joints.back().name = actuator.name;
  }
  return set;
}

std::shared_ptr<const RobotModel> withEffects(const RobotModel& robot,
                                              const std::vector<EffectSetting>& extra,
                                              const sim::EffectCatalogue* catalogue) {
  auto changed = std::make_shared<RobotModel>(robot);
  changed->variation.clear();
  changed->effects =
      mergedEffects(robot, extra, catalogue != nullptr ? *catalogue : sim::standardEffects());
  return changed;
}

}  // namespace nao::validation
