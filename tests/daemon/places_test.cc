#include "daemon/places.h"

#include <gtest/gtest.h>

namespace nao::daemon {
namespace {

using std::chrono::seconds;
using Time = std::chrono::steady_clock::time_point;

const Time kNow = Time() + seconds(1000);

Guest silentFor(seconds time) { return {true, kNow - time}; }

TEST(Places, WhoHasNotSaidWhoHeIsGivesWayFirst) {
  EXPECT_EQ(whoGivesWay({silentFor(kIdle * 2), {false, kNow}, {false, Time()}}, kNow), 1U);
}

TEST(Places, ThenWhoHasBeenSilentLongest) {
  EXPECT_EQ(whoGivesWay({silentFor(kIdle), silentFor(kIdle * 3), silentFor(seconds(0))}, kNow), 1U);
}

TEST(Places, NobodyWhoSpokeLately) {
  EXPECT_EQ(whoGivesWay({silentFor(seconds(1)), silentFor(kIdle - seconds(1))}, kNow),
            std::nullopt);
  EXPECT_EQ(whoGivesWay({}, kNow), std::nullopt);
}

}  // namespace
}  // namespace nao::daemon
