#include "core/mailbox.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

namespace nao {
namespace {

TEST(Mailbox, HandsOutInOrderAndOnce) {
  Mailbox<int> box(4);
  EXPECT_TRUE(box.post(1));
  EXPECT_TRUE(box.post(2));
  EXPECT_EQ(box.drain(), (std::vector<int>{1, 2}));
  EXPECT_TRUE(box.drain().empty());
}

TEST(Mailbox, RefusesWhenFull) {
  Mailbox<int> box(2);
  EXPECT_TRUE(box.post(1));
  EXPECT_TRUE(box.post(2));
  EXPECT_FALSE(box.post(3));
  EXPECT_EQ(box.drain().size(), 2u);
  EXPECT_TRUE(box.post(4));  // room again
}

TEST(Mailbox, CarriesWhatCanOnlyBeMoved) {
  Mailbox<std::unique_ptr<int>> box(1);
  EXPECT_TRUE(box.post(std::make_unique<int>(7)));
  EXPECT_EQ(*box.drain().at(0), 7);
}

TEST(Mailbox, LosesNothingBetweenThreads) {
  constexpr int kEach = 5000;
  Mailbox<int> box(64);
  const auto send = [&](int sender) {
    for (int i = 0; i < kEach;) {
      if (box.post(sender * kEach + i)) {
        ++i;
      } else {
        std::this_thread::yield();
      }
    }
  };
  std::thread first(send, 0);
  std::thread second(send, 1);
  int next[2] = {0, 0};
  while (next[0] + next[1] < 2 * kEach) {
    for (const int message : box.drain()) {
      const int sender = message / kEach;
      ASSERT_EQ(message % kEach, next[sender]++);  // each sender's messages stay in order
    }
  }
  first.join();
  second.join();
  EXPECT_TRUE(box.drain().empty());
}

}  // namespace
}  // namespace nao
