#include "ci/page.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/support/models.h"
#include "validation/plot.h"

namespace nao::ci {
namespace {

JobResult failed() {
  JobResult job;
  job.result.scenario = "falls";
  job.result.file = "s/falls.yaml";
  job.result.seed = 2;
  job.result.verdicts = {{false, "nao upright", "its torso tilts by 61.0 degrees",
                          std::chrono::milliseconds(2500), 4}};
  job.output = "Traceback <module>";
  job.recording = "falls-2.run";
  Course& course = job.result.course;
  course.time = {2, 2.5};
  course.stills = {{2, "UE5H"}};
  const auto model = test::robot("nao_h21_v33");
  Course::Robot robot{"nao", model->name, {0, 0.1}, {0, 0.2}, {}, {}};
  robot.asked.assign(model->jointCount(), {0, 0.1});
  robot.sensed.assign(model->jointCount(), {0, 0.2});
  course.robots = {robot};
  return job;
}

JobResult passed() {
  JobResult job;
  job.result.scenario = "stands";
  job.result.about = "It stands.";
  return job;
}

std::string pageOf(const std::vector<JobResult>& jobs) {
  return toPage(jobs, [](const std::string& name) { return test::robot(name); });
}

TEST(Page, ShowsTheLastSecondsOfWhatFailed) {
  try {
    validation::requireGnuplot();
  } catch (const InputError&) {
    GTEST_SKIP() << "gnuplot is not installed";
  }
  const std::string page = pageOf({passed(), failed()});
  for (const char* part : {"1 of 2 runs failed", "falls, seed 2", "its torso tilts by 61.0 degrees",
                           "at 2.5 s", "usarnaoqi run --scenario s/falls.yaml --seed 2",
                           "usarnaoqi replay falls-2.run", "data:image/png;base64,UE5H",
                           "Tracks on the floor", "LKneePitch", "Traceback &lt;module&gt;"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
}

// To six digits the robot is where it was: gnuplot refuses an axis without a length.
TEST(Page, DrawsARobotThatStoodStill) {
  JobResult job = failed();
  job.result.course.robots[0].x = {0.4695, 0.4695 + 1e-9};
  job.result.course.robots[0].y = {0.02377, 0.02377};
  const std::string page = pageOf({job});
  EXPECT_EQ(page.find("gnuplot could not draw"), std::string::npos);
  try {
    validation::requireGnuplot();
  } catch (const InputError&) {
    GTEST_SKIP() << "gnuplot is not installed";
  }
  EXPECT_NE(page.find("Tracks on the floor"), std::string::npos);
}

TEST(Page, NeedsNoPicturesWhereAllPassed) {
  const std::string page = pageOf({passed()});
  EXPECT_NE(page.find("All 1 runs passed"), std::string::npos);
  EXPECT_NE(page.find("It stands."), std::string::npos);
  EXPECT_EQ(page.find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace nao::ci
