#include "validation/walk_recording.h"

#include "core/check.h"
#include "runtime/simulation.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kStanding = 0.25;      // [m] a Nao's torso hangs at 0.28 to 0.34 m when it walks
constexpr Duration kWakingUp = 4000ms;  // from Crouch to StandInit
constexpr Duration kStanceFirst = 500ms;
constexpr Duration kComingToRest = 2000ms;

class Recorder {
 public:
  explicit Recorder(const std::shared_ptr<const RobotModel>& model)
      : simulation_(std::make_shared<WorldModel>(), {{"nao", model, {}}}, 2ms),
        cycle_(model->cycle) {}

  void ask(const motion::MotionAction& action) {
    NAO_CHECK(simulation_.robot(0).ports()->requests.post({++last_id_, action}));
  }
  void wait(Duration time) { simulation_.advanceTo(simulation_.now() + time); }
  void record(Duration time, std::vector<JointCommand>& commands) {
    for (const SimTime end = simulation_.now() + time; simulation_.now() < end;) {
      wait(cycle_);
      commands.push_back(simulation_.robot(0).ports()->state.get()->command);
    }
  }
  JointArray<double> command() { return simulation_.robot(0).ports()->state.get()->command.angle; }
  bool stands() { return allStand(simulation_.world()); }

 private:
  runtime::Simulation simulation_;
  Duration cycle_;
  motion::RequestId last_id_ = 0;
};

}  // namespace

WalkRecording recordWalk(const std::shared_ptr<const RobotModel>& model, Duration walking) {
  Recorder recorder(model);
  WalkRecording recording;
  recorder.ask(motion::WakeUp{});
  recorder.wait(kWakingUp);
  recorder.ask(motion::MoveInit{});
  recorder.wait(kComingToRest);
  recording.start = recorder.command();
  recorder.record(kStanceFirst, recording.commands);
  recorder.ask(motion::MoveToward{1, 0, 0, {}});
  recorder.record(walking, recording.commands);
  recorder.ask(motion::StopMove{});
  recorder.record(kComingToRest, recording.commands);
  if (!recorder.stands()) {
    throw InputError("robot " + model->name + " fell while its walk was recorded");
  }
  return recording;
}

void WalkReplay::restart(sim::World& world) {
  next_ = 0;
  for (std::size_t i = 0; i < world.robotCount(); ++i) {
    world.placeRobot(i, world.robot(i).start, &recording_.start);
  }
}

void WalkReplay::advance(sim::World& world) {
  const Duration cycle = world.robot(0).model->cycle;
  for (std::size_t i = 0; i < world.robotCount(); ++i) {
    world.readSensors(i);
    world.setCommand(i, recording_.commands[next_]);
  }
  ++next_;
  for (const SimTime end = world.now() + cycle; world.now() < end;) world.step();
}

std::vector<sim::RobotSetup> robotsInRows(const std::shared_ptr<const RobotModel>& model,
                                          int count) {
  constexpr int kRow = 6;
  std::vector<sim::RobotSetup> robots;
  for (int i = 0; i < count; ++i) {
    const Pose2 place{-1.5 * (i / kRow), 1.0 * (i % kRow), 0};
    robots.push_back({"nao" + std::to_string(i), model, place});
  }
  return robots;
}

bool allStand(const sim::World& world) {
  for (const SceneFrame::Robot& robot : world.scene().robots) {
    if (!(robot.X_WB[0].translation().z() > kStanding)) return false;
  }
  return true;
}

}  // namespace nao::validation
