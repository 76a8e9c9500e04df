#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

class ObstacleReflexTest : public ServicesBench {
 protected:
  ObstacleReflexTest() { bench_.gait->legs = 0; }  // upright

  // An obstacle straight ahead at this distance from the sonar [m].
  void putObstacle(double distance) {
    for (auto& echoes : bench_.frame.sonar) echoes.fill(bench_.model->sonar.max_range);
    for (auto& echoes : bench_.frame.sonar) echoes[0] = distance;
    run(0.05);
  }
  bool walks() { return call("ALMotion", "moveIsActive").to<bool>(); }
};

TEST_F(ObstacleReflexTest, AWalkEndsBeforeAnObstacleAndTheEventTellsWhere) {
  call("ALMotion", "wakeUp");
  putObstacle(0.75);
  call("ALMotion", "move", {0.09F, 0.0F, 0.0F});
  run(1);
  EXPECT_TRUE(walks());
  putObstacle(0.3);
  run(2);
  EXPECT_FALSE(walks());
  const Value failed = data("ALMotion/MoveFailed");
  EXPECT_EQ(failed.findItems()->at(0), Value("Obstacle detected"));
  EXPECT_GT(number(failed.findItems()->at(2).findItems()->at(0)), 0.2);
}

TEST_F(ObstacleReflexTest, IsOffWhenItIsSwitchedOff) {
  call("ALMotion", "wakeUp");
  call("ALMotion", "setExternalCollisionProtectionEnabled", {"Move", false});
  putObstacle(0.3);
  call("ALMotion", "move", {0.09F, 0.0F, 0.0F});
  run(2);
  EXPECT_TRUE(walks());
}

TEST_F(ObstacleReflexTest, AWalkTowardsAnObstacleDoesNotBegin) {
  call("ALMotion", "wakeUp");
  putObstacle(0.3);
  const std::vector<std::pair<std::string, std::vector<Value>>> walks_ahead = {
      {"move", {0.09F, 0.0F, 0.0F}},
      {"moveToward", {1.0F, 0.0F, 0.0F}},
      {"moveTo", {0.5F, 0.0F, 0.0F}},
      {"moveTo", {Value::list({Value::list({0.5F, 0.0F, 0.0F})})}}};
  for (const auto& [name, arguments] : walks_ahead) {
    call("ALMotion", name, arguments);
    cycle();
    EXPECT_FALSE(walks()) << name;
    const Value failed = data("ALMotion/MoveFailed");
    EXPECT_EQ(failed.findItems()->at(0), Value("Obstacle detected")) << name;
    EXPECT_EQ(failed.findItems()->at(1), Value(0)) << name;
  }
  EXPECT_TRUE(bench_.gait->calls.empty());
}

TEST_F(ObstacleReflexTest, AWalkAwayFromAnObstacleBegins) {
  call("ALMotion", "wakeUp");
  putObstacle(0.3);
  call("ALMotion", "move", {-0.05F, 0.0F, 0.0F});
  cycle();
  EXPECT_FALSE(bench_.gait->calls.empty());
}

/// The reflex alone, of a robot that says how fast it walks.
class ObstacleReflexAlone : public testing::Test {
 protected:
  ObstacleReflexAlone() {
    reflex_.enable([](const Vec3&, ObstacleReflex::Walk) {});
    reflex_.declare(service_);
  }
  // Whether it stops a walk at this velocity [m/s] with an obstacle 0.3 m ahead.
  bool stops(double velocity) {
    SensorFrame sensors;
    sensors.time = SimTime(std::chrono::seconds(1));
    sensors.angle = JointArray<double>(model_->jointCount());
    for (auto& echoes : sensors.sonar) echoes.fill(0.3);
    ports_->publish(std::make_shared<const SensorFrame>(sensors));
    motion::MotionState state;
    state.time = sensors.time;
    state.move_active = true;
    state.velocity.x = velocity;
    ports_->state.publish(state);
    link_.deliver();
    reflex_.deliver();
    for (const auto& request : ports_->requests.drain()) {
      if (std::holds_alternative<motion::StopMove>(request.action)) return true;
    }
    return false;
  }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h25_v50");
  std::shared_ptr<motion::RobotPorts> ports_ = std::make_shared<motion::RobotPorts>();
  RobotLink link_{model_, ports_};
  ObstacleReflex reflex_{link_};
  rpc::Service service_{"ALMotion", ""};
};

TEST_F(ObstacleReflexAlone, TheFasterAWalkTheFartherOffItStops) { EXPECT_TRUE(stops(0.09)); }

TEST_F(ObstacleReflexAlone, ASlowWalkComesNearer) {
  EXPECT_FALSE(stops(0.02));
  service_.call("setTangentialSecurityDistance", {0.35F});
  EXPECT_TRUE(stops(0.02));
}

TEST_F(ObstacleReflexAlone, NothingStopsAWalkBackwards) { EXPECT_FALSE(stops(-0.05)); }

TEST_F(ObstacleReflexTest, TellsTheNearestObstacle) {
  const std::vector<Value> ahead = {"Move", 2};
  EXPECT_TRUE(call("ALMotion", "getChainClosestObstaclePosition", ahead).findText());
  putObstacle(0.6);
  const auto heard =
      call("ALMotion", "getChainClosestObstaclePosition", ahead).to<std::vector<float>>();
  EXPECT_NEAR(heard[0], 0.6, 0.2);
  call("ALMotion", "_updateObstacles", {Value::list({Value::list({0.2F, 0.1F})})});
  const auto told =
      call("ALMotion", "getChainClosestObstaclePosition", {"Move", 1}).to<std::vector<float>>();
  EXPECT_NEAR(told[1], 0.1, 1e-3);
}

}  // namespace
}  // namespace nao::services
