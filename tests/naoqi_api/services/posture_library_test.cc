#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

class PostureLibraryTest : public ServicesBench {
 protected:
  Value ask(const std::string& method, const std::vector<Value>& arguments = {}) {
    return call("ALRobotPosture", method, arguments);
  }
};

TEST_F(PostureLibraryTest, NumbersTheRobotsPostures) {
  const int crouch = ask("_getIdFromName", {"Crouch"}).to<int>();
  EXPECT_GE(crouch, 0);
  EXPECT_EQ(ask("_getPosture"), Value::list({crouch, "Crouch"}));
  EXPECT_EQ(ask("_isRobotInPostureId", {crouch, 0.2F, 0.2F}), Value(true));
  EXPECT_EQ(ask("_getIdFromName", {"Nowhere"}), Value(-1));
}

TEST_F(PostureLibraryTest, ASavedPostureIsKnownToGoToPosture) {
  call("ALMotion", "wakeUp");
  call("ALMotion", "angleInterpolation", {"HeadYaw", 0.7F, 1.0F, true});
  EXPECT_EQ(ask("_saveCurrentPostureWithName", {500, "Mine"}), Value(true));
  call("ALMotion", "angleInterpolation", {"HeadYaw", 0.0F, 1.0F, true});
  EXPECT_NEAR(number(ask("_getArticularDistanceToPosture", {500})), 0.7, 0.01);
  EXPECT_EQ(ask("goToPosture", {"Mine", 0.5F}), Value(true));
  EXPECT_NEAR(number(ask("_getArticularDistanceToPosture", {500})), 0, 0.01);
  EXPECT_EQ(ask("_erasePosture", {500}), Value(true));
  EXPECT_NE(ask("goToPosture", {"Mine", 0.5F}).print().find("unknown posture"), std::string::npos);
}

TEST_F(PostureLibraryTest, TheRobotsOwnPosturesStayWhatTheyAre) {
  const int crouch = ask("_getIdFromName", {"Crouch"}).to<int>();
  EXPECT_EQ(ask("_saveCurrentPosture", {crouch}), Value(false));
  EXPECT_EQ(ask("_erasePosture", {crouch}), Value(false));
  EXPECT_EQ(ask("_namePosture", {crouch, "Other"}), Value(false));
}

TEST_F(PostureLibraryTest, AllModulesWaitWithAndWithoutATimeOut) {
  call("ALMotion", "wakeUp");
  const auto motion = hub_.findService("ALMotion");
  rpc::Tasks tasks(services_.alarm());
  rpc::Caller caller;
  caller.service = motion.get();
  caller.tasks = &tasks;
  const auto uid = motion->findMethod("rest", {})->uid;
  const auto id = motion->call("__pCall", {uid, Value::list({})}, caller);
  const int task = id.outcome()->value->to<int>();
  const auto waits = motion->call("wait", {task}, caller);
  EXPECT_FALSE(waits.isDone());
  run(6);
  EXPECT_TRUE(waits.isDone());
  EXPECT_TRUE(waits.outcome()->value->isVoid());
  EXPECT_EQ(*motion->call("wait", {task, 100}, caller).outcome()->value, Value(false));
}

}  // namespace
}  // namespace nao::services
