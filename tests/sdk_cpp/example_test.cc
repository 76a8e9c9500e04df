// examples/cpp_*.cc, run as their first comment says.

#include <alcommon/alproxy.h>
#include <alproxies/almemoryproxy.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/sdk_cpp/robot_process.h"

namespace nao {
namespace {

TEST(CppExample, MotionWalksAndEnds) {
  const RobotProcess robot;
  Process example({NAO_CPP_MOTION, "127.0.0.1", std::to_string(robot.port())});
  const std::string line = example.readLineWith("walked ");
  EXPECT_EQ(example.wait(), 0);
  // As well as its odometry knows on a perfect floor.
  EXPECT_NEAR(std::atof(line.substr(7).c_str()), 0.2, 0.02) << line;
}

TEST(CppExample, AnAddressIsRedirectedByTheEnvironment) {
  const RobotProcess robot;
  Process example({NAO_CPP_MOTION, "nao.invalid"}, {robot.setting()});
  EXPECT_EQ(example.wait(), 0);
}

TEST(CppExample, ARemoteModuleIsCalledAndTouched) {
  const RobotProcess robot;
  Process example(
      {NAO_CPP_REMOTE_MODULE, "--pip", "127.0.0.1", "--pport", std::to_string(robot.port())});
  ASSERT_EQ(example.readLine(), "ready");
  AL::ALProxy greeter("Greeter", "127.0.0.1", robot.port());
  EXPECT_EQ(greeter.call<int>("greet", "Ada"), 1);
  AL::ALMemoryProxy("127.0.0.1", robot.port()).raiseEvent("FrontTactilTouched", 1.0F);
  EXPECT_EQ(example.readLine(), "touched, 2");
  example.interrupt();
  EXPECT_EQ(example.wait(), 0);
}

}  // namespace
}  // namespace nao
