#include "sim/world_robot.h"

#include <algorithm>
#include <cmath>

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;

// Without an order for this long the motor boards only brake (NAOqi 1.14.5 documentation, DCM).
constexpr Duration kWatchdog = 500ms;

EffectChain makeEffects(const RobotSetup& setup, const WorldOptions& options) {
  const RobotModel& model = *setup.model;
  std::vector<EffectSetting> settings = model.effects;
  if (options.seed) {
    settings.insert(settings.end(), model.variation.begin(), model.variation.end());
  }
  return EffectChain(options.effects ? *options.effects : standardEffects(), settings, model,
                     options.step, options.seed, setup.name);
}

BodyPlan makePlan(const RobotSetup& setup, const WorldModel& world, const WorldOptions& options,
                  EffectChain& effects) {
  BodyPlan plan(*setup.model, world);
  effects.alterPlan(plan);
  if (options.mode == Mode::Implicit) return plan;
  const bool soft =
      std::any_of(plan.transmissions.begin(), plan.transmissions.end(),
                  [](const Transmission& t) { return t.play > 0 || t.stiffness > 0; });
  if (soft || effects.actsOnDrive()) {
    throw InputError("--mode: expected `implicit` for " + setup.name + ", a " + setup.model->name +
                     " with friction or play; the others are for ideal drives");
  }
  return plan;
}

JointArray<double> startAngles(const RobotModel& model) {
  const Posture* posture = model.findPosture(model.start_posture);
  return posture ? posture->angle : JointArray<double>(model.jointCount());
}

}  // namespace

WorldRobot::WorldRobot(const RobotSetup& setup, const WorldModel& world,
                       const WorldOptions& options)
    : setup_(setup),
      effects_(makeEffects(setup, options)),
      body_(makePlan(setup, world, options, effects_), options.mode),
      sensors_(*setup.model, body_.plan().gravity),
      faults_(*setup.model, options.seed, setup.name),
      led_names_(ledNames(*setup.model)),
      lens_dirt_(setup.model->cameras.size()) {
  reset();
}

void WorldRobot::setWatch(const PhaseWatch* watch) {
  watch_ = watch;
  body_.setWatch(watch);
}

void WorldRobot::place(const Pose2& pose, const JointArray<double>* angles) {
  sent_.angle = angles ? *angles : startAngles(*setup_.model);
  sent_.stiffness = JointArray<double>(sent_.angle.size(), 0.0);
  followed_ = sent_;
  body_.place(pose, sent_.angle);
  effects_.restart();
  sensors_.reset();
  faults_.reset();
  std::fill(lens_dirt_.begin(), lens_dirt_.end(), 0.0F);
  push_ = {};
  leds_ = {};
}

void WorldRobot::reset() {
  Pose2 start = setup_.start;
  effects_.alterStart(start);
  place(start, nullptr);
}

void WorldRobot::setCommand(const JointCommand& command, SimTime now) {
  sent_ = command;
  sent_at_ = now;
}

void WorldRobot::step(SimTime now, Duration step, std::vector<ExternalForce>& external) {
  const double h = toSeconds(step);
  if (push_.until > now) external.push_back({0, body_.motion()[0].p_WB, push_.f_W});
  followed_ = sent_;
  if (now - sent_at_ > kWatchdog) {
    followed_.stiffness = JointArray<double>(followed_.stiffness.size(), 0.0);
  }
  effects_.alterCommand(followed_, now, h);
  faults_.alterCommand(followed_, now);
  const DriveTerms* terms = calcTerms(now, h);
  ended(Phase::Effects);
  body_.step(followed_, terms, external, h);
}

const DriveTerms* WorldRobot::calcTerms(SimTime now, double h) {
  if (!effects_.actsOnDrive()) return nullptr;
  const Drive& drive = body_.drive();
  effects_.alterDrive({now, h, drive.angle(), drive.rate(), followed_.angle, followed_.stiffness,
                       drive.torque(), drive.load()},
                      terms_);
  return &terms_;
}

bool WorldRobot::setLeds(const std::string& leds, float brightness) {
  const std::vector<std::size_t> meant = findLeds(led_names_, leds);
  const float level = brightness > 0 ? std::min(brightness, 1.0F) : 0;  // not a number: dark
  for (const std::size_t led : meant) leds_[led] = level;
  return !meant.empty();
}

SensorFrame WorldRobot::readSensors(const Surroundings& around, SimTime now) {
  SensorFrame frame = sensors_.sample(around, now, effects_, faults_, watch_);
  frame.leds = leds_;
  return frame;
}

SceneFrame::Robot WorldRobot::scene() const {
  SceneFrame::Robot robot{setup_.name, setup_.model, {}, leds_, {}, setup_.team};
  for (const BodyMotion& body : body_.motion()) {
    Pose X_WB = translation(body.p_WB);
    X_WB.linear() = body.R_WB;
    robot.X_WB.push_back(X_WB);
    robot.w_WB.push_back(body.w_WB);
  }
  robot.lens_dirt = lens_dirt_;
  return robot;
}

void WorldRobot::archive(Archive& archive) {
  body_.archive(archive);
  effects_.archive(archive);
  sensors_.archive(archive);
  faults_.archive(archive);
  archive.list(lens_dirt_);
  for (JointCommand* command : {&sent_, &followed_}) {
    archive.value(command->angle);
    archive.value(command->stiffness);
  }
  archive.value(sent_at_);
  archive.numbers(push_.f_W);
  archive.value(push_.until);
  archive.value(leds_);
}

}  // namespace nao::sim
