#include "tests/hidden/laws/laws.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/models.h"
#include "validation/log/simulated_recording.h"
#include "validation/suspended.h"

namespace nao::hidden {
namespace {

// One motion of a head that nods, without noise.
validation::LogSet nod(const std::string& effect, double delay) {
  validation::RecordingPlan plan;
  plan.model = std::make_shared<RobotModel>(validation::cutLimbs(
      validation::stripped(suspend(*test::robot("nao_h21_v33"))), {"HeadPitch"}));
  plan.motions = validation::standardRecording(plan.model);
  plan.motions.resize(1);
  plan.repeats = 1;
  plan.effects = &hiddenEffects();
  plan.extra = {{effect, {{"delay", delay}}, {}, ""}};
  return validation::recordSimulated(plan);
}

// A reading is late as a whole, by whichever law: a law that left the current in time was told as
// another fault, and rightly so.
TEST(HiddenLaws, LateReadingsAreWholeReadings) {
  const validation::LogSet a = nod("sensor_delay", 0.01),
                           b = nod("hidden_late_reading", 0.01);  // one cycle
  const validation::Column& current = *a.runs[0].find("cur.HeadPitch");
  const validation::Column& angle = *a.runs[0].find("q.HeadPitch");
  for (std::size_t k = 0; k < current.size(); ++k) {
    ASSERT_NEAR(current[k], (*b.runs[0].find("cur.HeadPitch"))[k], 1e-9) << k;
    ASSERT_NEAR(angle[k], (*b.runs[0].find("q.HeadPitch"))[k], 1e-9) << k;  // the same count
  }
  EXPECT_NE(current, *nod("sensor_delay", 0).runs[0].find("cur.HeadPitch"));
}

// On top of the robot's own delay of a cycle, of no whole number of them, while the head starts and
// stops between readings: the same count, or the next where the laws' steps round to either side.
TEST(HiddenLaws, LateReadingsKnowWhatWasBetweenCycles) {
  const validation::LogSet a = nod("sensor_delay", 0.007), b = nod("hidden_late_reading", 0.007);
  const validation::Column& angle = *a.runs[0].find("q.HeadPitch");
  const validation::Column& other = *b.runs[0].find("q.HeadPitch");
  constexpr double kCount = 2 * M_PI / 4096;
  std::size_t apart = 0;
  for (std::size_t k = 0; k < angle.size(); ++k) {
    ASSERT_NEAR(angle[k], other[k], 1.01 * kCount) << k;
    apart += std::abs(angle[k] - other[k]) > 0.5 * kCount;
  }
  EXPECT_LT(apart, angle.size() / 20);
}

}  // namespace
}  // namespace nao::hidden
