#include "recorder/lola_recorder.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "recorder/hanging.h"
#include "tests/daemon/lola_daemon.h"
#include "tests/support/models.h"
#include "validation/log/standard_motions.h"

namespace nao::recorder {
namespace {

using validation::LogRun;

class LolaRecorderTest : public daemon::LolaServerTest {
 protected:
  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h25_v60");
};

TEST_F(LolaRecorderTest, RecordsARowPerFrameOfTheJointsThatMove) {
  daemon::Options options = lockstep();
  options.hung_up = true;
  daemon::LolaDaemon daemon(options);
  daemon::LolaLink link(path_);
  LolaRecorder recorder(link, model_, {"HeadYaw"});
  requireHanging(recorder.watch(0.5), *model_);
  const LogRun run = recorder.play(1, 0);
  EXPECT_EQ(run.file, "run_tones_0.csv");
  ASSERT_EQ(run.t.size(), 501u);
  const validation::Column& yaw = *run.find("cmd.HeadYaw");
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    EXPECT_NEAR(run.t[i], 0.012 * static_cast<double>(i), 1e-9);
    const auto angles = validation::standardAngles(*model_, 1, run.t[i]);
    EXPECT_NEAR(yaw[i], angles[*model_->findJoint("HeadYaw")], 1e-6);
  }
  const validation::Column& knee = *run.find("cmd.LKneePitch");
  EXPECT_EQ(knee.front(), knee.back());
}

TEST_F(LolaRecorderTest, SeesThatTheRobotStands) {
  daemon::LolaDaemon daemon(lockstep());
  daemon::LolaLink link(path_);
  LolaRecorder recorder(link, model_, {});
  EXPECT_THROW(requireHanging(recorder.watch(0.5), *model_), InputError);
}

TEST_F(LolaRecorderTest, RefusesJointsThatLolaDoesNotHave) {
  daemon::LolaDaemon daemon(lockstep());
  daemon::LolaLink link(path_);
  EXPECT_THROW(LolaRecorder(link, model_, {"Tail"}), InputError);
}

}  // namespace
}  // namespace nao::recorder
