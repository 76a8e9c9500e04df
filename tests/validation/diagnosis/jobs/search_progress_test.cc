#include "validation/diagnosis/jobs/search_progress.h"

#include <gtest/gtest.h>

namespace nao::validation {
namespace {

TEST(SearchProgress, GoesOnWithinItsShareAndNeverReachesItsEnd) {
  SearchProgress second(0.5, 0.25);
  double before = 0.5;
  for (int phase = 0; phase < 20; ++phase) {
    const double now = second.nextPhase();
    EXPECT_GT(now, before);
    EXPECT_LT(now, 0.75);
    before = now;
  }
  EXPECT_GT(before, 0.74);
}

// What limbs or robots may take adds up to no more than all may.
TEST(SearchProgress, LeavesTimeForTheScatterOfRepeats) {
  EXPECT_LT(SearchProgress(0, 0.5).share() + SearchProgress(0.5, 0.5).share(), 1);
  EXPECT_GT(SearchProgress(0, 1).share(), 0.5);
}

}  // namespace
}  // namespace nao::validation
