#include "core/latest.h"

#include <gtest/gtest.h>

#include <thread>

namespace nao {
namespace {

TEST(Latest, IsNullBeforeTheFirstPublish) { EXPECT_EQ(Latest<int>().get(), nullptr); }

TEST(Latest, KeepsOnlyTheNewest) {
  Latest<int> latest;
  latest.publish(1);
  latest.publish(2);
  EXPECT_EQ(*latest.get(), 2);
  EXPECT_EQ(*latest.get(), 2);  // reading takes nothing away
}

TEST(Latest, ReadersKeepTheValueTheyTook) {
  Latest<int> latest;
  latest.publish(1);
  const auto taken = latest.get();
  latest.publish(2);
  EXPECT_EQ(*taken, 1);
}

TEST(Latest, SharesWhatIsSharedAlready) {
  Latest<int> latest;
  const auto value = std::make_shared<const int>(5);
  latest.publish(value);
  EXPECT_EQ(latest.get(), value);
}

TEST(Latest, ReadersNeverSeeHalfAValueNorGoBack) {
  struct Pair {
    int a = 0;
    int b = 0;
  };
  constexpr int kLast = 20000;
  Latest<Pair> latest;
  latest.publish(Pair{0, 0});
  std::thread writer([&] {
    for (int i = 1; i <= kLast; ++i) latest.publish(Pair{i, -i});
  });
  bool whole = true;
  bool forward = true;
  for (int seen = 0; seen < kLast;) {
    const auto pair = latest.get();
    whole = whole && pair->a == -pair->b;
    forward = forward && pair->a >= seen;
    seen = pair->a;
  }
  writer.join();
  EXPECT_TRUE(whole);
  EXPECT_TRUE(forward);
}

}  // namespace
}  // namespace nao
