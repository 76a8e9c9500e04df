#include "validation/diagnosis/joint/beat_search.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/ensemble/joint_data.h"

namespace nao::validation {
namespace {

Effort few() {
  Effort effort;
  effort.look_runs = 2;
  effort.base_runs = 12;
  return effort;
}

// The sizes proposed of a toy whose commands, of every 10 ms, are held for so long.
struct Proposed {
  std::vector<double> sizes;
  double width = 0;  // as far as a fit walks from one
};

Proposed proposedFor(double hold) {
  test::ToyLaws laws;
  laws.hold = hold;
  laws.sent = 0.01;
  const test::ToyJoint toy(laws, 1, test::kToyNoise, 6, 3);
  std::vector<Cause> causes;
  for (Cause cause : test::toyCauses()) {
    if (cause.id == "command_hold") causes.push_back(boundedAt(cause, toy, sim::standardEffects()));
  }
  const JointData data(toy, test::kToyNoise);
  Ensemble ensemble(toy, data, test::kToyNoise, 1000000);
  const Stage stage(ensemble, data, causes, {}, Eigen::MatrixXd(data.size(), 0), few());
  return {beatingSizes(ensemble, stage, causes, 0), beatWidth(data, hold)};
}

// A hold beside commands of nearly its own rate: nothing but its own beat, met to a part of a turn
// over 6 s, shows it.
TEST(BeatSearch, MeetsAHoldsBeat) {
  const Proposed proposed = proposedFor(0.0094);
  ASSERT_FALSE(proposed.sizes.empty());
  EXPECT_NEAR(proposed.sizes.front(), 0.0094, 2 * proposed.width);
}

// Seven commands to four of its ticks: beside that the ticks that meet a command take another.
TEST(BeatSearch, MeetsAHoldInStepWithTheCommands) {
  const Proposed proposed = proposedFor(0.0175);
  ASSERT_FALSE(proposed.sizes.empty());
  EXPECT_NEAR(proposed.sizes.front(), 0.0175, 1e-9);
}

// About what an ankle's roll held for 14.925 ms showed, in ms; what it did not is free choice.
TEST(BeatSearch, ProposesWhatExplainsMostIfScaledToo) {
  const std::vector<double> best = bestSizes({{5.0130, -547, 60},
                                              {10.0000, -79, 1},
                                              {10.0021, -155, 3},
                                              {10.0083, -365, 10},
                                              {14.7066, -3600, 330},
                                              {14.9117, -1459, 224},
                                              {14.9256, -1023, 255}});
  EXPECT_EQ(best.front(), 10.0000);
  EXPECT_EQ(std::count(best.begin(), best.end(), 14.9256), 1);
  EXPECT_EQ(best.size(), 7u);  // none twice
}

// Coarse runs had found a hold of 10.703 ms as one of 10.7016, where a beat is 0.0047 ms wide.
TEST(BeatSearch, AnExactSizeIsComeNearerFromOneBeside) {
  const auto left = [](double x) { return std::abs(x - 10.703e-3); };
  const BeatSize best = bestBeside({10.7016e-3, left(10.7016e-3)}, 0.0047e-3, left);
  EXPECT_NEAR(best.x, 10.703e-3, 0.0047e-3 / 32);
  EXPECT_EQ(best.left, left(best.x));
}

TEST(BeatSearch, ASizeThatNoneBesideItBettersStays) {
  const auto flat = [](double) { return 5.0; };
  EXPECT_EQ(bestBeside({0.01, 5.0}, 1e-3, flat).x, 0.01);
}

}  // namespace
}  // namespace nao::validation
