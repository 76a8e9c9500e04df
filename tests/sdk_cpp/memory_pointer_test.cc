// Pointers to ALMemory, as a local module has them: usarnaoqi serve --module.

#include <alcommon/alproxy.h>
#include <alproxies/almemoryproxy.h>
#include <alproxies/almotionproxy.h>
#include <gtest/gtest.h>

#include <memory>

#include "tests/sdk_cpp/robot_process.h"

namespace nao {
namespace {

class MemoryPointerTest : public testing::Test {
 protected:
  MemoryPointerTest() {
    while (!module_) {  // the daemon is ready before its modules are
      try {
        module_ = std::make_unique<AL::ALProxy>("MemoryModule", "127.0.0.1", robot_.port());
      } catch (const AL::ALError&) {
        continue;
      }
    }
  }

  void waitForCycles(int more) {
    for (const int until = cycles() + more; cycles() < until;) continue;
  }
  int cycles() { return module_->call<int>("cycles"); }

  RobotProcess robot_{{"--module", NAO_MEMORY_MODULE}};
  std::unique_ptr<AL::ALProxy> module_;
};

TEST_F(MemoryPointerTest, FollowsASensorInEveryCycle) {
  AL::ALMotionProxy motion("127.0.0.1", robot_.port());
  motion.setStiffnesses("Head", 1.0F);
  motion.angleInterpolation("HeadYaw", 0.6F, 1.0F, true);
  EXPECT_GT(cycles(), 50);
  EXPECT_EQ(module_->call<int>("differences"), 0);
}

TEST_F(MemoryPointerTest, WhatIsWrittenThereIsInMemory) {
  AL::ALMemoryProxy memory("127.0.0.1", robot_.port());
  waitForCycles(2);
  const int counted = memory.getData("MemoryModule/Count");
  EXPECT_GT(counted, 0);
  waitForCycles(5);
  EXPECT_GE(static_cast<int>(memory.getData("MemoryModule/Count")), counted + 4);
}

TEST_F(MemoryPointerTest, OnlyNumbersThatAreThereHaveOne) {
  AL::ALMemoryProxy memory("127.0.0.1", robot_.port());
  memory.insertData("Test/Text", std::string("a"));
  memory.insertData("Test/Number", 1);
  EXPECT_TRUE(module_->call<bool>("refuses", "No/Such/Key"));
  EXPECT_TRUE(module_->call<bool>("refuses", "Test/Text"));
  EXPECT_FALSE(module_->call<bool>("refuses", "Test/Number"));
}

}  // namespace
}  // namespace nao
