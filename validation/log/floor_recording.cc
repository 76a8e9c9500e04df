#include "validation/log/floor_recording.h"

#include "core/check.h"
#include "core/random.h"
#include "core/world_model.h"
#include "runtime/simulation.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;

constexpr Duration kWakingUp = 5000ms;  // from Crouch to StandInit, and to rest
constexpr double kKeyStep = 0.02;       // [s] between keys of a motion
// [s] of rest in a run before its motion: what a replay starts from. Free choice.
constexpr double kRestBefore = 0.3;

class FloorRun {
 public:
  FloorRun(const FloorPlan& plan, const std::shared_ptr<const RobotModel>& robot,
           std::uint64_t seed)
      : robot_(*robot),
        simulation_(std::make_shared<WorldModel>(), {{robot->name, robot, {}}},
                    optionsOf(plan, seed)) {}

  void record(const FloorMotion& motion, LogRun& run) {
    ask(motion::WakeUp{});
    ask(motion::SetFallManager{false});
    simulation_.advanceTo(SimTime(kWakingUp));
    const SimTime begin = simulation_.now();
    watch(begin, kRestBefore, run);
    ask(actionOf(motion));
    watch(begin, kRestBefore + motion.duration, run);
  }

 private:
  static sim::WorldOptions optionsOf(const FloorPlan& plan, std::uint64_t seed) {
    sim::WorldOptions options(plan.step);
    options.seed = seed;
    return options;
  }

  void ask(const motion::MotionAction& action) {
    NAO_CHECK(simulation_.robot(0).ports()->requests.post({++last_id_, action}));
  }

  void watch(SimTime begin, double until, LogRun& run) {
    while (toSeconds(simulation_.now() - begin) < until) {
      simulation_.advanceTo(simulation_.now() + robot_.cycle);
      run.t.push_back(toSeconds(simulation_.now() - begin));
      writeJoints(run);
      writeBody(run);
      writeTruth(run);
    }
  }

  motion::MotionAction actionOf(const FloorMotion& motion) const {
    if (motion.walk) return motion::MoveTo{*motion.walk, {}, {}};
    motion::Interpolate request;
    for (std::size_t j = 0; j < robot_.jointCount(); ++j) {
      request.curves.push_back({toJoint(j), {}});
    }
    for (double t = kKeyStep; t < motion.duration; t += kKeyStep) {
      const JointArray<double> angles = calcFloorAngles(robot_, motion, t);
      for (std::size_t j = 0; j < robot_.jointCount(); ++j) {
        request.curves[j].keys.push_back({t, angles[j], {}, {}});
      }
    }
    return request;
  }

  void writeJoints(LogRun& run) {
    const auto state = simulation_.robot(0).ports()->state.get();
    const auto sensors = simulation_.robot(0).ports()->sensors.get();
    for (std::size_t j = 0; j < robot_.jointCount(); ++j) {
      const Actuator& actuator = robot_.actuators[j];
      if (actuator.coordinates.empty()) continue;
      run.columns["cmd." + actuator.name].push_back(state->command.angle[j]);
      run.columns["cmd_stiffness." + actuator.name].push_back(state->command.stiffness[j]);
      run.columns["q." + actuator.name].push_back(sensors->angle[j]);
      run.columns["cur." + actuator.name].push_back(sensors->current[j]);
    }
  }

  void writeBody(LogRun& run) {
    const auto sensors = simulation_.robot(0).ports()->sensors.get();
    const char* const axes[] = {"x", "y", "z"};
    const double angles[] = {sensors->angle_x, sensors->angle_y, sensors->angle_z};
    for (int i = 0; i < 3; ++i) {
      run.columns[std::string("imu.acc.") + axes[i]].push_back(sensors->accelerometer[i]);
      run.columns[std::string("imu.gyr.") + axes[i]].push_back(sensors->gyroscope[i]);
      run.columns[std::string("imu.ang.") + axes[i]].push_back(angles[i]);
    }
    const char* const cells[] = {"fl", "fr", "rl", "rr"};
    for (std::size_t i = 0; i < 4; ++i) {
      run.columns[std::string("fsr.L.") + cells[i]].push_back(sensors->feet[0].force[i]);
      run.columns[std::string("fsr.R.") + cells[i]].push_back(sensors->feet[1].force[i]);
    }
  }

  void writeTruth(LogRun& run) {
    const Pose X_WT = simulation_.world().scene().robots[0].X_WB[0];
    const Eigen::Quaterniond q_WT(X_WT.linear());
    run.columns["gt.base.x"].push_back(X_WT.translation().x());
    run.columns["gt.base.y"].push_back(X_WT.translation().y());
    run.columns["gt.base.z"].push_back(X_WT.translation().z());
    run.columns["gt.base.qw"].push_back(q_WT.w());
    run.columns["gt.base.qx"].push_back(q_WT.x());
    run.columns["gt.base.qy"].push_back(q_WT.y());
    run.columns["gt.base.qz"].push_back(q_WT.z());
  }

  const RobotModel& robot_;
  runtime::Simulation simulation_;
  motion::RequestId last_id_ = 0;
};

std::shared_ptr<const RobotModel> withEffects(const FloorPlan& plan) {
  auto robot = std::make_shared<RobotModel>(*plan.model);
  robot->variation.clear();
  robot->effects.insert(robot->effects.end(), plan.extra.begin(), plan.extra.end());
  return robot;
}

}  // namespace

LogSet recordOnFloor(const FloorPlan& plan) {
  const auto robot = withEffects(plan);
  LogSet set;
  set.name = "simulated " + robot->name + " on its feet";
  set.source = "simulated";
  set.licence = "as the project";
  set.robot = robot->name;
  set.version = robot->version;
  set.environment.floor = "flat";
  set.clock = {"simulated", "issued", "measured"};
  set.rate = 1 / toSeconds(robot->cycle);
  for (const Actuator& actuator : robot->actuators) {
    if (actuator.coordinates.empty()) continue;
    set.joints.emplace_back();
    set.joints.back().name = actuator.name;
  }
  for (const FloorMotion& motion : plan.motions) {
    for (int repeat = 0; repeat < plan.repeats; ++repeat) {
      LogRun& run = set.runs.emplace_back();
      const std::string name = motion.name + "_" + std::to_string(repeat);
      run.motion = motion.name;
      run.file = "run_" + name + ".csv";
      run.repeat = repeat;
      run.split = motion.split;
      run.robot_id = robot->name;
      run.start_pose = "StandInit";
      Random random(plan.seed, "floor/" + name);
      const auto seed = 1 + static_cast<std::uint64_t>(random.uniform() * 1e15);
      FloorRun(plan, robot, seed).record(motion, run);
    }
  }
  return set;
}

}  // namespace nao::validation
