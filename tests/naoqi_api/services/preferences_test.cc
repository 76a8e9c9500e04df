// What outlives the daemon: preferences, the boards' own, libraries of postures.

#include "naoqi_api/services/preferences.h"

#include "tests/core/temporary_folder.h"
#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

/// A robot from its start to its end, with clients' files in a folder.
class Robot : public ServicesBench {
 public:
  explicit Robot(const TemporaryFolder& folder) : ServicesBench(folder.path()) {}
  void TestBody() override {}
  using ServicesBench::bench_;
  using ServicesBench::call;
  using ServicesBench::data;
  using ServicesBench::number;
  using ServicesBench::run;
  using ServicesBench::start;
};

std::string contentOf(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class KeptTest : public testing::Test {
 protected:
  std::string preferences() const { return contentOf(folder_.path() + "/preferences/nao.jsonl"); }
  TemporaryFolder folder_;
};

TEST_F(KeptTest, PreferencesOutliveTheDaemon) {
  {
    Robot robot(folder_);
    robot.call("ALPreferenceManager", "setValue", {"com.example", "volume", 7});
    robot.call("ALPreferenceManager", "setValue", {"com.example", "names", Value::list({"a", 2})});
    robot.call("ALPreferences", "writePrefFile", {"walk", Value::list({"x"}), true});
  }
  Robot robot(folder_);
  EXPECT_EQ(robot.call("ALPreferenceManager", "getValue", {"com.example", "volume"}), Value(7));
  EXPECT_EQ(robot.call("ALPreferenceManager", "getValue", {"com.example", "names"}),
            Value::list({"a", 2}));
  EXPECT_EQ(robot.call("ALPreferences", "readPrefFile", {"walk", true}), Value::list({"x"}));
}

TEST_F(KeptTest, TheFileIsThereSoonAndSaysWhatItIs) {
  Robot robot(folder_);
  robot.call("ALPreferenceManager", "setValue", {"com.example", "volume", 7});
  EXPECT_EQ(preferences(), "");
  robot.run(1.1);
  EXPECT_EQ(preferences(),
            "{\"format\":\"usarnaoqi preferences\",\"version\":1}\n"
            "{\"domain\":\"com.example\",\"key\":\"volume\",\"value\":7}\n");
}

TEST_F(KeptTest, WhatIsRemovedIsGoneAlsoNextTime) {
  {
    Robot robot(folder_);
    robot.call("ALPreferenceManager", "setValue", {"a", "x", 1});
    robot.call("ALPreferenceManager", "setValue", {"b", "y", 2});
    robot.call("ALPreferenceManager", "removeDomainValues", {"a"});
  }
  Robot robot(folder_);
  EXPECT_EQ(robot.call("ALPreferenceManager", "getDomainList"), Value::listOf("s", {"b"}));
}

/// Preferences of a folder, with what they warn of.
class PreferencesTest : public testing::Test {
 protected:
  PreferencesTest() : link_(model_, std::make_shared<motion::RobotPorts>()) {}
  std::shared_ptr<Preferences> open() {
    ServiceContext context{link_,
                           memory_,
                           [](Duration, const auto&) {},
                           {},
                           [this](const std::string& text) { warnings_.push_back(text); },
                           folder_.path(),
                           "nao"};
    return std::make_shared<Preferences>(context, "p.jsonl");
  }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h25_v50");
  RobotLink link_;
  memory::RobotMemory memory_{*model_, std::make_shared<motion::RobotPorts>(), "nao",
                              [] { return Duration(); }};
  TemporaryFolder folder_;
  std::vector<std::string> warnings_;
};

TEST_F(PreferencesTest, ABrokenFileIsOneSentenceAndIsPutAside) {
  folder_.write("p.jsonl",
                "{\"format\":\"usarnaoqi preferences\",\"version\":1}\n{\"domain\":\"a\"}\n");
  const auto preferences = open();
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_EQ(
      warnings_[0],
      "p.jsonl:2: expected an object with [\"domain\", \"key\", \"value\"]; preferences begin "
      "anew, the file is now p.jsonl.broken");
  EXPECT_TRUE(preferences->domains().empty());
  EXPECT_NE(contentOf(folder_.path() + "/p.jsonl.broken"), "");
}

TEST_F(PreferencesTest, AFileBehindALinkIsWarnedOfAndLeftAlone) {
  std::filesystem::create_symlink("/etc/hostname", folder_.path() + "/p.jsonl");
  EXPECT_TRUE(open()->domains().empty());
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_EQ(warnings_[0].rfind("a link is not followed", 0), 0U) << warnings_[0];
}

TEST_F(PreferencesTest, AFileOfAnotherKindIsNotRead) {
  folder_.write("p.jsonl", "{\"format\":\"usarnaoqi preferences\",\"version\":2}\n");
  open();
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_EQ(warnings_[0].rfind("p.jsonl:1: expected", 0), 0U) << warnings_[0];
}

TEST_F(PreferencesTest, ReplacingAValueTakesNoRoomForEver) {
  const auto preferences = open();
  const std::string large(1U << 20U, 'x');
  for (int i = 0; i < 40; ++i) preferences->set("a", "x", large);
  EXPECT_EQ(preferences->domains().size(), 1U);
  EXPECT_THROW(
      {
        for (int i = 0; i < 40; ++i) preferences->set("a", std::to_string(i), large);
      },
      rpc::CallError);
}

TEST_F(PreferencesTest, WhatNoFileCanHoldIsRefused) {
  const auto preferences = open();
  Value deep = 1;
  for (int i = 0; i < 64; ++i) deep = Value::list({deep});
  EXPECT_THROW(preferences->set("a", "x", deep), rpc::CallError);
  EXPECT_THROW(preferences->set("a", "x", std::nan("")), rpc::CallError);
  EXPECT_TRUE(preferences->domains().empty());
}

TEST_F(KeptTest, WhatTheBoardsKeepIsInMemoryAgainNextTime) {
  {
    Robot robot(folder_);
    EXPECT_EQ(robot.call("DCM", "preferences", {"Add", "Head", "Mood", "fine"}), Value(0));
    EXPECT_EQ(robot.data("RobotConfig/Head/Mood"), Value("fine"));
    EXPECT_NE(
        robot.call("DCM", "preferences", {"Dance", "Head", "Mood", ""}).print().find("unknown"),
        std::string::npos);
  }
  Robot robot(folder_);
  EXPECT_EQ(robot.data("RobotConfig/Head/Mood"), Value("fine"));
  robot.call("DCM", "preferences", {"Remove", "Head", "Mood", ""});
  EXPECT_NE(robot.data("RobotConfig/Head/Mood").print().find("Data not found"), std::string::npos);
}

TEST_F(KeptTest, APreferenceFileBecomesKeysOfMemory) {
  Robot robot(folder_);
  const Value file = Value::list(
      {"walk", "how", "",
       Value::list({Value::list({"speed", "top", 0.5F}), Value::list({"arms", "swing", true})})});
  EXPECT_EQ(robot.call("ALPreferences", "saveToMemory", {file}), Value(true));
  EXPECT_EQ(robot.data("walk/speed"), Value(0.5F));
  EXPECT_EQ(robot.data("walk/arms"), Value(true));
}

TEST_F(KeptTest, ALibraryOfPosturesOutlivesTheDaemon) {
  {
    Robot robot(folder_);
    robot.call("ALMotion", "wakeUp");
    robot.call("ALMotion", "angleInterpolation", {"HeadYaw", 0.7F, 1.0F, true});
    robot.call("ALRobotPosture", "_saveCurrentPostureWithName", {500, "Mine"});
    EXPECT_EQ(robot.call("ALRobotPosture", "_savePostureLibrary", {"yard"}), Value(true));
  }
  Robot robot(folder_);
  EXPECT_EQ(robot.call("ALRobotPosture", "_loadPostureLibraryFromName", {"barn"}), Value(false));
  EXPECT_EQ(robot.call("ALRobotPosture", "_loadPostureLibraryFromName", {"yard"}), Value(true));
  EXPECT_EQ(robot.call("ALRobotPosture", "_getIdFromName", {"Mine"}), Value(500));
  robot.call("ALMotion", "wakeUp");
  EXPECT_EQ(robot.call("ALRobotPosture", "goToPosture", {"Mine", 0.5F}), Value(true));
  EXPECT_NEAR(robot.call("ALMotion", "getAngles", {"HeadYaw", true}).to<std::vector<float>>()[0],
              0.7, 0.01);
}

TEST_F(KeptTest, ALibraryThatDoesNotFitTheRobotChangesNothing) {
  folder_.write("postures/odd.jsonl",
                "{\"format\":\"usarnaoqi postures\",\"version\":1}\n"
                "{\"id\":500,\"name\":\"Odd\",\"angles\":{\"Tail\":1.0}}\n");
  Robot robot(folder_);
  const Value refused = robot.call("ALRobotPosture", "_loadPostureLibraryFromName", {"odd"});
  EXPECT_NE(refused.print().find("no joint Tail"), std::string::npos);
  EXPECT_EQ(robot.call("ALRobotPosture", "_getIdFromName", {"Odd"}), Value(-1));
  const Value outside = robot.call("ALRobotPosture", "_savePostureLibrary", {"../../outside"});
  EXPECT_NE(outside.print().find("leads out"), std::string::npos);
}

TEST_F(KeptTest, ThePathIsWhereTheRobotGoes) {
  Robot robot(folder_);
  robot.call("ALMotion", "wakeUp");
  const auto path = [&] {
    return robot.call("ALRobotPosture", "_getCurrentPath").to<std::vector<float>>();
  };
  EXPECT_TRUE(path().empty());
  const int zero = robot.call("ALRobotPosture", "_getIdFromName", {"StandZero"}).to<int>();
  const auto going = robot.start("ALRobotPosture", "goToPosture", {"StandZero", 0.5F});
  EXPECT_EQ(path(), std::vector<float>{static_cast<float>(zero)});
  robot.run(20);
  ASSERT_TRUE(going.isDone());
  EXPECT_TRUE(path().empty());
}

}  // namespace
}  // namespace nao::services
