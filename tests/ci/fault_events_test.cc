// What breaks in a scenario, seen as its expectations see it.

#include <gtest/gtest.h>

#include <limits>

#include "ci/executor.h"
#include "tests/ci/scenario_files.h"

namespace nao::ci {
namespace {

void expectPassed(const std::string& text) {
  ExecutorSettings settings;
  settings.robots_dir = NAO_SOURCE_DIR "/robots";
  settings.speed = std::numeric_limits<double>::infinity();
  const Result result = execute(loadText(scenarioText(text)), settings);
  for (const Verdict& verdict : result.verdicts) {
    EXPECT_TRUE(verdict.passed) << verdict.expected << ": " << verdict.seen;
  }
  EXPECT_EQ(result.trouble, "");
}

TEST(FaultEvents, BatteryAndHeatAreSeenByMemory) {
  expectPassed(R"(
events:
  - {at: 2, battery: {charge: 0.15}}
  - {at: 2, heat: {joint: HeadYaw, temperature: 90}}
expect:
  - {memory: {key: Device/SubDeviceList/Battery/Charge/Sensor/Value, max: 0.16}, always: [2.1, 10]}
  - {memory: {key: Device/SubDeviceList/Battery/Charge/Sensor/Value, min: 0.9}, always: [0, 1.9]}
  - {event: {key: BatteryLowDetected}, by: [2, 4]}
  - {event: {key: BatteryLowDetected}, never: [0, 2]}
  - {memory: {key: Device/SubDeviceList/HeadYaw/Temperature/Sensor/Value, min: 85}, at: 3}
  - {event: {key: TemperatureDiagnosisErrorChanged, contains: HeadYaw}, by: [2, 4]}
  - {limits: {allow: [heat]}}
)");
}

TEST(FaultEvents, ANoisySensorIsSeenByMemoryWhileItLasts) {
  expectPassed(R"(
events: [{at: 3, noise: {sensor: HeadYaw, sd: 0.5, for: 2}}]
expect:
  - {joint: {joint: HeadYaw, angle: 0, tolerance: 0.1}, always: [0.1, 3]}
  - {memory: {key: Device/SubDeviceList/HeadYaw/Position/Sensor/Value, min: 0.4}, by: [3, 5]}
  - {joint: {joint: HeadYaw, angle: 0, tolerance: 0.1}, always: [5.1, 10]}
)");
}

}  // namespace
}  // namespace nao::ci
