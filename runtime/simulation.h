#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "camera/render_queue.h"
#include "core/latest.h"
#include "core/scene_frame.h"
#include "runtime/robot.h"
#include "runtime/simulation_watcher.h"
#include "runtime/world_request.h"
#include "sim/world.h"

namespace nao::runtime {

/// A world and its robots, advanced together. No threads, no network: the daemon, tests and
/// experiments all call advanceTo(). Belongs to one thread; other threads hold the robots' ports
/// and truth().
class Simulation {
 public:
  Simulation(std::shared_ptr<const WorldModel> world, const std::vector<sim::RobotSetup>& robots,
             sim::WorldOptions options);

  SimTime now() const { return world_.now(); }
  Duration stepSize() const { return world_.stepSize(); }
  std::size_t robotCount() const { return robots_.size(); }
  Robot& robot(std::size_t i) { return *robots_[i]; }
  const std::string& robotName(std::size_t i) const { return world_.robot(i).name; }
  sim::World& world() { return world_; }

  /// Moves on to `time`. Per step, in robot order: every robot whose cycle is due takes its frame,
  /// ticks, and hands in its command; then the world moves.
  void advanceTo(SimTime time);

  /// Takes requests over without moving time, as while paused.
  void acceptRequests();

  /// A complete state, motions, walk and cameras included. Immutable; any thread may keep or drop
  /// it.
  struct Snapshot {
    std::shared_ptr<const sim::World::Snapshot> world;
    std::vector<Robot::Snapshot> robots;
    std::vector<std::shared_ptr<const camera::RenderQueue::Moment>> pictures;  // by showTo()
  };
  std::shared_ptr<const Snapshot> snapshot() const;

  /// Goes back to a state of this simulation or of one made alike, time too, and goes on from there
  /// to the last bit as that one did. Requests that have not ended fail; clients see again the
  /// pictures of that moment.
  void restore(const Snapshot& snapshot);

  /// A number that two runs share only if world and robots are in the same state to the last bit.
  std::uint64_t hash() const;

  /// How many snapshots a simulation keeps by name.
  static constexpr std::size_t kMostSnapshots = 64;
  std::vector<std::string> snapshotNames() const;

  /// @throws InputError for a robot, ball or snapshot that does not exist, and for a snapshot too
  /// many.
  void apply(const WorldRequest& request);

  /// From now on the pictures due for a robot's cameras are offered to `queue`.
  void showTo(std::shared_ptr<camera::RenderQueue> queue, std::size_t robot);

  /// Before the first advanceTo(): told at every cycle of a robot, before the world moves on, what
  /// it senses and what its motors follow now. Called on the simulation's thread; must not block.
  using Told = std::function<void(const SensorFrame& frame, const JointCommand& command)>;
  void tellCycles(std::size_t robot, Told told) { told_.at(robot) = std::move(told); }

  /// Before the first advanceTo(): has a watcher, which outlives it, look on. What is done to
  /// world() itself or by restore() no watcher hears of: those who want a run recorded use apply().
  void watch(SimulationWatcher& watcher);

  /// Where everything really is, once per cycle of the first robot. For UsarSim, never for NaoQi.
  const Latest<SceneFrame>& truth() const { return truth_; }

 private:
  void tickDueRobots();
  void lightLeds(std::size_t robot);
  void tell(const Input& input);
  void carryOut(const WorldRequest& request);
  void offerPictures();
  void reset();
  void checkJoint(std::size_t robot, Joint joint) const;
  void keepSnapshot(const std::string& name);
  const std::shared_ptr<const Snapshot>& findSnapshot(const std::string& name) const;

  struct Eyes {
    std::shared_ptr<camera::RenderQueue> queue;
    std::size_t robot = 0;
  };

  sim::World world_;
  std::vector<std::unique_ptr<Robot>> robots_;
  std::vector<Eyes> eyes_;
  std::vector<Told> told_;  // by robot; empty: nobody asked
  std::vector<SimulationWatcher*> watchers_;
  Latest<SceneFrame> truth_;
  std::map<std::string, std::shared_ptr<const Snapshot>> snapshots_;
};

}  // namespace nao::runtime
