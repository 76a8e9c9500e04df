#include "validation/diagnosis/causes/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

#include "validation/diagnosis/jobs/packed.h"

namespace nao::validation {
namespace {

FoundNumber delay() { return {"delay", "s", 0.0123, 0.0023, 0.0021, 0.0025, Form::Offset}; }
FoundNumber rate() { return {"rate", "rad/s", 5, 0.2, 0.16, 0.25, Form::Inverse}; }

TEST(FoundNumbers, HaveTheirIntervalInTheUnitOfTheirValue) {
  const auto [low, high] = valueInterval(delay());
  EXPECT_DOUBLE_EQ(low, 0.0121);
  EXPECT_DOUBLE_EQ(high, 0.0125);
  EXPECT_EQ(intervalText(delay()), "12.1 ms to 12.5 ms");
  EXPECT_EQ(deviationIntervalText(delay()), "2.1 ms to 2.5 ms");
}

TEST(FoundNumbers, HaveAsManyDigitsAsTheirIntervalNeeds) {
  FoundNumber narrow = delay();
  narrow.low = 0.002301, narrow.high = 0.002302;
  EXPECT_EQ(intervalText(narrow), "12.301 ms to 12.302 ms");
}

// What is fitted of a limit is one part of it: its interval lies the other way round.
TEST(FoundNumbers, OfALimitAreTurnedOver) {
  EXPECT_EQ(valueInterval(rate()), std::make_pair(4.0, 6.25));
  FoundNumber open = rate();
  open.low = 0;
  EXPECT_EQ(valueInterval(open).first, 4);
  EXPECT_TRUE(std::isinf(valueInterval(open).second));
}

// How steep a coupled stop is and where it begins undo each other: what decides is how steep it is
// where it was found.
TEST(Findings, TellWhatTheirSizeIsIfAllElseIsAsFound) {
  Finding finding;
  finding.numbers = {delay()};
  EXPECT_EQ(sizeIntervalText(finding), "12.1 ms to 12.5 ms");
  finding.as_shaped = {delay()};
  EXPECT_EQ(sizeIntervalText(finding), "12.1 ms to 12.5 ms");  // no news
  finding.numbers[0].low = -0.0023;
  EXPECT_EQ(sizeIntervalText(finding),
            "7.7 ms to 12.5 ms; if all else is as found, 12.1 ms to 12.5 ms");
}

// A robot that kicked, with zeros off by less than a tenth of a degree and gains by less than 2 %
// at every joint: its stance was as of one encoder turned by 0.4 degrees, at any of four joints
// (-9.0 to -4.9 mrad).
TEST(Findings, AreNotOfInterestWhereEqualRobotsAddUpToThem) {
  const double smallest = 0.0035;
  const std::vector<Rival> same(3, {"encoder_offset", "encoder_offset", "RHipPitch", {}, 0});
  EXPECT_FALSE(mayBeSmall(-0.0090, -0.0049, smallest));
  EXPECT_DOUBLE_EQ(smallestTogether("encoder_offset", smallest, same), 2 * smallest);
  EXPECT_TRUE(mayBeSmall(-0.0090, -0.0049, smallestTogether("encoder_offset", smallest, same)));
  EXPECT_EQ(smallestTogether("kp_error", smallest, same), smallest);  // rivals of another kind
  EXPECT_EQ(smallestTogether("encoder_offset", smallest, {}), smallest);
}

// Verdicts go from process to process and to a kept file as bytes. Without its form a limit's
// interval was turned over no longer: 6.740 to 6.740 rad/s.
TEST(FoundNumbers, KeepTheirFormWhenTheyAreKept) {
  JointVerdict verdict;
  verdict.findings.resize(1);
  verdict.findings[0].numbers = {rate()};
  verdict.findings[0].as_shaped = {rate()};
  const auto again = unpack<JointVerdict>(pack(verdict));
  EXPECT_EQ(valueInterval(again.findings[0].numbers[0]), valueInterval(rate()));
  ASSERT_EQ(again.findings[0].as_shaped.size(), 1u);
}

}  // namespace
}  // namespace nao::validation
