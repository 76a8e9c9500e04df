#include "runtime/simulation.h"

#include "core/check.h"
#include "core/overloaded.h"

namespace nao::runtime {
namespace {

void checkIndex(std::size_t index, std::size_t count, const char* what) {
  if (index < count) return;
  throw InputError(std::string("there is no ") + what + " " + std::to_string(index) +
                   ", expected 0 to " + std::to_string(count) + " exclusive");
}

}  // namespace

Simulation::Simulation(std::shared_ptr<const WorldModel> world,
                       const std::vector<sim::RobotSetup>& robots, sim::WorldOptions options)
    : world_(std::move(world), robots, options) {
  for (const sim::RobotSetup& robot : robots)
    robots_.push_back(std::make_unique<Robot>(robot.model));
  told_.resize(robots_.size());
  truth_.publish(world_.scene());
}

void Simulation::advanceTo(SimTime time) {
  while (world_.now() < time && world_.healthy()) {
    tickDueRobots();
    world_.step();
    offerPictures();
    for (SimulationWatcher* watcher : watchers_) watcher->stepped(*this);
  }
}

void Simulation::watch(SimulationWatcher& watcher) {
  watchers_.push_back(&watcher);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i]->tellInputs([this, i](Input::Place place, const Input::Content& content) {
      tell({now(), place, i, content});
    });
  }
}

void Simulation::tell(const Input& input) {
  for (SimulationWatcher* watcher : watchers_) watcher->took(input);
}

void Simulation::showTo(std::shared_ptr<camera::RenderQueue> queue, std::size_t robot) {
  eyes_.push_back({std::move(queue), robot});
}

void Simulation::offerPictures() {
  std::shared_ptr<const SceneFrame> scene;  // one for all cameras of this instant
  for (Eyes& eyes : eyes_) {
    if (!eyes.queue->anyDue(world_.now())) continue;
    if (!scene) scene = std::make_shared<const SceneFrame>(world_.scene());
    eyes.queue->offer(scene, eyes.robot);
  }
}

void Simulation::tickDueRobots() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Duration cycle = robots_[i]->model().cycle;
    if (world_.now().time_since_epoch() % cycle != Duration::zero()) continue;
    lightLeds(i);
    const SensorFrame frame = world_.readSensors(i);
    const JointCommand command = robots_[i]->tick(frame);
    world_.setCommand(i, command);
    if (told_[i]) told_[i](frame, command);
    if (i == 0) truth_.publish(world_.scene());
  }
}

void Simulation::lightLeds(std::size_t robot) {
  for (const LedOrder& order : robots_[robot]->ports()->leds.drain()) {
    if (!watchers_.empty()) tell({now(), Input::Place::Cycle, robot, order});
    world_.setLeds(robot, order.leds, order.brightness);
  }
}

void Simulation::acceptRequests() {
  for (auto& robot : robots_) robot->acceptRequests();
}

std::shared_ptr<const Simulation::Snapshot> Simulation::snapshot() const {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->world = world_.snapshot();
  snapshot->robots.reserve(robots_.size());
  for (const auto& robot : robots_) snapshot->robots.push_back(robot->snapshot());
  for (const Eyes& eyes : eyes_) snapshot->pictures.push_back(eyes.queue->moment());
  return snapshot;
}

void Simulation::restore(const Snapshot& snapshot) {
  NAO_CHECK(snapshot.robots.size() == robots_.size());
  world_.restore(*snapshot.world);
  for (std::size_t i = 0; i < robots_.size(); ++i) robots_[i]->restore(snapshot.robots[i]);
  for (std::size_t i = 0; i < eyes_.size(); ++i)
    eyes_[i].queue->restore(i < snapshot.pictures.size() ? snapshot.pictures[i] : nullptr);
  truth_.publish(world_.scene());
}

void Simulation::reset() {
  world_.reset();
  for (auto& robot : robots_) robot->restart();
  for (Eyes& eyes : eyes_) eyes.queue->restore(nullptr);
}

std::uint64_t Simulation::hash() const {
  Archive hash = Archive::hashing();
  std::uint64_t world = world_.hash();
  hash.value(world);
  for (const auto& robot : robots_) robot->addTo(hash);
  return hash.hash();
}

void Simulation::keepSnapshot(const std::string& name) {
  if (snapshots_.count(name) == 0 && snapshots_.size() >= kMostSnapshots) {
    throw InputError("there are " + std::to_string(kMostSnapshots) +
                     " snapshots already, expected one to be dropped first");
  }
  snapshots_[name] = snapshot();
}

const std::shared_ptr<const Simulation::Snapshot>& Simulation::findSnapshot(
    const std::string& name) const {
  const auto found = snapshots_.find(name);
  if (found == snapshots_.end()) throw InputError("there is no snapshot '" + name + "'");
  return found->second;
}

std::vector<std::string> Simulation::snapshotNames() const {
  std::vector<std::string> names;
  for (const auto& [name, snapshot] : snapshots_) names.push_back(name);
  return names;
}

void Simulation::checkJoint(std::size_t robot, Joint joint) const {
  checkIndex(robot, robots_.size(), "robot");
  checkIndex(index(joint), robots_[robot]->model().jointCount(), "joint");
}

void Simulation::apply(const WorldRequest& request) {
  const SimTime before = now();
  carryOut(request);
  if (!watchers_.empty()) tell({before, Input::Place::Between, 0, request});
  truth_.publish(world_.scene());
}

void Simulation::carryOut(const WorldRequest& request) {
  std::visit(Overloaded{[this](const PushRobot& r) {
                          checkIndex(r.robot, robots_.size(), "robot");
                          world_.push(r.robot, r.force_W, r.duration);
                        },
                        [this](const PressSensor& r) {
                          checkIndex(r.robot, robots_.size(), "robot");
                          world_.press(r.robot, r.sensor, r.duration);
                        },
                        [this](const PlaceRobot& r) {
                          checkIndex(r.robot, robots_.size(), "robot");
                          world_.placeRobot(r.robot, r.pose);
                          robots_[r.robot]->restart();
                        },
                        [this](const PlaceBall& r) {
                          checkIndex(r.ball, world_.model().balls.size(), "ball");
                          world_.placeBall(r.ball, r.p_W, r.v_W);
                        },
                        [this](const KillJoint& r) {
                          checkJoint(r.robot, r.joint);
                          world_.killJoint(r.robot, r.joint, r.duration);
                        },
                        [this](const FreezeSensor& r) {
                          checkIndex(r.robot, robots_.size(), "robot");
                          world_.freezeSensor(r.robot, r.sensor, r.duration);
                        },
                        [this](const DisturbSensor& r) {
                          checkIndex(r.robot, robots_.size(), "robot");
                          world_.disturbSensor(r.robot, r.sensor, r.sd, r.duration);
                        },
                        [this](const HeatMotor& r) {
                          checkJoint(r.robot, r.joint);
                          world_.heatMotor(r.robot, r.joint, r.temperature);
                        },
                        [this](const SetCharge& r) {
                          checkIndex(r.robot, robots_.size(), "robot");
                          world_.setCharge(r.robot, r.charge);
                        },
                        [this](const DirtyLens& r) {
                          checkIndex(r.robot, robots_.size(), "robot");
                          checkIndex(r.camera, robots_[r.robot]->model().cameras.size(), "camera");
                          world_.dirtyLens(r.robot, r.camera, r.dirt);
                        },
                        [this](const WetFloor& r) {
                          world_.wetFloor({r.x, r.y}, r.radius, r.friction, r.duration);
                        },
                        [this](const ResetWorld&) { reset(); },
                        [this](const TakeSnapshot& r) { keepSnapshot(r.name); },
                        [this](const RestoreSnapshot& r) { restore(*findSnapshot(r.name)); },
                        [this](const DropSnapshot& r) {
                          findSnapshot(r.name);
                          snapshots_.erase(r.name);
                        }},
             request);
}

}  // namespace nao::runtime
