#include "tests/hidden/figures.h"

#include <gtest/gtest.h>

namespace nao::hidden {
namespace {

TEST(Fraction, HasWilsonsInterval) {
  const Fraction none{0, 200}, most{186, 200};
  EXPECT_EQ(none.low(), 0);
  EXPECT_NEAR(none.high(), 0.0188, 1e-4);  // z^2 / (n + z^2)
  EXPECT_NEAR(most.low(), 0.8861, 2e-4);
  EXPECT_NEAR(most.high(), 0.9577, 2e-4);
}

TEST(Figures, NothingDoneIsNothingFound) {
  const Figures figures = figuresOf({});
  EXPECT_EQ(figures.singles, 0);
  EXPECT_NE(toJson(figures, "quick", 0).find("\"exact_null_false_alarms\": 0"), std::string::npos);
}

// Lines as runTrial() writes them, as far as figures read them.
std::string line(const std::string& kind, const std::string& level, const std::string& score) {
  return R"({"name":"a","cpu_s":3,"wall_s":4,"said":"named","truth":{"kind":")" + kind +
         R"(","level":")" + level +
         R"(","hidden":[{"look_alikes":[],"law":"payload"}]},"score":{"exact":true,"named_wrong":)" +
         R"(false,"truth_in_set":true,"ambiguous":false,"unknown":false,"look_alike":false,)" +
         R"("set_size":1,"numbers":[],"said_unknown":false,)" + score + "}}";
}

TEST(Figures, CountsLevelsApartAndTogether) {
  const Figures figures = figuresOf({line("single", "robot", R"("false_alarm":true)"),
                                     line("near_null", "robot", R"("false_alarm":true)"),
                                     line("single", "joint", R"("false_alarm":true)")});
  EXPECT_EQ(figures.singles, 2);
  EXPECT_EQ(figures.levels.at("robot").singles, 1);
  EXPECT_EQ(figures.levels.at("robot").exact, 1);
  EXPECT_EQ(figures.levels.at("robot").nulls, 1);
  EXPECT_EQ(figures.levels.at("robot").false_alarms, 1);
  EXPECT_EQ(figures.levels.at("robot").cpu, 6);
  EXPECT_EQ(figures.levels.at("joint").nulls, 0);
  EXPECT_NE(toText(figures).find("robot level"), std::string::npos);
}

// Counts are few, chance in them is large: how near a right model comes says what the bar asks.
TEST(Figures, OfNullsTellHowNearARightModelComes) {
  const auto null = [](const char* over_floor) {
    std::string text = line("exact_null", "joint", R"("false_alarm":false)");
    text.pop_back();
    return text + R"(,"gain":{"known":false,"removed":0,"over_floor":)" + over_floor + "}}";
  };
  const Figures figures = figuresOf({null("1.2"), null("1.7"), null("0.9")});
  EXPECT_EQ(figures.null_gains, 3);
  EXPECT_EQ(figures.nulls_within_1_3_floor, 2);
  EXPECT_EQ(figures.gains, 0);
}

// A number of a law of another form is not quite the catalogue's number.
TEST(Figures, NumbersOfTheCataloguesOwnLawsCountApartToo) {
  std::string text = line("single", "joint", R"("false_alarm":true)");
  const std::string none = R"("numbers":[])";
  text.replace(text.find(none), none.size(),
               R"("numbers":[{"error":0.3,"interval":true,"covered":false,"own_law":false},)"
               R"({"error":0.01,"interval":true,"covered":true,"own_law":true}])");
  const Figures figures = figuresOf({text});
  EXPECT_EQ(figures.intervals, 2);
  EXPECT_EQ(figures.intervals_covering, 1);
  EXPECT_EQ(figures.own_law_intervals, 1);
  EXPECT_EQ(figures.own_law_intervals_covering, 1);
  EXPECT_DOUBLE_EQ(figures.own_law_parameter_error_median, 0.01);
  EXPECT_DOUBLE_EQ(figures.parameter_error_median, 0.155);
}

}  // namespace
}  // namespace nao::hidden
