#include "validation/report.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao::validation {
namespace {

TEST(Statistics, AreThoseOfASample) {
  const Statistics s = calcStatistics({1, 2, 3, 6});
  EXPECT_DOUBLE_EQ(s.mean, 3);
  EXPECT_DOUBLE_EQ(s.sd, std::sqrt((4.0 + 1 + 0 + 9) / 3));  // n - 1
  EXPECT_DOUBLE_EQ(s.min, 1);
  EXPECT_DOUBLE_EQ(s.max, 6);
  EXPECT_EQ(s.n, 4u);
  EXPECT_EQ(calcStatistics({5}).sd, 0);
}

TEST(Report, IsOneJsonObjectOnOneLine) {
  Report report;
  report.command = "experiment drop";
  report.robot = "block";
  report.seed = 3;
  report.runs = 2;
  report.step_s = 0.5;
  report.hash = 0xab;
  report.draw = {{"nao.zero", 0.25}};
  report.figures = {
      {"plain", 1.5},
      {"many", Statistics{1, 0, 1, 1, 2}},
      {"rows", std::vector<Row>{{{"name", "a \"b\""}, {"list", std::vector<double>{1, 2}}}}}};
  EXPECT_EQ(toJson(report),
            R"({"command":"experiment drop","robot":"block","seed":3,"runs":2,"step_s":0.5,)"
            R"("hash":"00000000000000ab","figures":{"plain":1.5,)"
            R"("many":{"mean":1.0,"sd":0.0,"min":1.0,"max":1.0,"n":2},)"
            R"("rows":[{"name":"a \"b\"","list":[1.0,2.0]}]},"draw":{"nao.zero":0.25}})");
}

TEST(Report, WritesNullForWhatIsNoNumber) {
  Report report;
  report.figures = {{"lost", std::nan("")}};
  EXPECT_NE(toJson(report).find(R"("lost":null)"), std::string::npos);
}

TEST(Report, LinesUpColumnsByLetters) {
  Report report;
  report.tables = {{"Title", {"a", "b"}, {{"µµ", "1"}, {"xyz", "22"}}}};
  report.remarks = {"Said."};
  EXPECT_EQ(toText(report), "Title\n  a     b\n  µµ    1\n  xyz  22\n\nSaid.\n");
}

}  // namespace
}  // namespace nao::validation
