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

TEST(BudgetShare, IsGivenBackWhenItsClientGoes) {
  const auto budget = std::make_shared<ByteBudget>();
  {
    BudgetShare share(budget);
    EXPECT_TRUE(share.change(100));
    EXPECT_TRUE(share.change(70));
    EXPECT_EQ(budget->used(), 70U);
  }
  EXPECT_EQ(budget->used(), 0U);
}

TEST(BudgetShare, WhoLeavesMuchWhenAllIsUsedIsToBeClosed) {
  const auto budget = std::make_shared<ByteBudget>();
  BudgetShare first(budget);
  BudgetShare second(budget);
  EXPECT_TRUE(first.change(ByteBudget::kMost));
  EXPECT_TRUE(second.change(ByteBudget::kLittle));
  EXPECT_FALSE(second.change(ByteBudget::kLittle + 1));
}

}  // namespace
}  // namespace nao::daemon
