#include "naoqi_api/pending.h"

#include <gtest/gtest.h>

namespace nao::rpc {
namespace {

TEST(Pending, TellsWhenResolvedAndNotBefore) {
  const Pending<int> pending;
  std::vector<int> told;
  pending.whenDone([&](const Outcome<int>& outcome) { told.push_back(*outcome.value); });
  EXPECT_TRUE(told.empty());
  pending.resolve(7);
  EXPECT_EQ(told, std::vector<int>{7});
}

TEST(Pending, TellsAtOnceWhenAlreadyDone) {
  const Pending<int> pending;
  pending.resolve(7);
  int told = 0;
  pending.whenDone([&](const Outcome<int>& outcome) { told = *outcome.value; });
  EXPECT_EQ(told, 7);
}

TEST(Pending, EndsOnlyOnce) {
  const Pending<void> pending;
  int told = 0;
  pending.whenDone([&](const auto& /*outcome*/) { ++told; });
  pending.fail("no");
  pending.resolve();
  pending.cancelNow();
  EXPECT_EQ(told, 1);
  EXPECT_EQ(*pending.outcome()->error, "no");
}

TEST(Pending, CancelStopsWhatCanBeStopped) {
  const Pending<void> pending;
  bool stopped = false;
  pending.onCancel([&] { stopped = true; });
  pending.cancel();
  EXPECT_TRUE(stopped);
  EXPECT_TRUE(pending.outcome()->isCanceled());
}

TEST(Pending, CancelIsIgnoredByWhatCanNotBeStopped) {
  const Pending<int> pending;
  pending.cancel();
  EXPECT_FALSE(pending.isDone());
  pending.resolve(1);
  EXPECT_EQ(*pending.outcome()->value, 1);
}

TEST(Pending, WhatEndsTheCallWhileStoppingWins) {
  const Pending<int> pending;
  pending.onCancel([&] { pending.resolve(3); });
  pending.cancel();
  EXPECT_EQ(*pending.outcome()->value, 3);
}

TEST(Pending, LetsGoOfWhatItHeldOnceDone) {
  const Pending<int> pending;
  const auto held = std::make_shared<int>(0);
  pending.whenDone([held](const Outcome<int>& /*outcome*/) {});
  pending.onCancel([held] {});
  EXPECT_EQ(held.use_count(), 3);
  pending.resolve(1);
  EXPECT_EQ(held.use_count(), 1);
}

}  // namespace
}  // namespace nao::rpc
