#include "ci/junit.h"

#include <gtest/gtest.h>

namespace nao::ci {
namespace {

using std::chrono_literals::operator""ms;

JobResult ran(const std::string& scenario, std::uint64_t seed, bool passed, double wall = 1) {
  JobResult job;
  job.wall = wall;
  job.result.scenario = scenario;
  job.result.file = scenario + ".yaml";
  job.result.seed = seed;
  job.result.verdicts = {{passed, "a < b & \"c\"", "a\x01 is 2", 1500ms, 7}};
  return job;
}

TEST(JUnit, HasASuiteForEachScenarioAndACaseForEachSeed) {
  EXPECT_EQ(toJUnit({ran("a", 1, true), ran("a", 2, true), ran("b", 1, true, 0.25)}),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites tests=\"3\" failures=\"0\" time=\"2.250\">\n"
            "  <testsuite name=\"a\" tests=\"2\" failures=\"0\" time=\"2.000\">\n"
            "    <testcase classname=\"a\" name=\"seed 1\" time=\"1.000\"/>\n"
            "    <testcase classname=\"a\" name=\"seed 2\" time=\"1.000\"/>\n"
            "  </testsuite>\n"
            "  <testsuite name=\"b\" tests=\"1\" failures=\"0\" time=\"0.250\">\n"
            "    <testcase classname=\"b\" name=\"seed 1\" time=\"0.250\"/>\n"
            "  </testsuite>\n"
            "</testsuites>\n");
}

TEST(JUnit, TellsWhatWasExpectedWhatWasSeenAndWhen) {
  const std::string xml = toJUnit({ran("a", 1, false)});
  EXPECT_NE(xml.find("<failure message=\"a.yaml:7: expected a &lt; b &amp; &quot;c&quot;; "
                     "a? is 2 at 1.5 s\">"),
            std::string::npos)
      << xml;
  EXPECT_NE(xml.find("replay: usarnaoqi run --scenario a.yaml --seed 1"), std::string::npos);
}

TEST(Result, ComesBackFromJsonAsItWas) {
  Result result = ran("a", 3, false).result;
  result.hash = 0xfedcba9876543210;
  result.drawn["push"] = 0.1;
  result.course.time = {1, 2};
  result.course.robots.push_back({"nao", "nao_h21_v33", {0, 1}, {2, 3}, {{4, 5}}, {{6, 7}}});
  result.course.stills.push_back({1, "UE5H"});
  const std::string json = toJson(result);
  EXPECT_EQ(toJson(parseResult(json)), toJson(parseResult(toJson(parseResult(json)))));
  const Result back = parseResult(json);
  EXPECT_EQ(back.hash, result.hash);
  EXPECT_EQ(back.drawn, result.drawn);
  EXPECT_EQ(back.verdicts[0].at, 1500ms);
  EXPECT_EQ(back.course.robots[0].sensed[0][1], 7);
  EXPECT_FALSE(back.passed());
}

}  // namespace
}  // namespace nao::ci
