#include "naoqi_api/services/al_motion_trajectory.h"

#include "naoqi_api/call_error.h"
#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

Value line(float x, float y) { return Value::list({"Line", Value::list({x, y})}); }

TEST(Way, PartsBeginWhereTheOneBeforeHasEnded) {
  const Value turn = Value::list({"Holonomic", line(0.5F, 0), 1.5707964F, 5.0F});
  const auto points = readWay(Value::list({"Composed", turn, turn}));
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[1].x, 0.5, 1e-6);
  EXPECT_NEAR(points[1].y, 0.5, 1e-6);
  EXPECT_NEAR(std::abs(points[1].theta), 3.1416, 1e-3);
}

TEST(Way, AFullCircleComesBack) {
  const auto points = readWay(Value::list({"Circle", Value::list({0.0F, 0.3F}), 6.2831853F}));
  EXPECT_GT(points.size(), 10U);
  EXPECT_NEAR(points.back().x, 0, 1e-5);
  EXPECT_NEAR(points.back().y, 0, 1e-5);
  EXPECT_NEAR(points[points.size() / 2 - 1].y, 0.6, 0.02);
}

TEST(Way, WhatIsNoneIsRefused) {
  EXPECT_THROW(readWay(Value(1)), rpc::CallError);
  EXPECT_THROW(readWay(Value::list({"Spiral", Value::list({1.0F, 1.0F})})), rpc::CallError);
  Value deep = line(1, 0);
  for (int i = 0; i < 100; ++i) deep = Value::list({"Composed", deep});
  EXPECT_THROW(readWay(deep), rpc::CallError);
}

using AlMotionTrajectoryTest = ServicesBench;

TEST_F(AlMotionTrajectoryTest, WalksAlongAWay) {
  call("ALMotion", "wakeUp");
  const Value way = Value::list({"Composed", line(0.2F, 0), line(0, 0.1F)});
  EXPECT_TRUE(call("ALMotion", "_followPath", {way}).isVoid());
  EXPECT_EQ(call("ALMotion", "_getTrajectoryCompletion"), Value(1.0F));
  const auto& calls = bench_.gait->calls;
  EXPECT_EQ(std::count(calls.begin(), calls.end(), "walkTo"), 2);
  EXPECT_NEAR(bench_.gait->target.x, 0, 1e-5);  // of the second stretch, from where the first ends
  EXPECT_NEAR(bench_.gait->target.y, 0.1, 1e-5);
}

TEST_F(AlMotionTrajectoryTest, AWayInTheWorldBeginsWhereItIsSaidTo) {
  call("ALMotion", "wakeUp");
  const Value start = Value::list({0.5F, 0.0F, 0.0F});
  call("ALMotion", "_followPathInWorld", {start, line(0.2F, 0)});
  EXPECT_NEAR(bench_.gait->target.x, 0.7, 1e-5);
}

}  // namespace
}  // namespace nao::services
