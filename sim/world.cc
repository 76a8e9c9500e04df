#include "sim/world.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/check.h"
#include "sim/effects/catalogue.h"
#include "sim/fsr.h"
#include "sim/imu.h"
#include "sim/robot_body.h"
#include "sim/touching.h"

namespace nao::sim {
namespace {

constexpr double kAmbient = 25;  // [deg C] motors do not warm up yet

void checkStep(const std::vector<RobotSetup>& robots, Duration step) {
  using std::chrono_literals::operator""ms;
  if (step < 1ms || step > 5ms) throw InputError("--step: expected 1 to 5 ms");
  for (const RobotSetup& robot : robots) {
    if (robot.model->cycle % step == Duration::zero()) continue;
    throw InputError("--step: expected a divisor of the " +
                     std::to_string(robot.model->cycle / 1ms) + " ms cycle of " + robot.name);
  }
}

JointArray<double> startAngles(const RobotModel& model) {
  const Posture* posture = model.findPosture(model.start_posture);
  return posture ? posture->angle : JointArray<double>(model.jointCount());
}

std::vector<BallState> startBalls(const WorldModel& world) {
  std::vector<BallState> balls;
  for (const Ball& ball : world.balls) balls.push_back({ball.p_W, Vec3::Zero(), Mat3::Identity()});
  return balls;
}

// FNV-1a over the bytes of numbers.
class Hash {
 public:
  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * 1099511628211ULL;
  }
  template <class Vector>
  void addNumbers(const Vector& v) {
    add(v.data(), static_cast<std::size_t>(v.size()) * sizeof(double));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace

class World::Snapshot {
 public:
  struct Push {
    Vec3 f_W = Vec3::Zero();
    SimTime until{};
  };
  struct Robot {
    RobotBody::State body;
    JointCommand command;
    Imu::State imu;
    Push push;
  };
  SimTime now{};
  std::vector<Robot> robots;
  std::vector<BallState> balls;
};

class World::Impl {
 public:
  Impl(std::shared_ptr<const WorldModel> model, std::vector<RobotSetup> setups,
       const WorldOptions& options)
      : model_(std::move(model)),
        setups_(std::move(setups)),
        step_(options.step),
        touching_(*model_) {
    checkStep(setups_, step_);
    const EffectCatalogue& catalogue = options.effects ? *options.effects : standardEffects();
    for (const RobotSetup& setup : setups_) {
      std::vector<EffectSetting> settings = setup.model->effects;
      const std::vector<EffectSetting>& variation = setup.model->variation;
      if (options.seed) settings.insert(settings.end(), variation.begin(), variation.end());
      EffectChain effects(catalogue, settings, *setup.model, step_, options.seed, setup.name);
      robots_.push_back(std::make_unique<Robot>(setup, *model_, std::move(effects)));
      bodies_.push_back(&robots_.back()->body);
      place(robots_.size() - 1, setup.start, startAngles(*setup.model));
    }
    balls_ = startBalls(*model_);
  }

  struct Robot {
    Robot(const RobotSetup& setup, const WorldModel& world, EffectChain chain)
        : effects(std::move(chain)), body(setup.model, world), imu(*setup.model, world.gravity) {}
    EffectChain effects;
    RobotBody body;
    Imu imu;
    JointCommand command;
    Snapshot::Push push;
  };

  void place(std::size_t i, const Pose2& pose, const JointArray<double>& angles) {
    Robot& robot = *robots_[i];
    robot.body.place(pose, angles);
    robot.imu.state() = {};
    robot.command.angle = angles;
    robot.command.stiffness = JointArray<double>(angles.size(), 0.0);
    robot.push = {};
  }

  void step() {
    if (!healthy_) return;
    const double h = toSeconds(step_);
    touching_.calc(bodies_, balls_, on_robots_, on_balls_);
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      Robot& robot = *robots_[i];
      if (robot.push.until > now_) {
        on_robots_[i].push_back({0, robot.body.motion()[0].p_WB, robot.push.f_W});
      }
      robot.body.step(robot.command, on_robots_[i], h);
      healthy_ = healthy_ && robot.body.finite();
    }
    for (std::size_t b = 0; b < balls_.size(); ++b) {
      touching_.stepBall(model_->balls[b], on_balls_[b], h, balls_[b]);
    }
    now_ += step_;
  }

  SensorFrame readSensors(std::size_t i) {
    Robot& robot = *robots_[i];
    const RobotModel& model = robot.body.model();
    SensorFrame frame;
    frame.time = now_;
    frame.angle = frame.current = JointArray<double>(model.jointCount());
    frame.temperature = JointArray<double>(model.jointCount(), kAmbient);
    for (std::size_t j = 0; j < model.jointCount(); ++j) {
      frame.angle[j] = robot.body.angle(toJoint(j));
      frame.current[j] = current(model.actuators[j], robot.body.torque()[j]);
    }
    robot.imu.sample(robot.body.motion(), model.cycle, frame);
    frame.feet = calcFootForces(model, robot.body.motion(), robot.body.groundForces());
    robot.effects.alterSensors(frame, model.cycle);
    return frame;
  }

  SceneFrame scene() const {
    SceneFrame scene;
    scene.time = now_;
    scene.world = model_;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      SceneFrame::Robot robot{setups_[i].name, setups_[i].model, {}};
      for (const BodyMotion& body : robots_[i]->body.motion()) {
        Pose X_WB = translation(body.p_WB);
        X_WB.linear() = body.R_WB;
        robot.X_WB.push_back(X_WB);
      }
      scene.robots.push_back(std::move(robot));
    }
    for (std::size_t b = 0; b < balls_.size(); ++b) {
      scene.balls.push_back(
          {model_->balls[b].radius, balls_[b].p_W, model_->balls[b].color, balls_[b].R_W});
    }
    return scene;
  }

  void reset() {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      place(i, setups_[i].start, startAngles(*setups_[i].model));
    }
    balls_ = startBalls(*model_);
    healthy_ = true;
  }

  std::uint64_t hash() const {
    Hash hash;
    const auto time = now_.time_since_epoch().count();
    hash.add(&time, sizeof time);
    for (const auto& robot : robots_) {
      hash.addNumbers(robot->body.state().tree.q);
      hash.addNumbers(robot->body.state().tree.u);
      for (const auto& anchor : robot->body.state().anchors) hash.addNumbers(anchor.place);
    }
    for (const BallState& ball : balls_) {
      hash.addNumbers(ball.p_W);
      hash.addNumbers(ball.v_W);
    }
    return hash.value();
  }

  std::shared_ptr<const Snapshot> snapshot() const {
    auto out = std::make_shared<Snapshot>();
    out->now = now_;
    out->balls = balls_;
    for (const auto& robot : robots_) {
      out->robots.push_back({robot->body.state(), robot->command, robot->imu.state(), robot->push});
    }
    return out;
  }

  void restore(const Snapshot& from) {
    NAO_CHECK(from.robots.size() == robots_.size() && from.balls.size() == balls_.size());
    now_ = from.now;
    balls_ = from.balls;
    healthy_ = true;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      robots_[i]->body.setState(from.robots[i].body);
      robots_[i]->command = from.robots[i].command;
      robots_[i]->imu.state() = from.robots[i].imu;
      robots_[i]->push = from.robots[i].push;
    }
  }

  // The share of the stall current that the torque needs; stall current at 21.6 V is estimated
  // from the RE-Max 24's order of size, no Aldebaran figure is public.
  static double current(const Actuator& actuator, double torque) {
    constexpr double kStallCurrent = 3.0;  // [A]
    if (actuator.stall_torque <= 0) return 0;
    return kStallCurrent * std::abs(torque) / (actuator.efficiency * actuator.stall_torque);
  }

  std::shared_ptr<const WorldModel> model_;
  std::vector<RobotSetup> setups_;
  Duration step_;
  Touching touching_;
  std::vector<std::unique_ptr<Robot>> robots_;
  std::vector<const RobotBody*> bodies_;
  std::vector<BallState> balls_;
  std::vector<std::vector<ExternalForce>> on_robots_;
  std::vector<Vec3> on_balls_;
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
  impl_->robots_[robot]->command = command;
}
void World::step() { impl_->step(); }
SensorFrame World::readSensors(std::size_t robot) { return impl_->readSensors(robot); }
SceneFrame World::scene() const { return impl_->scene(); }
bool World::healthy() const { return impl_->healthy_; }
void World::push(std::size_t robot, const Vec3& force_W, Duration duration) {
  impl_->robots_.at(robot)->push = {force_W, impl_->now_ + duration};
}
void World::placeRobot(std::size_t robot, const Pose2& pose, const JointArray<double>* angles) {
  impl_->place(robot, pose, angles ? *angles : startAngles(*impl_->setups_.at(robot).model));
}
void World::placeBall(std::size_t ball, const Vec3& p_W, const Vec3& v_W) {
  BallState& state = impl_->balls_.at(ball);
  state = {p_W, v_W, Mat3::Identity()};
  state.p_W.z() = std::max(p_W.z(), impl_->model_->balls[ball].radius);
}
void World::reset() { impl_->reset(); }
std::map<std::string, double> World::draw() const {
  std::map<std::string, double> all;
  for (std::size_t i = 0; i < impl_->robots_.size(); ++i) {
    for (const auto& [name, value] : impl_->robots_[i]->effects.draw()) {
      all[impl_->setups_[i].name + "." + name] = value;
    }
  }
  return all;
}
std::uint64_t World::hash() const { return impl_->hash(); }
std::shared_ptr<const World::Snapshot> World::snapshot() const { return impl_->snapshot(); }
void World::restore(const Snapshot& snapshot) { impl_->restore(snapshot); }
double World::penetration(std::size_t robot) const {
  double depth = 0;
  for (const auto& force : impl_->robots_.at(robot)->body.groundForces()) {
    depth = std::max(depth, force.depth);
  }
  return depth;
}

}  // namespace nao::sim
