#include "naoqi_api/services/al_behavior_manager.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/check.h"
#include "naoqi_api/services/al_animation_player.h"
#include "naoqi_api/services/al_motion.h"
#include "tests/core/temporary_folder.h"
#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

using rpc::Value;
using Names = std::vector<std::string>;

const char* const kScripted =
    "<ChoregrapheProject xar_version=\"3\"><Box name=\"root\" id=\"-1\"><script language=\"4\">"
    "<content>print(1)</content></script><Timeline enable=\"1\" fps=\"10\" start_frame=\"0\">"
    "<ActuatorList><ActuatorCurve actuator=\"HeadYaw\" unit=\"0\"><Key frame=\"20\" value=\"30\"/>"
    "</ActuatorCurve></ActuatorList></Timeline></Box></ChoregrapheProject>";

std::string headTo(const char* angle) {
  return std::string("#WEBOTS_MOTION,V1.0,HeadYaw\n00:01:000,a,") + angle + "\n";
}

class Behaviors : public testing::Test {
 protected:
  Behaviors() {
    folder.write("look.motion", headTo("0.5"));
    folder.write("Stand/left.motion", headTo("0.4"));
    folder.write("Stand/right.motion", headTo("-0.4"));
    folder.write("pack/behavior_1/behavior.xar", kScripted);
    folder.write("pack/manifest.xml",
                 "<package><contents><behaviorContent path=\"behavior_1\"><nature>solitary</nature>"
                 "<tags><tag lang=\"en_US\">look</tag><tag>look around</tag></tags>"
                 "</behaviorContent><behaviorContent path=\"gone\"/></contents></package>");
    folder.write("Stand/manifest.xml", "no manifest");
    folder.write("broken.xar", "<ChoregrapheProject>\n<Box");
    folder.write("notes.txt", "no motion");
    auto library = std::make_shared<BehaviorLibrary>();
    library->addFolder(folder.path());
    BehaviorRunner::Hooks hooks;
    hooks.warn = [this](const std::string& text) { warnings.push_back(text); };
    hooks.running_changed = [this](const Names& running) { events.push_back(running); };
    runner = std::make_shared<BehaviorRunner>(bench.link, library, hooks);
    manager = makeAlBehaviorManager(runner);
    player = makeAlAnimationPlayer(runner);
    bench.cycle();
    bench.call(*makeAlMotion(bench.link), "setStiffnesses", {"Body", 1.0F});
  }
  Value call(const std::string& name, const std::vector<Value>& arguments = {}) {
    return bench.call(*manager, name, arguments);
  }
  double yaw() const { return bench.link.state()->command.angle[0]; }

  TemporaryFolder folder;
  RobotBench bench;
  Names warnings;
  std::vector<Names> events;
  std::shared_ptr<BehaviorRunner> runner;
  std::shared_ptr<rpc::Service> manager, player;
};

TEST_F(Behaviors, AreNamedAfterTheirPlaceInTheFolder) {
  EXPECT_EQ(call("getInstalledBehaviors").to<Names>(),
            (Names{"Stand/left", "Stand/right", "broken", "look", "pack/behavior_1"}));
  EXPECT_TRUE(call("isBehaviorInstalled", {"look"}).to<bool>());
  EXPECT_FALSE(call("isBehaviorInstalled", {"notes"}).to<bool>());
}

TEST_F(Behaviors, AreFoundByWhatClientsCallThem) {
  for (const char* name : {"pack", "behavior_1", "User/pack/behavior_1", "pack/behavior_1"}) {
    EXPECT_EQ(*call("resolveBehaviorName", {name}).findText(), "pack/behavior_1") << name;
  }
  EXPECT_FALSE(call("isBehaviorInstalled", {"Stand"}).to<bool>());  // which of the two?
  EXPECT_FALSE(call("isBehaviorInstalled", {""}).to<bool>());
}

TEST_F(Behaviors, RunBehaviorWaitsForTheEnd) {
  const auto run = manager->call("runBehavior", {"look"});
  bench.run(0.5);
  EXPECT_FALSE(run.isDone());
  EXPECT_TRUE(call("isBehaviorRunning", {"look"}).to<bool>());
  EXPECT_EQ(call("getRunningBehaviors").to<Names>(), Names{"look"});
  bench.run(0.6);
  EXPECT_TRUE(run.isDone());
  EXPECT_NEAR(yaw(), 0.5, 1e-9);
  EXPECT_TRUE(call("getRunningBehaviors").to<Names>().empty());
  EXPECT_EQ(events, (std::vector<Names>{{"look"}, {}}));
}

TEST_F(Behaviors, StartBehaviorDoesNotWaitAndStopEndsIt) {
  EXPECT_TRUE(manager->call("startBehavior", {"look"}).isDone());
  bench.run(0.5);
  call("stopBehavior", {"look"});
  bench.run(0.1);
  EXPECT_FALSE(call("isBehaviorRunning", {"look"}).to<bool>());
  EXPECT_LT(yaw(), 0.4);
}

TEST_F(Behaviors, RunAgainFromTheBeginning) {
  call("runBehavior", {"Stand/left"});
  call("runBehavior", {"Stand/right"});
  call("runBehavior", {"Stand/left"});
  EXPECT_NEAR(yaw(), 0.4, 1e-9);
}

TEST_F(Behaviors, StopAllEndsAnimationsToo) {
  const auto run = player->call("run", {"look"});
  bench.run(0.2);
  call("stopAllBehaviors");
  bench.run(0.1);
  EXPECT_TRUE(run.isDone());
  EXPECT_TRUE(call("getRunningBehaviors").to<Names>().empty());
}

TEST_F(Behaviors, ScriptsAreReportedAndTheTimelineIsPlayed) {
  call("runBehavior", {"pack"});
  EXPECT_NEAR(yaw(), 30 * M_PI / 180, 1e-9);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("the script of the box \"root\" is not run"), std::string::npos);
}

TEST_F(Behaviors, WhatIsWrongIsToldToTheClient) {
  EXPECT_EQ(bench.errorOf(*manager, "runBehavior", {"dance"}),
            "\tALBehaviorManager::runBehavior\n\tno behavior \"dance\" is installed; "
            "getInstalledBehaviors lists those there are");
  const std::string broken = bench.errorOf(*manager, "startBehavior", {"broken"});
  EXPECT_NE(broken.find("broken.xar:2: no well-formed XML"), std::string::npos) << broken;
  EXPECT_FALSE(call("preloadBehavior", {"dance"}).to<bool>());
}

TEST_F(Behaviors, CodeRunsWhereItIsAllowedAndStopsWhenAsked) {
  std::vector<std::string> launched;
  std::function<void(const std::string&)> ended;
  int asked_to_end = 0;
  BehaviorRunner::Hooks hooks;
  hooks.running_changed = [this](const Names& running) { events.push_back(running); };
  hooks.run_code = [&](const std::filesystem::path& file, auto when_ended) {
    launched.push_back(file.filename().string());
    ended = std::move(when_ended);
    return [&asked_to_end] { ++asked_to_end; };
  };
  auto library = std::make_shared<BehaviorLibrary>(runner->library());
  const auto scripted = std::make_shared<BehaviorRunner>(bench.link, library, hooks);
  const auto service = makeAlBehaviorManager(scripted);

  const auto run = service->call("runBehavior", {"pack"});
  EXPECT_EQ(launched, Names{"behavior.xar"});
  EXPECT_FALSE(run.isDone());
  EXPECT_EQ(events, std::vector<Names>{{"pack/behavior_1"}});
  bench.call(*service, "stopBehavior", {"pack"});
  EXPECT_EQ(asked_to_end, 1);
  EXPECT_FALSE(run.isDone());
  ended("");
  EXPECT_TRUE(run.isDone());
  EXPECT_TRUE(events.back().empty());

  const auto failing = service->call("runBehavior", {"pack"});
  ended("it broke");
  EXPECT_TRUE(failing.isDone());
  // Without code it is a motion, as always.
  bench.call(*service, "runBehavior", {"look"});
  EXPECT_EQ(launched.size(), 2u);
  EXPECT_NEAR(yaw(), 0.5, 1e-9);
}

TEST_F(Behaviors, TagsAndNatureAreThoseOfThePackagesManifest) {
  EXPECT_EQ(call("getTagList").to<Names>(), (Names{"look", "look around"}));
  EXPECT_EQ(call("getBehaviorTags", {"pack"}).to<Names>(), (Names{"look", "look around"}));
  EXPECT_EQ(call("getBehaviorsByTag", {"look around"}).to<Names>(), Names{"pack/behavior_1"});
  EXPECT_TRUE(call("getBehaviorTags", {"look"}).to<Names>().empty());
  EXPECT_EQ(*call("getBehaviorNature", {"pack"}).findText(), "solitary");
  EXPECT_EQ(*call("getBehaviorNature", {"look"}).findText(), "interactive");
  bench.call(*player, "runTag", {"look around"});
  EXPECT_NEAR(yaw(), 30 * M_PI / 180, 1e-9);
}

TEST_F(Behaviors, ARemovedBehaviorEndsAndIsForgotten) {
  const auto run = manager->call("runBehavior", {"look"});
  call("addDefaultBehavior", {"look"});
  bench.run(0.2);
  EXPECT_TRUE(call("removeBehavior", {"look"}).to<bool>());
  EXPECT_TRUE(run.isDone());
  bench.run(1.5);
  EXPECT_LT(yaw(), 0.2);
  EXPECT_FALSE(call("isBehaviorInstalled", {"look"}).to<bool>());
  EXPECT_TRUE(call("getDefaultBehaviors").to<Names>().empty());
  EXPECT_FALSE(call("removeBehavior", {"look"}).to<bool>());
  EXPECT_NE(bench.errorOf(*manager, "installBehavior", {"look"}).find("--behaviors"),
            std::string::npos);
}

TEST_F(Behaviors, DefaultsAreStartedTogether) {
  call("addDefaultBehavior", {"look"});
  call("addDefaultBehavior", {"look"});
  EXPECT_EQ(call("getDefaultBehaviors").to<Names>(), Names{"look"});
  call("playDefaultProject");
  EXPECT_TRUE(call("isBehaviorRunning", {"look"}).to<bool>());
  call("removeDefaultBehavior", {"look"});
  EXPECT_TRUE(call("getDefaultBehaviors").to<Names>().empty());
}

TEST_F(Behaviors, AnimationsOfATagAreTakenInTurn) {
  bench.call(*player, "runTag", {"Stand"});
  EXPECT_NEAR(yaw(), 0.4, 1e-9);
  bench.call(*player, "runTag", {"Stand"});
  EXPECT_NEAR(yaw(), -0.4, 1e-9);
}

TEST_F(Behaviors, ATagCanBeGivenAndForgotten) {
  bench.call(*player, "addTagForAnimations",
             {rpc::toValue(std::map<std::string, Names>{{"hello", {"look"}}})});
  bench.call(*player, "runTag", {"hello"});
  EXPECT_NEAR(yaw(), 0.5, 1e-9);
  bench.call(*player, "reset", {});
  EXPECT_NE(bench.errorOf(*player, "runTag", {"hello"}).find("no animation of this robot has"),
            std::string::npos);
}

TEST_F(Behaviors, AnimationsAreAlsoFoundBelowADeclaredPath) {
  EXPECT_EQ(bench.errorOf(*player, "run", {"animations/Sit/left"}),
            "\tALAnimationPlayer::run\n\tthe animation \"animations/Sit/left\" is not on this "
            "robot; ALBehaviorManager.getInstalledBehaviors lists those there are");
  bench.call(*player, "declarePathForTags", {"Stand"});
  bench.call(*player, "run", {"left"});
  EXPECT_NEAR(yaw(), 0.4, 1e-9);
}

TEST(BehaviorLibrary, AFolderThatIsNoneIsRefused) {
  EXPECT_THROW(BehaviorLibrary().addFolder("/nowhere/at/all"), InputError);
}

}  // namespace
}  // namespace nao::services
