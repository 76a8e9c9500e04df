// The experiments about postures, one run of each without chance.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/experiment.h"
#include "validation/posture_trial.h"

namespace nao::validation {
namespace {

Report reportOf(const std::string& name) {
  for (const Experiment& experiment : experiments()) {
    if (experiment.name != name) continue;
    ExperimentSettings settings = experiment.defaults;
    settings.robots_dir = NAO_SOURCE_DIR "/robots";
    settings.seed = 0;
    settings.runs = 1;
    return experiment.run(settings).report;
  }
  throw std::runtime_error("no experiment " + name);
}

template <typename T>
const T& figure(const Report& report, const std::string& name) {
  for (const Figure& figure : report.figures) {
    if (figure.name == name) return std::get<T>(figure.value);
  }
  throw std::runtime_error("no figure " + name);
}

TEST(StandUpExperiment, CountsRobotsThatStandInTheEnd) {
  const Report report = reportOf("standup");
  EXPECT_EQ(figure<double>(report, "runs"), 1);
  EXPECT_EQ(figure<double>(report, "back_success"), 1);
  EXPECT_EQ(figure<double>(report, "front_success"), 1);
  EXPECT_LT(figure<Statistics>(report, "back_tilt_deg").max, 10);
  EXPECT_EQ(figure<std::vector<Row>>(report, "rows").size(), 4u);
}

TEST(PosturesExperiment, GoesFromEveryPostureToEveryOther) {
  const Report report = reportOf("postures");
  EXPECT_EQ(figure<double>(report, "pairs"), 8 * 7);
  EXPECT_EQ(figure<double>(report, "reached"), 8 * 7);
}

double pitchOf(PostureTrial& trial) {
  return -std::asin(trial.trial().bodies().front().linear()(2, 0));
}

class SeatedNao : public testing::TestWithParam<const char*> {
 protected:
  static ExperimentSettings settings() {
    ExperimentSettings settings;
    settings.robots_dir = NAO_SOURCE_DIR "/robots";
    settings.robot = GetParam();
    return settings;
  }
};

// The angles of the torso that NAOqi 2.8 has beside its postures' joints: on its seat the robot
// leans as the real one does. 3 degrees are what play and sag leave in hips and knees.
TEST_P(SeatedNao, SitsAsUprightAsPublished) {
  PostureTrial trial(settings(), 0);
  constexpr double kNear = 3 * M_PI / 180;
  EXPECT_TRUE(trial.goTo("SitRelax", 1).there);
  EXPECT_NEAR(pitchOf(trial), -0.237, kNear);
  EXPECT_TRUE(trial.goTo("Sit", 1).there);
  EXPECT_NEAR(pitchOf(trial), -0.2884, kNear);
}

// Also after a fall, and with other zeros, masses and friction than the nominal ones.
TEST_P(SeatedNao, SitsUpFromItsBack) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    PostureTrial trial(settings(), seed);
    trial.knockOver(-45, 0);
    EXPECT_TRUE(trial.goTo("Sit").there) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, SeatedNao,
                         testing::Values("nao_h21_v33", "nao_h21_v40", "nao_h25_v33", "nao_h25_v40",
                                         "nao_h25_v50", "nao_h25_v60"),
                         [](const auto& robot) { return robot.param; });

TEST(PostureTrial, BelievesNoRobotThatLies) {
  ExperimentSettings settings;
  settings.robots_dir = NAO_SOURCE_DIR "/robots";
  PostureTrial trial(settings, 0);
  EXPECT_TRUE(trial.isReallyIn("StandInit"));
  EXPECT_FALSE(trial.isReallyIn("Crouch"));
  trial.knockOver(-45, 0);
  EXPECT_FALSE(trial.isReallyIn("StandInit"));
  const Arrival arrival = trial.goTo("LyingBack");
  EXPECT_TRUE(arrival.there);
  EXPECT_GT(arrival.tilt_deg, 60);
}

}  // namespace
}  // namespace nao::validation
