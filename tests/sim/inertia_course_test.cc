#include "sim/inertia_course.h"

#include <gtest/gtest.h>

namespace nao::sim {
namespace {

// What changes evenly is met exactly, from the second calculation on.
TEST(InertiaCourse, GoesOnAsItChanged) {
  TreeMatrix inertia({-1, 0});
  InertiaCourse course(inertia);
  course.setEvery(4);
  Eigen::VectorXd bias(2);
  for (int step = 0; step < 20; ++step) {
    ASSERT_EQ(course.isDue(), step % 4 == 0);
    if (course.isDue()) {
      bias << step, -2 * step;
      inertia.at(1, 0) = 5 + 0.5 * step;
      course.take(inertia, bias);
    } else {
      course.goOn(inertia, bias);
    }
    if (step < 4) continue;
    EXPECT_NEAR(bias[1], -2 * step, 1e-12);
    EXPECT_NEAR(inertia.at(1, 0), 5 + 0.5 * step, 1e-12);
  }
}

}  // namespace
}  // namespace nao::sim
