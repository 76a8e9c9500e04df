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

TEST(Options, EveryRobotHasAPortOfItsOwnOrNone) {
  Options options;
  options.port = 65534;
  EXPECT_EQ(portOf(options.port, 0, "--port"), 65534);
  EXPECT_EQ(portOf(options.port, 1, "--port"), 65535);
  try {
    portOf(options.port, 2, "--port");
    FAIL() << "a port above 65535";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("65536"), std::string::npos) << error.what();
  }
  options.port = 0;  // any free one
  EXPECT_EQ(portOf(options.port, 2, "--port"), 0);
}

TEST(Options, SpeedIsANumberOrMax) {
  EXPECT_EQ(parseSpeed("2.5"), 2.5);
  EXPECT_TRUE(std::isinf(parseSpeed("max")));
  for (const char* bad : {"", "fast", "0", "-1", "1x", "nan", "inf"}) {
    EXPECT_THROW(parseSpeed(bad), InputError) << bad;
  }
}

TEST(LolaOption, NamesARobotOrTakesTheFirstThatHasNone) {
  EXPECT_EQ(parseLola("").path, "/tmp/robocup");
  EXPECT_EQ(parseLola("/run/a=b").path, "/run/a=b");
  EXPECT_EQ(parseLola("red=/tmp/r").robot, "red");
  EXPECT_THROW(parseLola("red="), InputError);
  EXPECT_THROW(parseLola("=/tmp/r"), InputError);
  const auto paths = lolaPaths({parseLola("/tmp/1"), parseLola("red=/tmp/r"), parseLola("/tmp/2")},
                               {"red", "blue", "green", "grey"});
  EXPECT_EQ(paths, (std::vector<std::string>{"/tmp/r", "/tmp/1", "/tmp/2", ""}));
}

TEST(LolaOption, RefusesWhatCanNotBe) {
  const auto refused = [](const std::vector<LolaOption>& lola) {
    EXPECT_THROW(lolaPaths(lola, {"red", "blue"}), InputError);
  };
  refused({{"green", "/tmp/g"}});
  refused({{"red", "/tmp/1"}, {"red", "/tmp/2"}});
  refused({{"red", "/tmp/1"}, {"blue", "/tmp/1"}});
  refused({{"", "/tmp/1"}, {"", "/tmp/2"}, {"", "/tmp/3"}});
  EXPECT_EQ(parseLolaBattery("current-first"), wire::LolaBattery::CurrentFirst);
  EXPECT_THROW(parseLolaBattery("charge"), InputError);
}

}  // namespace
}  // namespace nao::daemon
