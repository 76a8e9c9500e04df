#include "recorder/robot_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "core/check.h"
#include "daemon/qi_client.h"
#include "recorder/hanging.h"
#include "recorder/quiet_robot.h"
#include "tests/daemon/running_daemon.h"
#include "tests/support/models.h"
#include "validation/log/data_faults.h"
#include "validation/log/standard_motions.h"

namespace nao::recorder {
namespace {

using rpc::Value;
using validation::LogRun;
using validation::LogSet;

const std::vector<std::string> kHead{"HeadYaw", "HeadPitch"};

// A daemon of one Nao whose time stands, and a client of it.
struct StoppedNao {
  explicit StoppedNao(bool hung_up)
      : daemon(optionsOf(hung_up)), client("127.0.0.1", daemon.port()) {}

  static daemon::Options optionsOf(bool hung_up) {
    daemon::Options options = daemon::optionsForOne();
    options.paused = true;
    options.hung_up = hung_up;
    return options;
  }

  daemon::Running daemon;
  daemon::QiClient client;
};

std::shared_ptr<const RobotModel> model() {
  static const auto model = test::robot("nao_h21_v33");
  return model;
}

LogRun playHead(std::size_t motion) {
  StoppedNao nao(true);
  RobotRecorder recorder(nao.client, model(), kHead);
  const QuietRobot quiet(nao.client, kHead);
  return recorder.play(motion, 0);
}

TEST(RobotRecorder, RecordsEveryCycleOfAStoppedSimulation) {
  const LogRun run = playHead(0);
  ASSERT_GT(run.t.size(), 2u);
  EXPECT_EQ(run.t.front(), 0);
  EXPECT_GT(run.t.back(), validation::kStandardMotionTime - 0.1);
  for (std::size_t i = 1; i < run.t.size(); ++i) EXPECT_NEAR(run.t[i] - run.t[i - 1], 0.01, 1e-9);
}

// Commands of the file are those that were asked for, from the first one on.
TEST(RobotRecorder, ReadsBackWhatItCommanded) {
  const LogRun run = playHead(1);
  const Joint head_yaw = *model()->findJoint("HeadYaw");
  const validation::Column& told = *run.find("cmd.HeadYaw");
  for (std::size_t i = 0; i < run.t.size(); i += 25) {
    // Keys lie 20 ms apart, a command is sampled within 10 ms of its row, at 2 rad/s at most.
    EXPECT_NEAR(told[i], validation::standardAngles(*model(), 1, run.t[i])[head_yaw], 0.04)
        << run.t[i];
  }
}

TEST(RobotRecorder, IsTheSameEveryTimeToTheLastBit) {
  const LogRun first = playHead(0), second = playHead(0);
  EXPECT_EQ(first.t, second.t);
  EXPECT_EQ(first.columns.at("q.HeadYaw"), second.columns.at("q.HeadYaw"));
}

TEST(RobotRecorder, MakesSetsWithoutFaults) {
  StoppedNao nao(true);
  RobotRecorder recorder(nao.client, model(), kHead);
  const QuietRobot quiet(nao.client, kHead);
  LogSet set = recorder.describe("heads");
  for (std::size_t motion : {0, 1}) {
    for (int repeat : {0, 1}) set.runs.push_back(recorder.play(motion, repeat));
  }
  for (const validation::DataFault& fault : validation::findDataFaults(set, model().get())) {
    EXPECT_TRUE(fault.note) << fault.file << ": " << fault.sentence;
  }
}

TEST(RobotRecorder, TellsAHungRobotFromOneOnItsFeet) {
  for (const bool hung_up : {true, false}) {
    StoppedNao nao(hung_up);
    RobotRecorder recorder(nao.client, model(), {});
    const LogRun rows = recorder.watch(0.5);
    if (hung_up) {
      requireHanging(rows, *model());
    } else {
      EXPECT_THROW(requireHanging(rows, *model()), InputError);
    }
  }
}

TEST(RobotRecorder, RefusesJointsThatTheRobotDoesNotHave) {
  StoppedNao nao(true);
  EXPECT_THROW(RobotRecorder(nao.client, model(), {"Tail"}), InputError);
}

TEST(MemoryRows, TellsThatTheRobotsClockStands) {
  daemon::Options options = daemon::optionsForOne();
  const daemon::Running running(options);
  daemon::QiClient client("127.0.0.1", running.port());
  MemoryRows rows(client, *model(), 20);
  LogRun run;
  rows.add(run);
  client.call("UsarSim", "pause");
  EXPECT_THROW(rows.addUntil(run, 1e9), InputError);
}

TEST(QuietRobot, LeavesTheRobotAsItWas) {
  StoppedNao nao(true);
  const auto isOn = [&](const char* getter) {
    return nao.client.call("ALMotion", getter).findNumber().value_or(-1) != 0;
  };
  const auto stiffness = [&] {
    return *nao.client.call("ALMotion", "getStiffnesses", {"HeadYaw"})
                .findItems()
                ->front()
                .findNumber();
  };
  nao.client.call("ALMotion", "setSmartStiffnessEnabled", {false});
  {
    const QuietRobot quiet(nao.client, kHead);
    EXPECT_FALSE(isOn("getFallManagerEnabled"));
    EXPECT_EQ(stiffness(), 1);
  }
  EXPECT_TRUE(isOn("getFallManagerEnabled"));
  EXPECT_FALSE(isOn("getSmartStiffnessEnabled"));
  EXPECT_EQ(stiffness(), 0);
}

}  // namespace
}  // namespace nao::recorder
