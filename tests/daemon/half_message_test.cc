#include "daemon/half_message.h"

#include <gtest/gtest.h>

namespace nao::daemon {
namespace {

using Clock = HalfMessage::Clock;

TEST(HalfMessage, RunsFromTheBeginningOfAMessageToItsEnd) {
  HalfMessage half;
  EXPECT_EQ(half.look(false, false, 0), Clock::Stop);
  EXPECT_EQ(half.look(true, false, 0), Clock::Restart);
  EXPECT_EQ(half.look(true, false, 0), Clock::GoOn);
  EXPECT_EQ(half.look(false, false, 1), Clock::Stop);
}

TEST(HalfMessage, StartsAnewWhileMessagesKeepComing) {  // a stream cut anywhere is no half message
  HalfMessage half;
  EXPECT_EQ(half.look(true, false, 1), Clock::Restart);
  EXPECT_EQ(half.look(true, false, 5), Clock::Restart);
  EXPECT_EQ(half.look(true, false, 9), Clock::Restart);
}

TEST(HalfMessage, StandsWhileTheClientIsNotRead) {
  HalfMessage half;
  EXPECT_EQ(half.look(true, false, 1), Clock::Restart);
  EXPECT_EQ(half.look(true, true, 1), Clock::Stop);
  EXPECT_EQ(half.look(true, false, 1), Clock::Restart);
}

}  // namespace
}  // namespace nao::daemon
