// The helper for tests of programs in C++, as such tests use it.

#include <usarnaoqi_sdk/gtest.h>

#include <cstdlib>

namespace nao {
namespace {

using usarnaoqi::isAt;
using usarnaoqi::stands;
using usarnaoqi::TestWorld;

class TestWorldTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { ::setenv("USARNAOQI", NAO_PROGRAM, 1); }
};

TEST_F(TestWorldTest, TimePassesOnlyWhenItIsTold) {
  const TestWorld world;
  EXPECT_EQ(world.time(), 0);
  world.step(0.25);
  EXPECT_NEAR(world.time(), 0.25, 1e-9);
}

TEST_F(TestWorldTest, TimeIsInSecondsWhateverThePhysicsStep) {
  const TestWorld world({"--step", "0.001"});
  world.step(0.25);
  EXPECT_NEAR(world.time(), 0.25, 1e-9);
}

TEST_F(TestWorldTest, AWorldThatLogsMuchGoesOn) {
  const TestWorld world;
  AL::ALProxy logger = world.proxy("ALLogger");
  for (int i = 0; i < 100; ++i) {  // 64 kB fill a pipe
    logger.callVoid("error", std::string("test"), std::string(1000, 'x'));
  }
  EXPECT_EQ(world.time(), 0);
}

TEST_F(TestWorldTest, CallsEndWhileTimePasses) {
  const TestWorld world({"--robot", "nao_h25_v50"});
  const AL::ALProxy motion = world.proxy("ALMotion");
  ASSERT_TRUE(world.run(motion, 10, "wakeUp"));
  EXPECT_TRUE(stands(world));
  EXPECT_TRUE(isAt(world, 0, 0, 0.1));
  EXPECT_FALSE(isAt(world, 1, 0, 0.1));
}

TEST_F(TestWorldTest, AFallIsTold) {
  const TestWorld world;
  world.step(0.1);
  world.simulator().callVoid("push", 0.0, 150.0, 0.0, 0.4);
  EXPECT_TRUE(world.runUntil([&] { return !stands(world); }, 5));
}

TEST_F(TestWorldTest, AWorldThatCanNotBeIsRefused) {
  EXPECT_THROW(TestWorld({"--robot", "hal"}), std::runtime_error);
}

}  // namespace
}  // namespace nao
