#include "daemon/byte_budget.h"

#include <gtest/gtest.h>

namespace nao::daemon {
namespace {

TEST(ByteBudget, IsForAllTogether) {
  ByteBudget budget;
  EXPECT_TRUE(budget.change(0, ByteBudget::kMost));
  EXPECT_FALSE(budget.change(0, 16U << 20U));
  EXPECT_TRUE(budget.change(16U << 20U, 0));  // that one has gone
  EXPECT_TRUE(budget.change(ByteBudget::kMost, 1));
  EXPECT_TRUE(budget.change(0, 16U << 20U));
  EXPECT_EQ(budget.used(), (16U << 20U) + 1);
}

TEST(ByteBudget, WhoLeavesLittleOrTakesAwayIsNotClosed) {
  ByteBudget budget;
  EXPECT_FALSE(budget.change(0, 2 * ByteBudget::kMost));
  EXPECT_TRUE(budget.change(0, ByteBudget::kLittle));
  EXPECT_TRUE(budget.change(2 * ByteBudget::kMost, ByteBudget::kMost));
}

}  // namespace
}  // namespace nao::daemon
