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
                       const std::vector<sim::RobotSetup>& robots, Duration step)
    : world_(std::move(world), robots, step) {
  for (const sim::RobotSetup& robot : robots)
    robots_.push_back(std::make_unique<Robot>(robot.model));
  truth_.publish(world_.scene());
}

void Simulation::advanceTo(SimTime time) {
  while (world_.now() < time && world_.healthy()) {
    tickDueRobots();
    world_.step();
    offerPictures();
  }
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
    world_.setCommand(i, robots_[i]->tick(world_.readSensors(i)));
    if (i == 0) truth_.publish(world_.scene());
  }
}

void Simulation::acceptRequests() {
  for (auto& robot : robots_) robot->acceptRequests();
}

void Simulation::apply(const WorldRequest& request) {
  std::visit(Overloaded{[this](const PushRobot& r) {
                          checkIndex(r.robot, robots_.size(), "robot");
                          world_.push(r.robot, r.force_W, r.duration);
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
                        [this](const ResetWorld&) {
                          world_.reset();
                          for (auto& robot : robots_) robot->restart();
                        }},
             request);
  truth_.publish(world_.scene());
}

}  // namespace nao::runtime
