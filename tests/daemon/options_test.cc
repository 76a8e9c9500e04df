#include "daemon/options.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/check.h"

namespace nao::daemon {
namespace {

TEST(Options, ARobotHasANameAndAModel) {
  EXPECT_EQ(parseRobot("a=nao_h21_v33").name, "a");
  EXPECT_EQ(parseRobot("a=nao_h21_v33").model, "nao_h21_v33");
  EXPECT_EQ(parseRobot("nao_h21_v33").name, "nao_h21_v33");
  for (const char* bad : {"", "=x", "x="}) EXPECT_THROW(parseRobot(bad), InputError) << bad;
}

TEST(Options, SpeedIsANumberOrMax) {
  EXPECT_EQ(parseSpeed("2.5"), 2.5);
  EXPECT_TRUE(std::isinf(parseSpeed("max")));
  for (const char* bad : {"", "fast", "0", "-1", "1x", "nan", "inf"}) {
    EXPECT_THROW(parseSpeed(bad), InputError) << bad;
  }
}

}  // namespace
}  // namespace nao::daemon
