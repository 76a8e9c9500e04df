#include "validation/log/floor_recording.h"

#include "core/check.h"
#include "core/random.h"
#include "core/world_model.h"
#include "runtime/simulation.h"
#include "validation/log/simulated_rows.h"

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
      : plan_(plan),
        robot_(*robot),
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
    options.effects = plan.effects;
    options.any_step = true;
    return options;
  }

  void ask(const motion::MotionAction& action) {
    NAO_CHECK(simulation_.robot(0).ports()->requests.post({++last_id_, action}));
  }

  void watch(SimTime begin, double until, LogRun& run) {
    while (toSeconds(simulation_.now() - begin) < until) {
      simulation_.advanceTo(simulation_.now() + robot_.cycle);
      const motion::RobotPorts& ports = *simulation_.robot(0).ports();
      addRow(robot_, toSeconds(simulation_.now() - begin), *ports.sensors.get(),
             ports.state.get()->command, simulation_.world().scene().robots[0].X_WB[0], run);
    }
  }

  motion::MotionAction actionOf(const FloorMotion& motion) const {
    const auto other = plan_.actions.find(motion.name);
    if (other != plan_.actions.end()) return other->second;
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

  const FloorPlan& plan_;
  const RobotModel& robot_;
  runtime::Simulation simulation_;
  motion::RequestId last_id_ = 0;
};

}  // namespace

LogSet recordOnFloor(const FloorPlan& plan) {
  const auto robot = withEffects(*plan.model, plan.extra, plan.effects);
  LogSet set = simulatedSet(*robot);
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
