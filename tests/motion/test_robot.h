#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "motion/gait.h"
#include "motion/motion_engine.h"

namespace nao::motion {

/// A robot with the joints, groups and postures of a Nao H21, without bodies: enough for whoever
/// commands joints. Figures as in robots/nao_h21_v33, shortened where a test does not need them.
inline std::shared_ptr<RobotModel> makeTestRobot() {
  auto model = std::make_shared<RobotModel>();
  model->name = "test_nao";
  model->body_type = "H21";
  model->version = "V3.3";
  model->cycle = std::chrono::milliseconds(10);
  model->start_posture = "Crouch";
  struct Row {
    const char* name;
    double lower, upper, speed, crouch, stand_init, stand;
  };
  const std::vector<Row> rows = {
      {"HeadYaw", -2.0857, 2.0857, 8.268, 0, 0, 0},
      {"HeadPitch", -0.672, 0.5149, 7.194, 0.1, 0, -0.17},
      {"LShoulderPitch", -2.0857, 2.0857, 8.268, 1.6, 1.4, 1.4717},
      {"LShoulderRoll", -0.3142, 1.3265, 7.194, 0.1, 0.3, 0.1857},
      {"LElbowYaw", -2.0857, 2.0857, 8.268, -0.7, -1.39, -1.1938},
      {"LElbowRoll", -1.5446, -0.0349, 7.194, -1.0, -1.01, -0.4107},
      {"LHipYawPitch", -1.145303, 0.740810, 4.1617, -0.25, 0, -0.17},
      {"LHipRoll", -0.379472, 0.790477, 4.1617, -0.08, 0, 0.1191},
      {"LHipPitch", -1.535889, 0.48409, 6.4024, -0.7, -0.45, 0.1274},
      {"LKneePitch", -0.092346, 2.112528, 6.4024, 2.11, 0.7, -0.0923},
      {"LAnklePitch", -1.189516, 0.922747, 6.4024, -1.18, -0.35, 0.0874},
      {"LAnkleRoll", -0.397880, 0.769001, 4.1617, 0.075, 0, -0.1108},
      {"RHipRoll", -0.790477, 0.379472, 4.1617, 0.08, 0, -0.1191},
      {"RHipPitch", -1.535889, 0.48409, 6.4024, -0.7, -0.45, 0.1274},
      {"RKneePitch", -0.103083, 2.120198, 6.4024, 2.11, 0.7, -0.0923},
      {"RAnklePitch", -1.186448, 0.932056, 6.4024, -1.18, -0.35, 0.0874},
      {"RAnkleRoll", -0.768992, 0.397935, 4.1617, -0.075, 0, 0.1108},
      {"RShoulderPitch", -2.0857, 2.0857, 8.268, 1.6, 1.4, 1.4717},
      {"RShoulderRoll", -1.3265, 0.3142, 7.194, -0.1, -0.3, -0.1857},
      {"RElbowYaw", -2.0857, 2.0857, 8.268, 0.7, 1.39, 1.1938},
      {"RElbowRoll", 0.0349, 1.5446, 7.194, 1.0, 1.01, 0.4107},
  };
  Posture crouch{"Crouch", "Crouching", JointArray<double>(rows.size())};
  Posture stand_init{"StandInit", "Standing", JointArray<double>(rows.size())};
  Posture stand{"Stand", "Standing", JointArray<double>(rows.size())};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Actuator actuator;
    actuator.name = rows[i].name;
    actuator.lower = rows[i].lower;
    actuator.upper = rows[i].upper;
    actuator.max_velocity = rows[i].speed;
    actuator.max_torque = 1.5;
    actuator.coordinates = {static_cast<int>(i)};
    model->actuators.push_back(actuator);
    crouch.angle[i] = rows[i].crouch;
    stand_init.angle[i] = rows[i].stand_init;
    stand.angle[i] = rows[i].stand;
  }
  model->postures = {crouch, stand_init, stand};
  model->aliases = {{"RHipYawPitch", "LHipYawPitch"}};
  auto& groups = model->groups;
  groups["Head"] = {"HeadYaw", "HeadPitch"};
  groups["LArm"] = {"LShoulderPitch", "LShoulderRoll", "LElbowYaw", "LElbowRoll"};
  groups["LLeg"] = {"LHipYawPitch", "LHipRoll",    "LHipPitch",
                    "LKneePitch",   "LAnklePitch", "LAnkleRoll"};
  groups["RLeg"] = {"RHipYawPitch", "RHipRoll",    "RHipPitch",
                    "RKneePitch",   "RAnklePitch", "RAnkleRoll"};
  groups["RArm"] = {"RShoulderPitch", "RShoulderRoll", "RElbowYaw", "RElbowRoll"};
  for (const char* chain : {"Head", "LArm", "LLeg", "RLeg", "RArm"}) {
    for (const std::string& joint : groups[chain]) groups["Body"].push_back(joint);
  }
  groups["Chains"] = {"Head", "LArm", "LLeg", "RLeg", "RArm"};
  model->feet.resize(2);
  model->coupled_limits.push_back({*model->findJoint("HeadYaw"),
                                   *model->findJoint("HeadPitch"),
                                   {{-1.53, -0.33, 0.2}, {0, -0.672, 0.515}, {1.53, -0.33, 0.2}}});
  return model;
}

/// A gait that writes down what it is told. While active it puts `legs` into every leg joint and
/// `arms` into every arm joint; walkTo() takes `steps` cycles, stop() three more.
class FakeGait final : public Gait {
 public:
  struct Log {
    std::vector<std::string> calls;
    Pose2 target;
    Velocity2 velocity;
    GaitConfig config;
    std::vector<StepOrder> ordered;
    WalkFeedback feedback;
    int steps = 20;      // cycles of a walkTo
    double legs = -0.4;  // [rad]
    double arms = 1.2;   // [rad]
  };
  FakeGait(const RobotModel& model, std::shared_ptr<Log> log)
      : model_(model), log_(std::move(log)) {}

  void walkTo(const Pose2& target, const GaitConfig& config) override {
    log_->calls.push_back("walkTo");
    log_->target = target;
    log_->config = config;
    left_ = log_->steps;
  }
  void walkToward(double x, double y, double theta, const GaitConfig& config) override {
    log_->calls.push_back("walkToward");
    log_->velocity = {x, y, theta};
    log_->config = config;
    left_ = 1 << 20;
  }
  void walkAt(const Velocity2& velocity, const GaitConfig& config) override {
    log_->calls.push_back("walkAt");
    log_->velocity = velocity;
    log_->config = config;
    left_ = 1 << 20;
  }
  void walkSteps(const std::vector<StepOrder>& steps, bool clear) override {
    log_->calls.push_back(clear ? "walkSteps clear" : "walkSteps");
    log_->ordered = steps;
    left_ = log_->steps;
  }
  void setFeedback(const WalkFeedback& feedback) override { log_->feedback = feedback; }
  void stop() override {
    log_->calls.push_back("stop");
    left_ = std::min(left_, 3);
  }
  void kill() override {
    log_->calls.push_back("kill");
    left_ = 0;
  }
  bool active() const override { return left_ > 0; }
  void update(const SensorFrame& /*measured*/, JointCommand& command) override {
    if (left_ > 0) --left_;
    for (const char* chain : {"LLeg", "RLeg", "LArm", "RArm"}) {
      for (const std::string& name : model_.groups.at(chain)) {
        command.angle[*model_.findJoint(name)] = chain[1] == 'L' ? log_->legs : log_->arms;
      }
    }
    position_.x += 0.001;
  }
  Pose2 position() const override { return position_; }
  Pose2 nextPosition() const override { return {position_.x + 0.04, position_.y, position_.theta}; }
  Velocity2 velocity() const override { return active() ? Velocity2{0.1, 0, 0} : Velocity2{}; }
  std::vector<Footstep> footsteps() const override {
    if (!active()) return {};
    return {{Foot::Left, {0.04, 0.05, 0}, {}}, {Foot::Right, {0.08, -0.05, 0}, {}}};
  }
  std::unique_ptr<Gait> clone() const override { return std::make_unique<FakeGait>(*this); }
  void archive(Archive& archive) override {
    archive.value(left_);
    archive.value(position_);
  }

 private:
  const RobotModel& model_;
  std::shared_ptr<Log> log_;
  int left_ = 0;  // cycles
  Pose2 position_;
};

/// An engine with a fake gait and a body whose joints are where they were commanded a cycle ago.
class EngineBench {
 public:
  EngineBench() : EngineBench(makeTestRobot()) {}
  explicit EngineBench(std::shared_ptr<const RobotModel> robot)
      : model(std::move(robot)),
        gait(std::make_shared<FakeGait::Log>()),
        engine(model, std::make_unique<FakeGait>(*model, gait)) {
    frame.angle = model->findPosture(model->start_posture)->angle;
    for (FootForces& foot : frame.feet) foot.total = 22;
  }

  RequestId post(MotionAction action) {
    engine.accept({++last_id, std::move(action)});
    return last_id;
  }
  JointCommand cycle() {
    const JointCommand command = engine.update(frame);
    frame.time += model->cycle;
    for (std::size_t i = 0; i < command.angle.size(); ++i) {
      if (command.stiffness[i] > 0) frame.angle[i] = command.angle[i];
    }
    for (MotionOutcome& outcome : engine.takeOutcomes()) outcomes.push_back(std::move(outcome));
    return command;
  }
  void run(double seconds) {
    const int cycles = static_cast<int>(seconds / toSeconds(model->cycle) + 0.5);
    for (int i = 0; i < cycles; ++i) cycle();
  }
  /// Cycles until the request ended; -1 if it did not within `most`.
  int cyclesUntilEnd(RequestId id, int most = 2000) {
    for (int i = 1; i <= most; ++i) {
      cycle();
      if (findOutcome(id) != nullptr) return i;
    }
    return -1;
  }
  const MotionOutcome* findOutcome(RequestId id) const {
    for (const MotionOutcome& outcome : outcomes) {
      if (outcome.id == id) return &outcome;
    }
    return nullptr;
  }
  void stiffen(double stiffness = 1) {
    SetStiffness all;
    for (std::size_t i = 0; i < model->jointCount(); ++i) {
      all.joints.push_back(toJoint(i));
      all.stiffness.push_back(stiffness);
    }
    post(all);
    cycle();
  }
  /// Puts body and command into a posture at once.
  void pose(const char* posture) {
    stiffen(0);
    frame.angle = model->findPosture(posture)->angle;
    cycle();
    stiffen(1);
  }
  Joint joint(const char* name) const { return *model->findJoint(name); }
  double command(const char* name) const { return engine.state().command.angle[joint(name)]; }

  std::shared_ptr<const RobotModel> model;
  std::shared_ptr<FakeGait::Log> gait;
  MotionEngine engine;
  SensorFrame frame;
  RequestId last_id = 0;
  std::vector<MotionOutcome> outcomes;
};

}  // namespace nao::motion
