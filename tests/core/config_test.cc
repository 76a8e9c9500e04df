#include "core/config.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/core/temporary_folder.h"

namespace nao {
namespace {

// Visits a file of this text; the complaint it earns, or nothing.
std::string complaintAbout(const std::string& text, const Config::Visitor& visit) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.yaml", text);
  try {
    Config::read(file, visit);
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return {};
}

TEST(Config, ReadsEachType) {
  const std::string text =
      "number: -1.5e-3\nwhole: 7\nswitch: true\nword: one two\nwords: [a, b]\n"
      "numbers: [1, 2]\nrows: [[1, 2], [3, 4]]\nposition: [1, 2, 3]\ncolor: [255, 0, 7]\n";
  EXPECT_EQ(complaintAbout(text,
                           [](Config& config) {
                             EXPECT_EQ(config.number("number"), -1.5e-3);
                             EXPECT_EQ(config.integer("whole", 0, 9), 7);
                             EXPECT_TRUE(config.flag("switch", false));
                             EXPECT_EQ(config.text("word"), "one two");
                             EXPECT_EQ(config.texts("words")[1], "b");
                             EXPECT_EQ(config.numbers("numbers", 2)[1], 2);
                             EXPECT_EQ(config.rows("rows", 2)[1][0], 3);
                             EXPECT_EQ(config.pose().translation(), Vec3(1, 2, 3));
                             EXPECT_EQ(config.color("color", {}).blue, 7);
                           }),
            "");
}

TEST(Config, FallsBackOnlyWhereACallSaysSo) {
  EXPECT_EQ(complaintAbout("a: 1\n",
                           [](Config& config) {
                             EXPECT_EQ(config.number("a", {}, 2), 1);
                             EXPECT_EQ(config.number("b", {}, 2), 2);
                             EXPECT_EQ(config.text("c", "d"), "d");
                             EXPECT_FALSE(config.has("e"));
                           }),
            "");
  EXPECT_EQ(complaintAbout("a: 1\n", [](Config& config) { config.number("b"); }),
            "a.yaml:1: `b`: missing, expected a number");
}

TEST(Config, RefusesNumbersThatAreNone) {
  const auto read = [](Config& config) { config.number("a"); };
  for (const char* wrong : {"x", "1.2.3", "0x10", "1,5", "nan", "inf", "1e999", "''", "5 m"}) {
    const std::string found = std::string(wrong) == "''" ? "''" : "'" + std::string(wrong) + "'";
    EXPECT_EQ(complaintAbout("# one\na: " + std::string(wrong) + "\n", read),
              "a.yaml:2: `a`: expected a number, found " + found);
  }
  EXPECT_EQ(complaintAbout("a:\n", read), "a.yaml:1: `a`: expected a number, found nothing");
  EXPECT_EQ(complaintAbout("a: [1]\n", read), "a.yaml:1: `a`: expected a number, found a list");
}

TEST(Config, NamesTheRangeThatWasLeft) {
  const auto read = [](Config& config) { config.number("a", {0, 1}); };
  EXPECT_EQ(complaintAbout("a: 1\n", read), "");
  EXPECT_EQ(complaintAbout("a: 1.01\n", read),
            "a.yaml:1: `a`: expected a number in [0, 1], found '1.01'");
  EXPECT_EQ(complaintAbout("a: 0\n", [](Config& config) { config.number("a", kPositive); }),
            "a.yaml:1: `a`: expected a number above 0, found '0'");
  EXPECT_EQ(complaintAbout("a: -1\n", [](Config& config) { config.number("a", kNotNegative); }),
            "a.yaml:1: `a`: expected a number from 0 up, found '-1'");
  EXPECT_EQ(complaintAbout("a: 1.5\n", [](Config& config) { config.integer("a", 1, 3); }),
            "a.yaml:1: `a`: expected a whole number in [1, 3], found '1.5'");
}

TEST(Config, RefusesKeysNobodyAskedFor) {
  const auto read = [](Config& config) {
    config.map("inner", Config::Presence::Required, [](Config& inner) { inner.number("a"); });
  };
  EXPECT_EQ(complaintAbout("inner:\n  a: 1\n  b: 2\n", read),
            "a.yaml:3: `b`: unknown key, expected one of a");
}

TEST(Config, RefusesAKeyGivenTwice) {
  EXPECT_EQ(complaintAbout("a: 1\nb: 2\na: 3\n", [](Config&) {}), "a.yaml:3: `a`: given twice");
}

TEST(Config, PointsToTheItemOfAList) {
  const auto read = [](Config& config) {
    config.list("items", Config::Presence::Required, [](Config& item) { item.number("a"); });
  };
  EXPECT_EQ(complaintAbout("items:\n  - a: 1\n  - a: q\n", read),
            "a.yaml:3: `a`: expected a number, found 'q'");
  EXPECT_EQ(complaintAbout("items:\n  - a: 1\n  - 3\n", read),
            "a.yaml:3: `items`: expected a map of keys, found '3'");
  EXPECT_EQ(complaintAbout("items: {a: 1}\n", read),
            "a.yaml:1: `items`: expected a list, found a map");
}

TEST(Config, PointsToBrokenYaml) {
  const std::string complaint = complaintAbout("a: 1\nb: [1, 2\nc: 3\n", [](Config&) {});
  EXPECT_EQ(complaint.rfind("a.yaml:3: not YAML: ", 0), 0u) << complaint;
  EXPECT_EQ(complaintAbout("- 1\n", [](Config&) {}), "a.yaml:1: expected keys, found a list");
  EXPECT_EQ(complaintAbout("", [](Config&) {}), "a.yaml:1: expected keys, found nothing");
}

}  // namespace
}  // namespace nao
