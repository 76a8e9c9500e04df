#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/ci/scenario_files.h"

namespace nao::ci {
namespace {

const char* const kPushed = R"(
spread: {push: [10, 20], mu: [0.3, 0.9]}
ground: {friction: $mu}
events: [{at: 1, push: {force: [$push, 0, 0], for: 0.1}}]
expect: [{upright: {}}]
)";

double pushOf(const Scenario& scenario) {
  return std::get<runtime::PushRobot>(requestOf(scenario.events.at(0))).force_W.x();
}

TEST(Spread, PutsItsNumbersWhereTheyAreNamed) {
  const Scenario scenario = loadText(scenarioText(kPushed), 7);
  EXPECT_EQ(scenario.drawn.at("push"), pushOf(scenario));
  EXPECT_EQ(scenario.drawn.at("mu"), scenario.world->ground.friction);
  EXPECT_GE(pushOf(scenario), 10);
  EXPECT_LE(pushOf(scenario), 20);
}

TEST(Spread, IsTheSameForOneSeedAndAnotherForAnother) {
  const double first = pushOf(loadText(scenarioText(kPushed), 7));
  EXPECT_EQ(pushOf(loadText(scenarioText(kPushed), 7)), first);
  EXPECT_NE(pushOf(loadText(scenarioText(kPushed), 8)), first);
}

std::string complaintAbout(const std::string& text) {
  const TemporaryFolder folder;
  try {
    loadScenario(folder.write("s.yaml", scenarioText(text)), 1, shippedPlaces());
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return "";
}

TEST(Spread, RefusesNamesThatAreNotThereAndThoseThatNobodyUses) {
  EXPECT_EQ(complaintAbout("ground: {friction: $mu}\nexpect: [{upright: {}}]\n"),
            "s.yaml:3: there is no 'mu' in `spread`");
  EXPECT_EQ(complaintAbout("spread: {mu: [0, 1]}\nexpect: [{upright: {}}]\n"),
            "s.yaml:1: `spread`: nothing uses $mu");
  EXPECT_EQ(complaintAbout("spread: {mu: [2, 1]}\nground: {friction: $mu}\n"),
            "s.yaml:3: `mu`: expected [low, high]");
}

}  // namespace
}  // namespace nao::ci
