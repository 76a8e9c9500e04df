// What UsarSim tells of pictures beyond what the robot's cameras do.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/daemon/running_daemon.h"
#include "tests/daemon/tcp_client.h"

namespace nao::daemon {
namespace {

using rpc::Value;

class CameraTruthTest : public testing::Test {
 protected:
  Value call(const std::string& method, std::vector<Value> arguments, const std::string& returns) {
    return client_.result("UsarSim", method, std::move(arguments), returns);
  }

  Running running_{withRedBall()};
  TcpClient client_{running_.port()};
};

TEST_F(CameraTruthTest, DepthLabelsAndBoxesAgree) {
  call("pause", {}, "v");
  const auto names = call("labelNames", {}, "[s]").to<std::vector<std::string>>();
  const auto ball = std::find(names.begin(), names.end(), "ball") - names.begin();
  ASSERT_LT(ball, static_cast<long>(names.size()));
  const auto depth = call("depthImage", {0, 1}, "m").to<std::vector<Value>>();
  const auto labels = call("labelImage", {0, 1}, "m").to<std::vector<Value>>();
  const auto boxes = call("objectBoxes", {0, 1}, "m").to<std::vector<Value>>();
  ASSERT_EQ(depth[0], Value(320));
  ASSERT_EQ(depth[2].findBytes()->size(), 320u * 240 * 4);
  ASSERT_EQ(labels[2].findBytes()->size(), 320u * 240 * 2);
  std::vector<Value> found;
  for (const Value& box : boxes) {
    if (box.findItems()->at(0) == Value("ball")) found = *box.findItems();
  }
  ASSERT_EQ(found.size(), 6u);
  const int column = found[1].to<int>() + found[3].to<int>() / 2;
  const int row = found[2].to<int>() + found[4].to<int>() / 2;
  const std::size_t at = static_cast<std::size_t>(row) * 320 + column;
  const auto& bytes = *labels[2].findBytes();
  EXPECT_EQ(bytes[2 * at] + 256 * bytes[2 * at + 1], ball);
  float metres = 0;
  std::memcpy(&metres, depth[2].findBytes()->data() + 4 * at, 4);
  EXPECT_NEAR(metres, 1.2, 0.15);  // the ball lies 1.2 m ahead, the camera looks slightly down
}

TEST_F(CameraTruthTest, WhatDoesNotExistIsAnError) {
  const auto complaint = [&](const std::string& method, std::vector<Value> arguments) {
    return call(method, std::move(arguments), "m").print();
  };
  EXPECT_NE(complaint("depthImage", {7, 1}).find("no camera 7"), std::string::npos);
  EXPECT_NE(complaint("objectBoxes", {0, 99}).find("no resolution 99"), std::string::npos);
  EXPECT_NE(complaint("setCameraEffects", {0, rpc::toValue(std::vector<std::string>{"fog"})})
                .find("no camera effect fog"),
            std::string::npos);
}

}  // namespace
}  // namespace nao::daemon
