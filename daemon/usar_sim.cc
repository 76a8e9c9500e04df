#include "daemon/usar_sim.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "naoqi_api/call_error.h"
#include "runtime/ground_truth.h"

namespace nao::daemon {
namespace {

using rpc::Argument;
using rpc::CallError;

std::vector<float> asList(const Pose2& pose) {
  return {static_cast<float>(pose.x), static_cast<float>(pose.y), static_cast<float>(pose.theta)};
}

double checked(double value, const char* name, double most) {
  if (std::isfinite(value) && std::abs(value) <= most) return value;
  throw CallError("UsarSim: " + std::string(name) + " must be a number up to " +
                  std::to_string(most));
}

constexpr double kFar = 1000;      // [m] the world has no edge, but numbers have
constexpr double kStrong = 10000;  // [N]
constexpr double kLong = 3600;     // [s]
constexpr std::size_t kLongestName = 100;

}  // namespace

UsarSim::UsarSim(RobotLoop& loop, const Latest<SceneFrame>& truth, std::size_t robot, Chance chance)
    : loop_(loop),
      truth_(truth),
      robot_(robot),
      chance_(std::move(chance)),
      next_id_((static_cast<std::uint64_t>(robot) << 48) + 1) {}  // apart from other ports' ids

rpc::Service UsarSim::describe() {
  rpc::Service service("UsarSim",
                       "The simulator itself: the truth, time, and the hand of its user.");
  service.method("robotNames", this, &UsarSim::robotNames, "Names of all robots, in port order.")
      .method("floorPose", this, &UsarSim::floorPose,
              "Where this robot really stands: x, y [m], heading [rad] of the point between its "
              "soles, in the world.")
      .method("floorPose", this, &UsarSim::floorPoseOf, "The same for a robot by its name.",
              Argument{"robot", "One of robotNames()."})
      .method("torsoPose", this, &UsarSim::torsoPose,
              "x, y, z [m], roll, pitch, yaw [rad] of this robot's torso in the world.")
      .method("ballPose", this, &UsarSim::ballPose, "x, y, z [m] of the first ball.")
      .method("time", this, &UsarSim::time, "Simulated time since the start [s].")
      .method("speed", this, &UsarSim::speed, "Wanted simulated seconds per second; inf: maximum.")
      .method("isPaused", this, &UsarSim::isPaused, "Whether time stands.")
      .method("hash", this, &UsarSim::hash,
              "A number of the state of world and robots, equal for equal runs; only while paused.")
      .method("pause", this, &UsarSim::pause, "Stops time.")
      .method("resume", this, &UsarSim::resume, "Lets time go on.")
      .method("step", this, &UsarSim::step, "While paused: some physics steps, then paused again.",
              Argument{"steps", "How many."})
      .method("stepSize", this, &UsarSim::stepSize, "Of one physics step [s].")
      .method("setSpeed", this, &UsarSim::setSpeed, "How fast time goes.",
              Argument{"speed", "Simulated seconds per second; 0 or less: as fast as it goes."})
      .method("reset", this, &UsarSim::reset, "Everything back to how it began; time goes on.")
      .method("push", this, &UsarSim::push, "Pushes this robot's torso.",
              Argument{"x", "Force in the world [N]."}, Argument{"y", "[N]"}, Argument{"z", "[N]"},
              Argument{"duration", "[s]"})
      .method("press", this, &UsarSim::press,
              "A finger on a bumper, tactile sensor or button of this robot.",
              Argument{"sensor",
                       "NaoQi's device name: ChestBoard/Button, Head/Touch/Front, "
                       "LFoot/Bumper/Left, LHand/Touch/Back and so on."},
              Argument{"duration", "[s]"})
      .method("press", this, &UsarSim::pressOn, "The same on a robot by its name.",
              Argument{"robot", "One of robotNames()."}, Argument{"sensor", "As above."},
              Argument{"duration", "[s]"})
      .method("placeRobot", this, &UsarSim::placeRobot,
              "Puts this robot down in its start posture, limp, as after switching it on.",
              Argument{"x", "[m]"}, Argument{"y", "[m]"}, Argument{"theta", "Heading [rad]."})
      .method("placeBall", this, &UsarSim::placeBall, "Puts the first ball down, at rest.",
              Argument{"x", "[m]"}, Argument{"y", "[m]"},
              Argument{"z", "Of its centre [m]; lifted onto the ground if lower."})
      .method("snapshot", this, &UsarSim::snapshot,
              "Keeps the complete present state, motions under way included; up to 64.",
              Argument{"name", "In place of one that had this name."})
      .method("restore", this, &UsarSim::restore,
              "Everything back to a snapshot, time too; it goes on from there to the last bit. "
              "Motion calls that have not ended fail.",
              Argument{"name", "One of snapshots()."})
      .method("dropSnapshot", this, &UsarSim::dropSnapshot, "Forgets a snapshot.",
              Argument{"name", "One of snapshots()."})
      .method("snapshots", this, &UsarSim::snapshots, "Names of the snapshots, sorted.")
      .method("seed", this, &UsarSim::seed, "The run's --seed; 0: no variation.")
      .method("draw", this, &UsarSim::draw,
              "What the seed has drawn for this run, by robot, effect and name.");
  describeTruth(service);
  return service;
}

void UsarSim::deliver(const std::vector<LoopOutcome>& outcomes) {
  for (const LoopOutcome& outcome : outcomes) {
    const auto found = asked_.find(outcome.id);
    if (found == asked_.end()) continue;
    const Pending call = found->second;
    asked_.erase(found);
    outcome.error.empty() ? call.resolve() : call.fail("UsarSim: " + outcome.error);
  }
}

UsarSim::Pending UsarSim::ask(decltype(LoopRequest::action) action) {
  const std::uint64_t id = next_id_++;
  if (!loop_.post({id, std::move(action)}))
    throw CallError("UsarSim: busy, too many requests wait");
  return asked_[id];
}

std::vector<std::string> UsarSim::robotNames() const {
  std::vector<std::string> names;
  const auto scene = truth_.get();
  for (const SceneFrame::Robot& robot : scene->robots) names.push_back(robot.name);
  return names;
}

std::size_t UsarSim::findIndex(const std::string& name, const SceneFrame& scene) const {
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    if (scene.robots[i].name == name) return i;
  }
  throw CallError("UsarSim: there is no robot " + name);
}

const SceneFrame::Robot& UsarSim::find(const std::string& name, const SceneFrame& scene) const {
  return scene.robots[findIndex(name, scene)];
}

std::vector<float> UsarSim::floorPose() const {
  const auto scene = truth_.get();
  const SceneFrame::Robot& robot = scene->robots[robot_];
  return asList(runtime::calcFloorPose(*robot.model, robot.X_WB));
}

std::vector<float> UsarSim::floorPoseOf(const std::string& name) const {
  const auto scene = truth_.get();
  const SceneFrame::Robot& robot = find(name, *scene);
  return asList(runtime::calcFloorPose(*robot.model, robot.X_WB));
}

std::vector<float> UsarSim::torsoPose() const {
  const auto scene = truth_.get();
  const Pose& X_WT = scene->robots[robot_].X_WB.front();
  std::vector<float> out;
  for (const double p : X_WT.translation()) out.push_back(static_cast<float>(p));
  for (const double angle : rpyOf(X_WT.linear())) out.push_back(static_cast<float>(angle));
  return out;
}

std::vector<float> UsarSim::ballPose() const {
  const auto scene = truth_.get();
  if (scene->balls.empty()) throw CallError("UsarSim: this world has no ball");
  const Vec3& p = scene->balls.front().p_W;
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

double UsarSim::time() const { return toSeconds(loop_.state().get()->time); }
float UsarSim::speed() const { return static_cast<float>(loop_.state().get()->speed); }
bool UsarSim::isPaused() const { return loop_.state().get()->paused; }

std::string UsarSim::hash() const {
  const auto state = loop_.state().get();
  if (!state->paused) throw CallError("UsarSim: pause the world first");
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(state->hash));
  return text;
}

UsarSim::Pending UsarSim::snapshot(const std::string& name) {
  if (name.empty() || name.size() > kLongestName) {
    throw CallError("UsarSim: a snapshot's name has 1 to " + std::to_string(kLongestName) +
                    " characters");
  }
  return ask(runtime::WorldRequest(runtime::TakeSnapshot{name}));
}

UsarSim::Pending UsarSim::restore(const std::string& name) {
  return ask(runtime::WorldRequest(runtime::RestoreSnapshot{name}));
}

UsarSim::Pending UsarSim::dropSnapshot(const std::string& name) {
  return ask(runtime::WorldRequest(runtime::DropSnapshot{name}));
}

UsarSim::Pending UsarSim::pause() { return ask(PauseWorld{}); }
UsarSim::Pending UsarSim::resume() { return ask(ResumeWorld{}); }
UsarSim::Pending UsarSim::step(std::int64_t steps) { return ask(StepWorld{steps}); }

UsarSim::Pending UsarSim::setSpeed(double speed) {
  if (std::isnan(speed)) throw CallError("UsarSim: speed must be a number");
  return ask(SetSpeed{speed > 0 ? speed : std::numeric_limits<double>::infinity()});
}

UsarSim::Pending UsarSim::reset() { return ask(runtime::WorldRequest(runtime::ResetWorld{})); }

UsarSim::Pending UsarSim::push(double x, double y, double z, double duration) {
  const Vec3 force(checked(x, "x", kStrong), checked(y, "y", kStrong), checked(z, "z", kStrong));
  return ask(runtime::WorldRequest(
      runtime::PushRobot{robot_, force, fromSeconds(checked(duration, "duration", kLong))}));
}

UsarSim::Pending UsarSim::press(const std::string& sensor, double duration) {
  return pressSensor(robot_, sensor, duration);
}

UsarSim::Pending UsarSim::pressOn(const std::string& robot, const std::string& sensor,
                                  double duration) {
  return pressSensor(findIndex(robot, *truth_.get()), sensor, duration);
}

UsarSim::Pending UsarSim::pressSensor(std::size_t robot, const std::string& sensor,
                                      double duration) {
  return ask(runtime::WorldRequest(
      runtime::PressSensor{robot, sensor, fromSeconds(checked(duration, "duration", kLong))}));
}

UsarSim::Pending UsarSim::placeRobot(double x, double y, double theta) {
  const Pose2 pose{checked(x, "x", kFar), checked(y, "y", kFar), checked(theta, "theta", 100)};
  return ask(runtime::WorldRequest(runtime::PlaceRobot{robot_, pose}));
}

UsarSim::Pending UsarSim::placeBall(double x, double y, double z) {
  const Vec3 p(checked(x, "x", kFar), checked(y, "y", kFar), checked(z, "z", kFar));
  return ask(runtime::WorldRequest(runtime::PlaceBall{0, p, Vec3::Zero()}));
}

}  // namespace nao::daemon
