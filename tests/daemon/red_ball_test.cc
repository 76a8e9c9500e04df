// A ball in the world, rendered by the camera and found in its pictures, from end to end.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/daemon/running_daemon.h"
#include "tests/daemon/tcp_client.h"

namespace nao::daemon {
namespace {

using rpc::Value;

class RedBallTest : public testing::Test {
 protected:
  Value call(const std::string& service, const std::string& method, std::vector<Value> arguments,
             const std::string& returns) {
    return client_.result(service, method, std::move(arguments), returns);
  }
  double simulatedTime() { return *call("UsarSim", "time", {}, "d").find<double>(); }

  Running running_{withRedBall()};
  TcpClient client_{running_.port()};
};

TEST_F(RedBallTest, TheBallInTheWorldIsDetectedWhereItLies) {
  call("ALRedBallDetection", "subscribe", {"test"}, "v");
  const double end = simulatedTime() + 10;
  Value seen = "";
  while (seen.findItems() == nullptr && simulatedTime() < end) {
    seen = call("ALMemory", "getData", {"redBallDetected"}, "m");
  }
  ASSERT_TRUE(seen.findItems()) << seen.print();
  // [time, [yaw, pitch, width, height], ...]: the ball is 1.2 m ahead and 0.3 m to the left.
  const auto angles = seen.findItems()->at(1).to<std::vector<double>>();
  ASSERT_EQ(angles.size(), 4U);
  EXPECT_NEAR(angles[0], std::atan2(0.3, 1.2), 0.06);
  EXPECT_GT(angles[2], 0.02);
}

}  // namespace
}  // namespace nao::daemon
