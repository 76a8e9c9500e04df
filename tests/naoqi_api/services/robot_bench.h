#pragma once

#include <memory>
#include <string>
#include <vector>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"
#include "tests/motion/test_robot.h"

namespace nao::services {

/// A robot without physics behind a RobotLink: its joints are where they were commanded a cycle
/// ago, its gait is the fake one.
class RobotBench {
 public:
  RobotBench() : RobotBench(motion::makeTestRobot()) {}
  explicit RobotBench(std::shared_ptr<const RobotModel> robot)
      : model(std::move(robot)),
        ports(std::make_shared<motion::RobotPorts>()),
        link(model, ports),
        gait(std::make_shared<motion::FakeGait::Log>()),
        engine(model, std::make_unique<motion::FakeGait>(*model, gait)) {
    frame.angle = model->findPosture(model->start_posture)->angle;
    for (FootForces& foot : frame.feet) foot.total = 22;
  }

  /// One cycle of the robot and of the services.
  void cycle() {
    for (const auto& request : ports->requests.drain()) engine.accept(request);
    const JointCommand command = engine.update(frame);
    ports->publish(std::make_shared<const SensorFrame>(frame));
    ports->state.publish(engine.state());
    for (auto& outcome : engine.takeOutcomes()) ASSERT_TRUE(ports->outcomes.post(outcome));
    frame.time += model->cycle;
    for (std::size_t i = 0; i < command.angle.size(); ++i) {
      if (command.stiffness[i] > 0) frame.angle[i] = command.angle[i];
    }
    link.deliver();
  }
  void run(double seconds) {
    const int cycles = static_cast<int>(seconds / toSeconds(model->cycle) + 0.5);
    for (int i = 0; i < cycles; ++i) cycle();
  }

  /// Calls a method and lets the robot go on until the call ends; void if it never does.
  rpc::Value call(rpc::Service& service, const std::string& name,
                  const std::vector<rpc::Value>& arguments) {
    const auto pending = service.call(name, arguments);
    for (int i = 0; i < 3000 && !pending.isDone(); ++i) cycle();
    EXPECT_TRUE(pending.isDone()) << name << " did not end within 30 s";
    if (!pending.isDone()) return {};
    EXPECT_FALSE(pending.outcome()->error) << *pending.outcome()->error;
    return pending.outcome()->value ? *pending.outcome()->value : rpc::Value();
  }
  /// The error text of a call; empty if it succeeds.
  std::string errorOf(rpc::Service& service, const std::string& name,
                      const std::vector<rpc::Value>& arguments) {
    const auto pending = service.call(name, arguments);
    for (int i = 0; i < 3000 && !pending.isDone(); ++i) cycle();
    EXPECT_TRUE(pending.isDone()) << name;
    return pending.isDone() ? pending.outcome()->error.value_or("") : "";
  }

  std::shared_ptr<const RobotModel> model;
  std::shared_ptr<motion::RobotPorts> ports;
  RobotLink link;
  std::shared_ptr<motion::FakeGait::Log> gait;
  motion::MotionEngine engine;
  SensorFrame frame;
};

}  // namespace nao::services
