#include "ci/executor.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/ci/scenario_files.h"

namespace nao::ci {
namespace {

ExecutorSettings fast() {
  ExecutorSettings settings;
  settings.robots_dir = NAO_SOURCE_DIR "/robots";
  settings.python_path = NAO_SOURCE_DIR "/naoqi_api/sdk/python";
  settings.speed = std::numeric_limits<double>::infinity();
  return settings;
}

Result run(const std::string& text, std::uint64_t seed = 1) {
  return execute(loadText(scenarioText(text), seed), fast());
}

TEST(Executor, LetsEventsHappenAndJudges) {
  const Result result = run(R"(
world: red_ball
events:
  - {at: 1, press: {sensor: Head/Touch/Front, for: 0.2}}
  - {at: 2, place_ball: {position: [0.8, 0, 0.03]}}
  - {at: 4, push: {force: [0, 150, 0], for: 0.4}}
expect:
  - {event: {key: FrontTactilTouched, equals: 1}, by: [0.9, 1.2]}
  - {event: {key: FrontTactilTouched}, never: [0, 0.9]}
  - {memory: {key: Device/SubDeviceList/Head/Touch/Front/Sensor/Value, equals: 1}, at: 1.1}
  - {place: {ball: ball, center: [1.2, 0.3], radius: 0.01}, always: 1.9}
  - {place: {ball: ball, center: [0.8, 0], radius: 0.01}, at: 2.5}
  - {upright: {}, always: 4}
  - {fallen: {}, by: 7}
)");
  for (const Verdict& verdict : result.verdicts) {
    EXPECT_TRUE(verdict.passed) << verdict.expected << ": " << verdict.seen;
  }
  EXPECT_TRUE(result.passed()) << result.trouble;
  EXPECT_EQ(result.time, 10);
  EXPECT_TRUE(result.course.stills.empty());
}

TEST(Executor, KeepsTheSecondsAroundTheFirstFailure) {
  const Result result = run(R"(
events: [{at: 4, push: {force: [0, 150, 0], for: 0.4}}]
expect: [{upright: {}}]
)");
  ASSERT_EQ(result.verdicts.size(), 1u);
  EXPECT_FALSE(result.verdicts[0].passed);
  const double fell = toSeconds(result.verdicts[0].at);
  EXPECT_GT(fell, 4);
  ASSERT_FALSE(result.course.time.empty());
  EXPECT_NEAR(result.course.time.back(), fell + 1, 0.02);  // two beats
  EXPECT_GE(result.course.stills.size(), 8u);              // every half second of four
  ASSERT_EQ(result.course.robots.size(), 1u);
  EXPECT_EQ(result.course.robots[0].x.size(), result.course.time.size());
}

TEST(Executor, IsTheSameForOneSeedToTheLastBit) {
  const char* const text =
      "expect: [{upright: {}}]\nevents: [{at: 1, push: {force: [9, 0, 0], for: 1}}]\n";
  const Result one = run(text, 5);
  EXPECT_EQ(run(text, 5).hash, one.hash);
  EXPECT_NE(run(text, 6).hash, one.hash);
}

TEST(Executor, EndsClientsThatDoNotEnd) {
  const TemporaryFolder folder;
  const std::string file = folder.write("s.yaml", scenarioText("clients: [{run: sleep 1000}]\n"));
  const Result result = execute(loadScenario(file, 1, shippedPlaces()), fast());
  ASSERT_EQ(result.verdicts.size(), 1u);
  EXPECT_FALSE(result.verdicts[0].passed);
  EXPECT_EQ(result.verdicts[0].seen, "it did not happen");
}

}  // namespace
}  // namespace nao::ci
