#include <gtest/gtest.h>

#include <filesystem>

#include "core/check.h"
#include "tests/ci/scenario_files.h"

namespace nao::ci {
namespace {

std::string complaintAbout(const std::string& text) {
  const TemporaryFolder folder;
  try {
    loadScenario(folder.write("s.yaml", text), 1, shippedPlaces());
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return "";
}

TEST(ScenarioFile, GivesWhatItDoesNotSayItsUsualValue) {
  const Scenario scenario = loadText(scenarioText("expect: [{upright: {}}]\n"));
  EXPECT_EQ(scenario.name, "s");
  ASSERT_EQ(scenario.robots.size(), 1u);
  EXPECT_EQ(scenario.robots[0].name, "nao");
  EXPECT_EQ(scenario.world->name, "empty");
  ASSERT_EQ(scenario.expectations.size(), 1u);
  EXPECT_EQ(scenario.expectations[0].text, "nao upright always until 10 s");
}

TEST(ScenarioFile, ReadsWorldRobotsClientsEventsAndExpectations) {
  const Scenario scenario = loadText(scenarioText(R"(
world: red_ball
ground: {friction: 0.2}
robots:
  - {name: a, model: nao_h25_v50, start: [1, 2, 0.5], effects: [{effect: backlash, play: 0.02}]}
  - {name: b}
clients:
  - {name: one, robot: b, run: python3 walk.py 1}
  - {name: two, run: [sh, -c, exit 3], background: true}
events:
  - {at: 3, push: {robot: b, force: [0, 9, 0], for: 0.2}}
  - {at: 1, press: {sensor: Head/Touch/Front, for: 0.1}}
expect:
  - {place: {robot: b, center: [1, 0], radius: 0.2}, by: [2, 5]}
)"));
  EXPECT_EQ(scenario.world->ground.friction, 0.2);
  ASSERT_EQ(scenario.robots.size(), 2u);
  EXPECT_EQ(scenario.robots[0].start.y, 2);
  ASSERT_EQ(scenario.robots[0].effects.size(), 1u);
  ASSERT_EQ(scenario.clients.size(), 2u);
  EXPECT_EQ(scenario.clients[0].robot, 1u);
  EXPECT_EQ(scenario.clients[0].command.size(), 3u);
  EXPECT_EQ(scenario.clients[1].command[2], "exit 3");
  ASSERT_EQ(scenario.events.size(), 2u);
  EXPECT_TRUE(
      std::holds_alternative<runtime::PressSensor>(requestOf(scenario.events[0])));  // by time
  EXPECT_EQ(std::get<runtime::PushRobot>(requestOf(scenario.events[1])).robot, 1u);
  ASSERT_EQ(scenario.expectations.size(), 2u);
  EXPECT_EQ(scenario.expectations[0].text, "b within 0.2 m of (1, 0) once from 2 s to 5 s");
  EXPECT_EQ(scenario.expectations[1].text, "one ends with exit code 0 by 10 s");
}

TEST(ScenarioFile, TellsFileLineAndReasonOfWhatIsBroken) {
  const std::string fine = "expect: [{upright: {}}]\n";
  const struct {
    std::string text, complaint;
  } kBroken[] = {
      {"about: A\n" + fine, "s.yaml:1: `duration`: missing, expected a number in [0.01, 3600]"},
      {"about: A\nduration: long\n" + fine,
       "s.yaml:2: `duration`: expected a number in [0.01, 3600], found 'long'"},
      {scenarioText("expct: []\n" + fine), "s.yaml:3: `expct`: unknown key, expected one of"},
      {scenarioText("world: moon\n" + fine), "s.yaml:3: `world`: expected the name of a world in"},
      {scenarioText("robots: [{model: hal}]\n" + fine), "s.yaml:3: `model`: expected a robot in"},
      {scenarioText("robots: [{name: a}, {name: a}]\n" + fine),
       "s.yaml:3: `name`: 'a' is given twice"},
      {scenarioText("clients: [{run: x, robot: b}]\n" + fine),
       "s.yaml:3: `robot`: expected the name of one of `robots`, found 'b'"},
      {scenarioText("events:\n- {at: 1, shove: {}}\n" + fine),
       "s.yaml:4: `shove`: unknown, expected one of push, press,"},
      {scenarioText("events:\n- {at: 11, push: {force: [1, 0, 0], for: 1}}\n" + fine),
       "s.yaml:4: `at`: expected a number in [0, 10], found '11'"},
      {scenarioText("events:\n- {at: 1, push: {force: [1, 0], for: 1}}\n" + fine),
       "s.yaml:4: `force`: expected a list of 3 numbers, found 2"},
      {scenarioText("events:\n- {at: 1, press: {sensor: Nose, for: 1}}\n" + fine),
       "s.yaml:4: `sensor`: expected a button, bumper or tactile sensor of nao, found 'Nose'"},
      {scenarioText("events:\n- {at: 1, place_ball: {position: [0, 0, 0]}}\n" + fine),
       "s.yaml:4: this world has no ball"},
      {scenarioText("expect:\n- {joint: {joint: Tail, angle: 0, tolerance: 1}, at: 1}\n"),
       "s.yaml:4: `joint`: expected a joint of nao_h21_v33, found 'Tail'"},
      {scenarioText("expect:\n- {memory: {key: A, min: 1}}\n"),
       "s.yaml:4: expected when: at, by, always or never"},
      {scenarioText("expect:\n- {memory: {key: A}, by: 3}\n"),
       "s.yaml:4: expected equals, contains, min or max"},
      {scenarioText("expect:\n- {event: {key: A}, at: 3}\n"),
       "s.yaml:4: `at`: this happens in a moment, expected by or never"},
      {scenarioText("expect:\n- {upright: {}, by: 3, never: 4}\n"),
       "s.yaml:4: `never`: there is `by` already"},
      {scenarioText("expect:\n- {upright: {}, fallen: {}}\n"),
       "s.yaml:4: `fallen`: one entry is about one thing, see `upright` there"},
      {scenarioText("expect:\n- {limits: {allow: [all]}}\n"),
       "s.yaml:4: `allow`: expected some of"},
      {scenarioText("expect:\n- {exit: {client: a}}\n"), "s.yaml:4: this scenario has no clients"},
      {scenarioText("events: []\n"), "s.yaml:1: `expect`: nothing is expected"},
      {"- a\n", "s.yaml:1: expected keys, found a list"},
      {"about: [\n", "s.yaml:"},
  };
  for (const auto& [text, complaint] : kBroken) {
    EXPECT_EQ(complaintAbout(text).rfind(complaint, 0), 0u)
        << "found:    " << complaintAbout(text) << "\nexpected: " << complaint;
  }
}

TEST(ScenarioFile, EveryShippedScenarioIsWhole) {
  int found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(NAO_SOURCE_DIR "/scenarios")) {
    if (entry.path().extension() != ".yaml") continue;
    ++found;
    for (const auto seed : loadSeeds(entry.path())) {
      EXPECT_NO_THROW(loadScenario(entry.path(), seed, shippedPlaces())) << entry.path();
    }
  }
  EXPECT_GE(found, 1);
}

}  // namespace
}  // namespace nao::ci
