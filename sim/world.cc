#include "sim/world.h"

#include <algorithm>

#include "core/archive.h"
#include "core/check.h"
#include "sim/touching.h"
#include "sim/world_robot.h"

namespace nao::sim {
namespace {

void checkStep(const std::vector<RobotSetup>& robots, Duration step, bool any_step) {
  using std::chrono_literals::operator""ms;
  if (!any_step && (step < 1ms || step > 5ms)) throw InputError("--step: expected 1 to 5 ms");
  for (const RobotSetup& robot : robots) {
    if (robot.model->cycle % step == Duration::zero()) continue;
    throw InputError("--step: expected a divisor of the " +
                     std::to_string(robot.model->cycle / 1ms) + " ms cycle of " + robot.name);
  }
}

std::vector<BallState> startBalls(const WorldModel& world) {
  std::vector<BallState> balls;
  for (const Ball& ball : world.balls) {
    balls.push_back(placedBall(ball, world, ball.p_W, Vec3::Zero()));
  }
  return balls;
}

}  // namespace

class World::Snapshot {
 public:
  std::vector<unsigned char> bytes;
};

class World::Impl {
 public:
  Impl(std::shared_ptr<const WorldModel> model, std::vector<RobotSetup> setups,
       const WorldOptions& options)
      : model_(std::move(model)),
        setups_(std::move(setups)),
        step_(options.step),
        watch_(options.watch),
        touching_(*model_),
        balls_(startBalls(*model_)) {
    checkStep(setups_, step_, options.any_step);
    for (const RobotSetup& setup : setups_) {
      robots_.push_back(std::make_unique<WorldRobot>(setup, *model_, options));
      if (watch_) robots_.back()->setWatch(&watch_);
      bodies_.push_back(&robots_.back()->body());
      touching_.add(bodies_.back()->model());
    }
  }

  // Those that are dry are gone; robots know the others.
  void dry() {
    const auto is_dry = [this](const WetPatch& patch) { return patch.until <= now_; };
    wet_.erase(std::remove_if(wet_.begin(), wet_.end(), is_dry), wet_.end());
    for (RobotBody* body : bodies_) body->setWet(wet_);
  }

  void step() {
    if (!healthy_) return;
    if (!wet_.empty()) dry();
    touching_.step(bodies_, balls_, toSeconds(step_), on_robots_);
    if (watch_) watch_(Phase::Touching);
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      robots_[i]->step(now_, step_, on_robots_[i]);
      healthy_ = healthy_ && robots_[i]->body().finite();
    }
    report();
    now_ += step_;
  }

  void report() {
    report_.forces.clear();
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const auto robot = static_cast<int>(i);
      for (const auto& force : bodies_[i]->groundForces()) {
        const BodyMotion& body = bodies_[i]->motion()[static_cast<std::size_t>(force.body)];
        const Vec3 p_W = body.p_WB + body.R_WB * force.p_B;
        report_.forces.push_back({robot, force.body, p_W, force.f_W});
      }
    }
    touching_.report(report_);
  }

  Surroundings around(std::size_t robot) const {
    return {*model_, bodies_, balls_, report_, robot};
  }

  std::size_t findSensor(std::size_t robot, const std::string& name) {
    if (const auto sensor = robots_.at(robot)->faults().findSensor(name)) return *sensor;
    std::string names;
    for (const std::string& one : Faults::sensorNames(*setups_[robot].model)) {
      names += (names.empty() ? "" : ", ") + one;
    }
    throw InputError("sensor: expected one of " + names + "; found '" + name + "'");
  }

  SceneFrame scene() const {
    SceneFrame scene;
    scene.time = now_;
    scene.world = model_;
    for (const auto& robot : robots_) scene.robots.push_back(robot->scene());
    for (std::size_t b = 0; b < balls_.size(); ++b) {
      const Ball& ball = model_->balls[b];
      scene.balls.push_back(
          {ball.radius, balls_[b].p_W, ball.color, balls_[b].R_W, ball.has_patches});
    }
    return scene;
  }

  void reset() {
    for (const auto& robot : robots_) robot->reset();
    balls_ = startBalls(*model_);
    wet_.clear();
    dry();
    report_.forces.clear();
    healthy_ = true;
  }

  // All that moves, once, for snapshot, restore and hash.
  void archive(Archive& archive) {
    archive.value(now_);
    archive.value(healthy_);
    for (const auto& robot : robots_) robot->archive(archive);
    for (BallState& ball : balls_) ball.archive(archive);
    report_.archive(archive);
    archive.list(wet_);
    if (archive.mode() == Archive::Mode::Load) dry();
  }

  std::shared_ptr<const WorldModel> model_;
  std::vector<RobotSetup> setups_;
  Duration step_;
  PhaseWatch watch_;  // robots share it
  Touching touching_;
  std::vector<std::unique_ptr<WorldRobot>> robots_;
  std::vector<RobotBody*> bodies_;
  std::vector<BallState> balls_;
  std::vector<std::vector<ExternalForce>> on_robots_;
  ContactReport report_;
  std::vector<WetPatch> wet_;
  SimTime now_{};
  bool healthy_ = true;
};

World::World(std::shared_ptr<const WorldModel> model, std::vector<RobotSetup> robots,
             WorldOptions options)
    : impl_(std::make_unique<Impl>(std::move(model), std::move(robots), options)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

SimTime World::now() const { return impl_->now_; }
Duration World::stepSize() const { return impl_->step_; }
std::size_t World::robotCount() const { return impl_->robots_.size(); }
const RobotSetup& World::robot(std::size_t robot) const { return impl_->setups_.at(robot); }
const WorldModel& World::model() const { return *impl_->model_; }
void World::setCommand(std::size_t robot, const JointCommand& command) {
  NAO_CHECK(command.angle.size() == impl_->setups_[robot].model->jointCount());
  impl_->robots_[robot]->setCommand(command, impl_->now_);
}
void World::step() { impl_->step(); }
SensorFrame World::readSensors(std::size_t robot) {
  return impl_->robots_[robot]->readSensors(impl_->around(robot), impl_->now_);
}
SceneFrame World::scene() const { return impl_->scene(); }
const ContactReport& World::contacts() const { return impl_->report_; }
bool World::healthy() const { return impl_->healthy_; }
void World::push(std::size_t robot, const Vec3& force_W, Duration duration) {
  impl_->robots_.at(robot)->push(force_W, impl_->now_ + duration);
}
void World::press(std::size_t robot, const std::string& sensor, Duration duration) {
  TouchSensors& touch = impl_->robots_.at(robot)->touch();
  if (touch.press(sensor, impl_->now_ + duration)) return;
  std::string names;
  for (const std::string& name : touch.names()) names += (names.empty() ? "" : ", ") + name;
  throw InputError("press: expected one of " + names + "; found '" + sensor + "'");
}
void World::killJoint(std::size_t robot, Joint joint, Duration duration) {
  NAO_CHECK(index(joint) < impl_->setups_.at(robot).model->jointCount());
  impl_->robots_.at(robot)->faults().killJoint(joint, impl_->now_ + duration);
}
void World::freezeSensor(std::size_t robot, const std::string& sensor, Duration duration) {
  impl_->robots_.at(robot)->faults().freeze(impl_->findSensor(robot, sensor),
                                            impl_->now_ + duration);
}
void World::disturbSensor(std::size_t robot, const std::string& sensor, double sd,
                          Duration duration) {
  impl_->robots_.at(robot)->faults().disturb(impl_->findSensor(robot, sensor), sd,
                                             impl_->now_ + duration);
}
void World::heatMotor(std::size_t robot, Joint joint, double temperature) {
  NAO_CHECK(index(joint) < impl_->setups_.at(robot).model->jointCount());
  impl_->robots_.at(robot)->sensors().heat().heat(joint, temperature);
}
void World::setCharge(std::size_t robot, double charge) {
  impl_->robots_.at(robot)->sensors().battery().setCharge(std::clamp(charge, 0.0, 1.0));
}
void World::dirtyLens(std::size_t robot, std::size_t camera, double dirt) {
  NAO_CHECK(camera < impl_->setups_.at(robot).model->cameras.size());
  const double within = std::clamp(dirt, 0.0, 1.0);
  impl_->robots_.at(robot)->setLensDirt(camera, static_cast<float>(within));
}
void World::wetFloor(const Eigen::Vector2d& center_W, double radius, double friction,
                     Duration duration) {
  impl_->wet_.push_back({center_W.x(), center_W.y(), radius, friction, impl_->now_ + duration});
  impl_->dry();
}
bool World::setLeds(std::size_t robot, const std::string& leds, float brightness) {
  return impl_->robots_.at(robot)->setLeds(leds, brightness);
}
void World::placeRobot(std::size_t robot, const Pose2& pose, const JointArray<double>* angles) {
  impl_->robots_.at(robot)->place(pose, angles);
}
void World::placeBall(std::size_t ball, const Vec3& p_W, const Vec3& v_W) {
  const WorldModel& model = *impl_->model_;
  impl_->balls_.at(ball) = placedBall(model.balls[ball], model, p_W, v_W);
}
void World::reset() { impl_->reset(); }
std::map<std::string, double> World::draw() const {
  std::map<std::string, double> all;
  for (std::size_t i = 0; i < impl_->robots_.size(); ++i) {
    for (const auto& [name, value] : impl_->robots_[i]->draw()) {
      all[impl_->setups_[i].name + "." + name] = value;
    }
  }
  return all;
}
std::uint64_t World::hash() const {
  Archive archive = Archive::hashing();
  impl_->archive(archive);
  return archive.hash();
}

std::shared_ptr<const World::Snapshot> World::snapshot() const {
  auto snapshot = std::make_shared<Snapshot>();
  Archive archive = Archive::saving(snapshot->bytes);
  impl_->archive(archive);
  return snapshot;
}

void World::restore(const Snapshot& snapshot) {
  Archive archive = Archive::loading(snapshot.bytes);
  impl_->archive(archive);
  NAO_CHECK(archive.atEnd());  // else the two worlds are not alike
}

World::Motors World::motors(std::size_t robot) const {
  const Drive& drive = impl_->robots_.at(robot)->body().drive();
  return {drive.torque(), drive.saturated()};
}

double World::penetration(std::size_t robot) const {
  double depth = 0;
  for (const auto& force : impl_->robots_.at(robot)->body().groundForces()) {
    depth = std::max(depth, force.depth);
  }
  return depth;
}

}  // namespace nao::sim
