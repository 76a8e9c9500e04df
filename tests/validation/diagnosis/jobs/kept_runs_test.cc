#include "validation/diagnosis/jobs/kept_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/core/temporary_folder.h"

namespace nao::validation {
namespace {

class KeptRunsTest : public testing::Test {
 protected:
  KeptRuns open() const { return KeptRuns(KeptWork(folder_.path() + "/kept", "key")); }
  TemporaryFolder folder_;
};

TEST_F(KeptRunsTest, AreSimulatedOnceAndComeBackToTheBit) {
  const double huge = std::numeric_limits<double>::infinity();
  const WholePool made = {{Eigen::Vector3d(1.0 / 3, -0.0, huge), Eigen::VectorXd()}, {}, {}};
  int simulated = 0;
  const auto simulate = [&] {
    ++simulated;
    return made;
  };
  EXPECT_EQ(open().remember("a walk", simulate), made);
  const WholePool found = open().remember("a walk", simulate);
  EXPECT_EQ(simulated, 1);
  EXPECT_EQ(found, made);
  EXPECT_TRUE(std::signbit(found[0][0][1]));
  open().remember("another walk", simulate);
  EXPECT_EQ(simulated, 2);
}

TEST_F(KeptRunsTest, AreSimulatedEachTimeIfNothingIsKept) {
  int simulated = 0;
  const auto simulate = [&] {
    ++simulated;
    return WholePool();
  };
  KeptRuns().remember("a walk", simulate);
  KeptRuns().remember("a walk", simulate);
  EXPECT_EQ(simulated, 2);
}

}  // namespace
}  // namespace nao::validation
