#include "validation/log/log_robots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/check.h"

namespace nao::validation {
namespace {

using testing::ElementsAre;

LogSet setOf(const std::vector<std::string>& robots) {
  LogSet set;
  set.name = "mine";
  for (const std::string& robot : robots) {
    set.runs.emplace_back();
    set.runs.back().robot_id = robot;
  }
  return set;
}

TEST(LogRobots, AreListedInTheOrderOfTheirFirstRuns) {
  const LogSet set = setOf({"b", "a", "b"});
  EXPECT_THAT(robotsOf(set), ElementsAre("b", "a"));
  EXPECT_EQ(runsOf(set, "b").runs.size(), 2u);
}

TEST(LogRobots, OneOfSeveralIsAskedForUnlessTheyHang) {
  EXPECT_EQ(runsOfOne(setOf({"a", "a"}), "").runs.size(), 2u);
  LogSet set = setOf({"a", "b"});
  EXPECT_EQ(runsOfOne(set, "b").runs.size(), 1u);
  try {
    runsOfOne(set, "");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "mine: --robot-id: expected one of a, b, found ''");
  }
  set.environment.suspended = true;
  EXPECT_EQ(runsOfOne(set, "").runs.size(), 2u);
}

}  // namespace
}  // namespace nao::validation
