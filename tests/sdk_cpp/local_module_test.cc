// A module's library that the daemon loads: usarnaoqi serve --module.

#include <alcommon/alproxy.h>
#include <alproxies/almotionproxy.h>
#include <gtest/gtest.h>

#include <memory>

#include "tests/core/temporary_folder.h"
#include "tests/sdk_cpp/robot_process.h"

namespace nao {
namespace {

class LocalModuleTest : public testing::Test {
 protected:
  LocalModuleTest() {
    // The daemon is ready before its modules are.
    while (!module_) {
      try {
        module_ = std::make_unique<AL::ALProxy>("CycleModule", "127.0.0.1", robot_.port());
      } catch (const AL::ALError&) {
        continue;
      }
    }
  }

  int cycles() { return module_->call<int>("cycles"); }
  void waitForCycles(int more) {
    for (const int until = cycles() + more; cycles() < until;) continue;
  }

  RobotProcess robot_{{"--module", NAO_CYCLE_MODULE}};
  std::unique_ptr<AL::ALProxy> module_;
};

TEST_F(LocalModuleTest, IsCalledEveryTenMilliseconds) {
  waitForCycles(100);
  EXPECT_EQ(module_->call<int>("worstStep"), 10);
}

TEST_F(LocalModuleTest, HearsTheBeginningAsOftenAsTheEnd) {
  waitForCycles(10);
  EXPECT_LE(std::abs(module_->call<int>("phases")), 1);  // one of the two may be under way
}

// Two servos' errors, and the half of one.
TEST_F(LocalModuleTest, DrivesTheRobotByWhatItSenses) {
  AL::ALMotionProxy motion("127.0.0.1", robot_.port());
  motion.setStiffnesses("Head", 1.0F);
  motion.angleInterpolation("HeadYaw", 0.6F, 1.0F, true);
  waitForCycles(50);
  constexpr float kServo = 0.02F;
  EXPECT_NEAR(motion.getAngles("HeadPitch", true)[0], -0.3F, 2 * kServo);
}

TEST_F(LocalModuleTest, OneThatWaitsForTimeStopsNobodyForLong) {
  module_->callVoid("hang");
  waitForCycles(100);
}

TEST_F(LocalModuleTest, EndsWithTheDaemon) {
  waitForCycles(1);
  robot_.process().interrupt();
  EXPECT_EQ(robot_.process().wait(), 0);
}

TEST(LocalModule, IsLetInWhereOthersNeedAToken) {
  const TemporaryFolder folder;
  Process daemon({NAO_PROGRAM, "serve", "--port", "0", "--auth", folder.write("users", "ada x\n"),
                  "--module", NAO_CYCLE_MODULE});
  EXPECT_NE(daemon.readLineWith("module libcycle_module is there"), "");
}

TEST(LocalModule, ServesTheRobotThatItIsGivenTo) {
  Process daemon({NAO_PROGRAM, "serve", "--port", "0", "--robot", "a=nao_h25_v50", "--robot",
                  "b=nao_h21_v33", "--module", std::string("b=") + NAO_CYCLE_MODULE});
  const auto portOf = [&](const std::string& robot) {
    const std::string line = daemon.readLineWith("ready: " + robot + " ");
    return std::stoi(line.substr(line.rfind(':') + 1));
  };
  const int first = portOf("a"), second = portOf("b");
  std::unique_ptr<AL::ALProxy> module;
  while (!module) {
    try {
      module = std::make_unique<AL::ALProxy>("CycleModule", "127.0.0.1", second);
    } catch (const AL::ALError&) {
    }
  }
  EXPECT_THROW(AL::ALProxy("CycleModule", "127.0.0.1", first), AL::ALError);
}

TEST(LocalModule, ModulesOfTwoRobotsAreRefusedInOneSentence) {
  Process daemon({NAO_PROGRAM, "serve", "--port", "0", "--robot", "a=nao_h25_v50", "--robot",
                  "b=nao_h21_v33", "--module", std::string("b=") + NAO_CYCLE_MODULE, "--module",
                  NAO_CYCLE_MODULE});
  EXPECT_EQ(daemon.wait(), 2);
}

TEST(LocalModule, AFileThatIsNoneIsToldInOneSentence) {
  Process daemon({NAO_PROGRAM, "serve", "--port", "0", "--module", NAO_PROGRAM});
  EXPECT_EQ(daemon.wait(), 2);
}

}  // namespace
}  // namespace nao
