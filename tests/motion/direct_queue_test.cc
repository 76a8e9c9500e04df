#include "motion/direct_queue.h"

#include <gtest/gtest.h>

namespace nao::motion {
namespace {

using Merge = DirectCommands::Merge;
using std::chrono::milliseconds;

class DirectQueueTest : public testing::Test {
 protected:
  static SimTime at(int ms) { return SimTime(milliseconds(ms)); }

  bool command(Merge merge, const std::vector<TimedValue>& points) {
    DirectCommands request;
    request.merge = merge;
    request.tracks.push_back({toJoint(0), DirectCommands::Quantity::Angle, points});
    return queue_.take(request, now_, angle_, stiffness_);
  }
  double angleAt(int ms) {
    now_ = at(ms);
    queue_.apply(now_, angle_);
    return angle_[0];
  }

  SimTime now_{};
  JointArray<double> angle_{2};
  JointArray<double> stiffness_{2};
  DirectQueue queue_{2};
};

TEST_F(DirectQueueTest, GoesAlongStraightLinesAndStays) {
  command(Merge::ClearAll, {{at(100), 1}, {at(200), 0.5}});
  EXPECT_NEAR(angleAt(50), 0.5, 1e-12);
  EXPECT_NEAR(angleAt(150), 0.75, 1e-12);
  EXPECT_TRUE(queue_.activeAngles().test(0));
  EXPECT_FALSE(queue_.activeAngles().test(1));
  EXPECT_NEAR(angleAt(300), 0.5, 1e-12);
  EXPECT_FALSE(queue_.activeAngles().test(0));
}

TEST_F(DirectQueueTest, APastCommandHoldsAtOnce) {
  now_ = at(500);
  command(Merge::ClearAll, {{at(100), 1}});
  EXPECT_EQ(angleAt(510), 1);
}

TEST_F(DirectQueueTest, ClearAllForgetsWhatWaited) {
  command(Merge::ClearAll, {{at(100), 1}});
  command(Merge::ClearAll, {{at(300), 3}});
  EXPECT_NEAR(angleAt(100), 1, 1e-12);  // a third of the way to 3
}

TEST_F(DirectQueueTest, MergePutsCommandsBetweenOthers) {
  command(Merge::ClearAll, {{at(100), 1}, {at(300), 3}});
  command(Merge::Merge, {{at(200), 0}});
  EXPECT_NEAR(angleAt(150), 0.5, 1e-12);
  EXPECT_NEAR(angleAt(250), 1.5, 1e-12);
}

TEST_F(DirectQueueTest, ClearAfterForgetsTheLater) {
  command(Merge::ClearAll, {{at(100), 1}, {at(200), 2}, {at(300), 3}});
  command(Merge::ClearAfter, {{at(150), 0}});
  EXPECT_NEAR(angleAt(100), 1, 1e-12);
  EXPECT_NEAR(angleAt(300), 0, 1e-12);
}

TEST_F(DirectQueueTest, ClearBeforeForgetsTheEarlier) {
  command(Merge::ClearAll, {{at(100), 1}, {at(200), 2}, {at(400), 4}});
  command(Merge::ClearBefore, {{at(300), 3}});
  EXPECT_NEAR(angleAt(100), 1, 1e-12);  // on the line to 3 at 300
  EXPECT_NEAR(angleAt(200), 2, 1e-12);
  EXPECT_NEAR(angleAt(400), 4, 1e-12);
}

TEST_F(DirectQueueTest, TakesNoMoreThanTheRobot) {
  std::vector<TimedValue> points(DirectQueue::kDeepest);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].time = at(static_cast<int>(i) + 1);
  EXPECT_TRUE(command(Merge::Merge, points));
  EXPECT_FALSE(command(Merge::Merge, {{at(9999), 1}}));
  EXPECT_TRUE(command(Merge::ClearAll, {{at(9999), 1}}));
}

}  // namespace
}  // namespace nao::motion
