#include "clock/clock_page.h"

#include <gtest/gtest.h>

#include <memory>

namespace nao::clock {
namespace {

class ClockPageTest : public testing::Test {
 protected:
  ClockPageTest() { page_->world_due = 10 * kMillisecond; }

  Slot& add(SlotState state, std::int64_t deadline = kNever) {
    Slot& slot = page_->slots[page_->slots_used++];
    slot.order = ++page_->last_order;
    slot.deadline = deadline;
    slot.alarm = kNever;
    slot.state = state;
    return slot;
  }

  std::unique_ptr<ClockPage> page_ = std::make_unique<ClockPage>();
};

TEST_F(ClockPageTest, TheWorldHasTheTurnWhenNobodyMayRun) {
  EXPECT_EQ(nextHolder(*page_), kWorld);
  add(SlotState::Queued);
  add(SlotState::Beside);
  add(SlotState::Ended);
  EXPECT_EQ(nextHolder(*page_), kWorld);
}

TEST_F(ClockPageTest, ThreadsComeInTheOrderOfTheirCreationAndRound) {
  for (int i = 0; i < 3; ++i) add(SlotState::Ready);
  std::swap(page_->slots[0].order, page_->slots[2].order);  // the place in the list is nothing
  EXPECT_EQ(nextHolder(*page_), 2u);
  page_->round = page_->slots[2].order;
  EXPECT_EQ(nextHolder(*page_), 1u);
  page_->round = page_->slots[0].order;
  EXPECT_EQ(nextHolder(*page_), 2u);
}

TEST_F(ClockPageTest, AWorldThatIsDueComesFirst) {
  add(SlotState::Ready);
  page_->now = 10 * kMillisecond;
  EXPECT_EQ(nextHolder(*page_), kWorld);
}

TEST_F(ClockPageTest, WhoTriedInVainTriesAgainWhenSomethingHasHappened) {
  Slot& slot = add(SlotState::Trying);
  slot.looked = page_->happened = 5;
  EXPECT_EQ(nextHolder(*page_), kWorld);
  page_->happened = 6;
  EXPECT_EQ(nextHolder(*page_), 0u);
}

TEST_F(ClockPageTest, ASignalADeadlineAndAnAlarmWake) {
  Slot& slot = add(SlotState::Queued, 3 * kMillisecond);
  slot.signalled = 1;
  EXPECT_TRUE(mayRun(*page_, slot));
  slot.signalled = 0;
  EXPECT_FALSE(mayRun(*page_, slot));
  page_->now = 3 * kMillisecond;
  EXPECT_TRUE(mayRun(*page_, slot));
  slot.deadline = kNever;
  EXPECT_FALSE(mayRun(*page_, slot));
  slot.alarm = 2 * kMillisecond;
  EXPECT_TRUE(mayRun(*page_, slot));
}

TEST_F(ClockPageTest, TheFirstDeadlineIsOfThoseWhoWait) {
  EXPECT_EQ(firstDeadline(*page_), kNever);
  add(SlotState::Queued, 7 * kMillisecond);
  add(SlotState::Trying, 5 * kMillisecond);
  add(SlotState::Ended, 1 * kMillisecond);
  EXPECT_EQ(firstDeadline(*page_), 5 * kMillisecond);
}

}  // namespace
}  // namespace nao::clock
