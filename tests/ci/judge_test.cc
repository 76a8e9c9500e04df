#include "ci/judge.h"

#include <gtest/gtest.h>

namespace nao::ci {
namespace {

using Kind = When::Kind;
using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

// Beats of 1 s; `heights` is what memory holds under "height" at each.
Verdict judged(const When& when, const std::vector<double>& heights, const Comparison& wanted) {
  Judge judge({{MemoryIs{0, "height", wanted}, when, "enough", 3}});
  SimTime now{};
  for (const double height : heights) {
    Moment moment;
    moment.now = now;
    moment.heard.memory[{0, "height"}] = {std::to_string(height), height};
    judge.look(moment);
    now += 1s;
  }
  return judge.finish(now - 1s).at(0);
}

Comparison atLeast(double min) {
  Comparison wanted;
  wanted.min = min;
  return wanted;
}

TEST(Judge, AtLooksOnceAtTheFirstBeatFromThen) {
  EXPECT_TRUE(judged({Kind::At, {}, 1500ms}, {0, 0, 5, 0}, atLeast(5)).passed);
  const Verdict failed = judged({Kind::At, {}, 1500ms}, {5, 5, 4, 5}, atLeast(5));
  EXPECT_FALSE(failed.passed);
  EXPECT_EQ(failed.at, 2s);
  EXPECT_EQ(failed.seen, "it is 4.000000");
}

TEST(Judge, ByIsContentOnceItHasHeldAndElseTellsTheClosest) {
  const Verdict passed = judged({Kind::By, {}, 3s}, {0, 5, 0, 0}, atLeast(5));
  EXPECT_TRUE(passed.passed);
  EXPECT_EQ(passed.at, 1s);
  const Verdict failed = judged({Kind::By, {}, 2s}, {0, 4, 1, 5}, atLeast(5));
  EXPECT_FALSE(failed.passed);
  EXPECT_EQ(failed.at, 1s);
  EXPECT_EQ(failed.seen, "closest: it is 4.000000");
}

TEST(Judge, AlwaysFailsAtTheFirstBeatThatIsNot) {
  EXPECT_TRUE(judged({Kind::Always, 1s, 2s}, {0, 5, 5, 0}, atLeast(5)).passed);
  const Verdict failed = judged({Kind::Always, {}, 3s}, {5, 5, 0, 1}, atLeast(5));
  EXPECT_FALSE(failed.passed);
  EXPECT_EQ(failed.at, 2s);
}

TEST(Judge, NeverFailsAtTheFirstBeatThatIs) {
  EXPECT_TRUE(judged({Kind::Never, {}, 3s}, {0, 4, 0, 0}, atLeast(5)).passed);
  EXPECT_EQ(judged({Kind::Never, {}, 3s}, {0, 0, 5, 6}, atLeast(5)).at, 2s);
}

TEST(Judge, NothingHasBeenKeptInAWorldThatEndedBefore) {
  const Verdict verdict = judged({Kind::Always, {}, 9s}, {5, 5}, atLeast(5));
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.seen, "the world ended before that");
}

TEST(Judge, AnEventCountsInItsWindowAndWithItsValue) {
  Comparison one;
  one.equals = "1";
  Judge judge({{EventRaised{0, "Bump", one}, {Kind::By, 1s, 3s}, "bump", 1},
               {EventRaised{0, "Bump", {}}, {Kind::Never, {}, 3s}, "no bump", 2},
               {EventRaised{1, "Bump", {}}, {Kind::By, {}, 3s}, "bump of the other", 3}});
  for (int i = 0; i <= 4; ++i) {
    Moment moment;
    moment.now = SimTime(i * 1s);
    if (i == 0) moment.heard.events.push_back({0, "Bump", {"1", 1.0}});  // too early for the first
    if (i == 2) moment.heard.events.push_back({0, "Bump", {"0", 0.0}});  // not its value
    judge.look(moment);
  }
  const auto verdicts = judge.finish(SimTime(4s));
  EXPECT_FALSE(verdicts[0].passed);
  EXPECT_EQ(verdicts[0].seen, "closest: raised with 0");
  EXPECT_FALSE(verdicts[1].passed);
  EXPECT_FALSE(verdicts[2].passed);
  EXPECT_EQ(verdicts[2].seen, "it did not happen");
}

TEST(Comparison, TakesNumbersAsNumbersAndTextAsText) {
  Comparison one;
  one.equals = "1";
  EXPECT_TRUE(one.accepts("1.000000", 1.0));
  EXPECT_FALSE(one.accepts("1.01", 1.01));
  one.tolerance = 0.02;
  EXPECT_TRUE(one.accepts("1.01", 1.01));
  Comparison word;
  word.equals = "Stand";
  EXPECT_TRUE(word.accepts("Stand", {}));
  EXPECT_FALSE(word.accepts("StandInit", {}));
  EXPECT_FALSE(atLeast(0).accepts("Stand", {}));
}

}  // namespace
}  // namespace nao::ci
