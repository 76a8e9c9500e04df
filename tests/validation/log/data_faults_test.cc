#include "validation/log/data_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "tests/support/models.h"
#include "validation/log/simulated_recording.h"
#include "validation/log/standard_motions.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

constexpr double kQuantum = 2 * M_PI / 4096;  // [rad]
constexpr int kRepeats = 2;

double quantise(double x, double step) { return step * std::round(x / step); }

// A servo that is late by 20 ms and lags by 40 ms, with slow noise, seen through the encoder.
void follow(LogRun& run, const std::string& joint, const std::vector<double>& command,
            Random& random) {
  double angle = command.front(), noise = 0;
  Column q;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const double told = command[i < 2 ? 0 : i - 2];
    angle += 0.25 * (told - angle);
    noise += -0.1 * noise + 0.001 * random.normal();
    q.push_back(quantise(angle + noise, kQuantum));
  }
  run.columns["cmd." + joint] = command;
  run.columns["q." + joint] = q;
}

LogRun record(const RobotModel& model, std::size_t motion, int repeat, Random& random) {
  LogRun run;
  run.motion = standardMotions()[motion].name;
  run.split = standardMotions()[motion].split;
  run.repeat = repeat;
  run.file = run.motion + "_" + std::to_string(repeat) + ".csv";
  std::vector<JointArray<double>> angles;
  for (int i = 0; i <= 600; ++i) {
    run.t.push_back(i * 0.01);
    angles.push_back(standardAngles(model, motion, i * 0.01));
  }
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    std::vector<double> command;
    for (const auto& angle : angles) command.push_back(angle[j]);
    follow(run, model.actuators[j].name, command, random);
  }
  return run;
}

LogSet makeCleanSet(const RobotModel& model) {
  Random random(7, "data faults");
  LogSet set;
  set.robot = model.name;
  set.rate = 100;
  for (const Actuator& actuator : model.actuators) {
    LogJoint joint;
    joint.name = actuator.name;
    joint.encoder_quantum = kQuantum;
    set.joints.push_back(joint);
  }
  for (std::size_t m = 0; m < standardMotions().size(); ++m) {
    for (int r = 0; r < kRepeats; ++r) set.runs.push_back(record(model, m, r, random));
  }
  return set;
}

class DataFaults : public ::testing::Test {
 protected:
  DataFaults() {
    static const LogSet kClean = makeCleanSet(*model_);  // made once for all tests
    set_ = kClean;
  }

  Column& column(std::size_t run, const std::string& name) { return set_.runs[run].columns[name]; }

  std::vector<DataFault> find() const {
    std::vector<DataFault> faults = findDataFaults(set_, model_.get());
    faults.erase(std::remove_if(faults.begin(), faults.end(), [](auto& f) { return f.note; }),
                 faults.end());
    return faults;
  }
  // Exactly this fault and no other.
  void expectOnly(DataFaultKind kind, const std::string& file, const std::string& column) const {
    const std::vector<DataFault> faults = find();
    for (const DataFault& fault : faults) SCOPED_TRACE(fault.sentence);
    ASSERT_EQ(faults.size(), 1u) << (faults.empty()
                                         ? ""
                                         : faults[0].sentence + "\n" + faults.back().sentence);
    EXPECT_EQ(nameOf(faults[0].kind), std::string(nameOf(kind))) << faults[0].sentence;
    EXPECT_EQ(faults[0].file, file) << faults[0].sentence;
    EXPECT_EQ(faults[0].column, column) << faults[0].sentence;
  }

  const std::shared_ptr<const RobotModel> model_ = test::robot("nao_h21_v33");
  LogSet set_;
};

TEST_F(DataFaults, AreNotFoundInACleanSetWhoseEncoderIsNoted) {
  const std::vector<DataFault> all = findDataFaults(set_, model_.get());
  EXPECT_FALSE(anyFault(all)) << all.front().sentence;
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].kind, DataFaultKind::Quantum);
  EXPECT_NE(all[0].sentence.find("1.5340 mrad"), std::string::npos) << all[0].sentence;
}

TEST_F(DataFaults, TellTimesThatGoBack) {
  std::swap(set_.runs[3].t[200], set_.runs[3].t[201]);
  expectOnly(DataFaultKind::Clock, "tones_1.csv", "");
  EXPECT_EQ(find()[0].row, 203u);  // the header is row 1
}

TEST_F(DataFaults, TellTimesOfAnotherClock) {
  for (double& t : set_.runs[3].t) t += 1353.2;
  expectOnly(DataFaultKind::Clock, "tones_1.csv", "");
  EXPECT_EQ(find()[0].row, 2u);
}

TEST_F(DataFaults, TellMissingRows) {
  LogRun& run = set_.runs[4];
  run.t.erase(run.t.begin() + 100, run.t.begin() + 107);
  for (auto& [name, values] : run.columns) {
    values.erase(values.begin() + 100, values.begin() + 107);
  }
  expectOnly(DataFaultKind::Gap, "reach_0.csv", "");
  EXPECT_EQ(find()[0].row, 102u);
}

TEST_F(DataFaults, TellIrregularRows) {
  Random random(5, "irregular");
  for (LogRun& run : set_.runs) {
    for (double& t : run.t) t += random.uniform(-0.0045, 0.0045);
  }
  expectOnly(DataFaultKind::Rate, "triangles_0.csv", "");
}

TEST_F(DataFaults, TellARateThatIsNotTheStatedOne) {
  set_.rate = 50;
  expectOnly(DataFaultKind::Rate, "triangles_0.csv", "");
}

TEST_F(DataFaults, TellPollingThatRepeatsHalfOfTheSamples) {
  for (LogRun& run : set_.runs) {
    for (auto& [name, values] : run.columns) {
      if (name[0] != 'q') continue;
      for (std::size_t i = 1; i < values.size(); i += 2) values[i] = values[i - 1];
    }
  }
  const std::vector<DataFault> faults = find();
  ASSERT_EQ(faults.size(), 1u) << faults.back().sentence;
  EXPECT_EQ(faults[0].kind, DataFaultKind::Duplicates);
  EXPECT_EQ(faults[0].column, "");
}

TEST_F(DataFaults, TellAFewDroppedReadingsOfOneJoint) {
  Random random(5, "drops");
  for (LogRun& run : set_.runs) {
    Column& q = run.columns["q.LKneePitch"];
    for (std::size_t i = 1; i < q.size(); ++i) {
      if (random.uniform() < 0.02) q[i] = q[i - 1];
    }
  }
  const std::vector<DataFault> faults = find();
  ASSERT_EQ(faults.size(), 1u) << faults.back().sentence;
  EXPECT_EQ(faults[0].kind, DataFaultKind::Duplicates);
  EXPECT_EQ(faults[0].column, "q.LKneePitch");
}

TEST_F(DataFaults, TellAnEncoderThatIsCoarserThanStated) {
  for (LogRun& run : set_.runs) {
    for (double& q : run.columns["q.RHipPitch"]) q = quantise(q, 0.02);
  }
  expectOnly(DataFaultKind::Quantum, "", "q.RHipPitch");
  EXPECT_TRUE(isOneCoarseEncoder(find().at(0)));
}

TEST_F(DataFaults, TellOneCoarseEncoderFromACoarseRecording) {
  for (LogRun& run : set_.runs) {
    for (const LogJoint& joint : set_.joints) {
      for (double& q : run.columns["q." + joint.name]) q = quantise(q, 0.01);
    }
  }
  expectOnly(DataFaultKind::Quantum, "", "");
  EXPECT_FALSE(isOneCoarseEncoder(find().at(0)));
}

TEST_F(DataFaults, TellSwappedJoints) {
  for (LogRun& run : set_.runs) {
    std::swap(run.columns["q.LElbowRoll"], run.columns["q.RShoulderPitch"]);
  }
  expectOnly(DataFaultKind::Swapped, "", "q.LElbowRoll");
}

TEST_F(DataFaults, TellANegatedJoint) {
  for (LogRun& run : set_.runs) {
    for (double& q : run.columns["q.LAnkleRoll"]) q = -q;
  }
  expectOnly(DataFaultKind::Negated, "", "q.LAnkleRoll");
}

TEST_F(DataFaults, TellAJointWhoseRowsAreShuffled) {
  for (LogRun& run : set_.runs) {
    Column& q = run.columns["q.RKneePitch"];
    std::reverse(q.begin(), q.end());
    std::rotate(q.begin(), q.begin() + 137, q.end());
  }
  expectOnly(DataFaultKind::Unrelated, "", "q.RKneePitch");
}

TEST_F(DataFaults, TellDegreesForRadians) {
  for (LogRun& run : set_.runs) {
    for (double& q : run.columns["q.HeadYaw"]) q *= 180 / M_PI;
  }
  expectOnly(DataFaultKind::Units, "triangles_0.csv", "q.HeadYaw");
}

TEST_F(DataFaults, TellASetThatIsAllInDegrees) {
  for (LogRun& run : set_.runs) {
    for (auto& [name, values] : run.columns) {
      for (double& angle : values) angle *= 180 / M_PI;
    }
  }
  const std::vector<DataFault> faults = find();
  ASSERT_FALSE(faults.empty());
  for (const DataFault& fault : faults) {
    EXPECT_EQ(nameOf(fault.kind), std::string("units")) << fault.sentence;
  }
}

TEST_F(DataFaults, TellADeadChannel) {
  for (double& q : column(6, "q.LHipRoll")) q = 0.3;
  expectOnly(DataFaultKind::Constant, "stairs_0.csv", "q.LHipRoll");
}

TEST_F(DataFaults, TellSensorsThatRunAheadOfTheCommands) {
  for (LogRun& run : set_.runs) {
    for (auto& [name, values] : run.columns) {
      if (name[0] == 'q') std::rotate(values.begin(), values.begin() + 12, values.end());
    }
  }
  expectOnly(DataFaultKind::Offset, "", "");
}

TEST_F(DataFaults, TellOneRunWhoseSensorsAreLate) {
  for (auto& [name, values] : set_.runs[2].columns) {
    if (name[0] == 'q') std::rotate(values.begin(), values.end() - 8, values.end());
  }
  expectOnly(DataFaultKind::Offset, "tones_0.csv", "");
}

TEST_F(DataFaults, TellARepeatThatBeginsLater) {
  for (auto& [name, values] : set_.runs[3].columns) {
    std::rotate(values.begin(), values.end() - 10, values.end());
  }
  expectOnly(DataFaultKind::Misaligned, "tones_1.csv", "");
}

TEST_F(DataFaults, TellARepeatOfAnotherMotion) {
  set_.runs[3].motion = "quick";
  set_.runs[3].split = Split::Test;
  expectOnly(DataFaultKind::Misaligned, "quick_0.csv", "");
}

TEST_F(DataFaults, TellReadingsOfTheTestAmongThoseOfTheFit) {
  for (auto& [name, values] : set_.runs[12].columns) {
    if (name[0] == 'q') values = column(0, name);
    if (name[0] == 'c') values = column(0, name);
  }
  set_.runs[12].motion = "another";
  expectOnly(DataFaultKind::Copied, "quick_0.csv", "");
}

TEST_F(DataFaults, TellAMotionOfTwoPurposes) {
  set_.runs[3].split = Split::Test;
  expectOnly(DataFaultKind::Split, "tones_1.csv", "");
}

// What a diagnosis is to find must not be called a fault of the data.
TEST_F(DataFaults, AreNotStopsNorPlayNorWeakJointsNorMirroredMotions) {
  for (LogRun& run : set_.runs) {
    for (double& q : run.columns["q.LKneePitch"]) q = std::min(q, 0.9);             // a stop
    for (double& q : run.columns["q.RKneePitch"]) q = quantise(0.8 * q, kQuantum);  // weak
    double play = 0;
    for (double& q : run.columns["q.HeadPitch"]) {
      play = std::clamp(play, q - 0.05, q + 0.05);
      q = quantise(play, kQuantum);
    }
    run.columns["cmd.RShoulderPitch"] = run.columns["cmd.LShoulderPitch"];
    run.columns["q.RShoulderPitch"] = run.columns["q.LShoulderPitch"];
    for (double& c : run.columns["cmd.RHipRoll"]) c = -0.2;  // told to stay, and stays
    for (double& q : run.columns["q.RHipRoll"]) q = quantise(-0.2, kQuantum);
  }
  const std::vector<DataFault> faults = find();
  EXPECT_TRUE(faults.empty()) << faults.front().sentence;
}

// Such as those that are shaken by others.
TEST_F(DataFaults, AreNotJointsThatHardlyMove) {
  for (LogRun& run : set_.runs) {
    Column& q = run.columns["q.HeadPitch"];
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] = quantise(0.003 * std::sin(0.3 * static_cast<double>(i)), kQuantum);
      run.columns["cmd.HeadPitch"][i] = 0;
    }
  }
  const std::vector<DataFault> faults = find();
  EXPECT_TRUE(faults.empty()) << faults.front().sentence;
}

TEST(SimulatedData, HaveNoFaults) {
  RecordingPlan plan;
  const auto model = test::robot("nao_h21_v33");
  plan.model = std::make_shared<RobotModel>(stripped(suspend(*model)));
  plan.motions = standardRecording(plan.model);
  plan.repeats = 2;
  plan.step = std::chrono::milliseconds(1);
  plan.start_sd = 0.001;
  plan.extra = {{"process_noise", {}, {}, ""}};
  const std::vector<DataFault> found = findDataFaults(recordSimulated(plan), model.get());
  EXPECT_FALSE(anyFault(found)) << found.back().sentence;
}

// A held command makes a staircase of pauses, which are no repeated readings.
TEST(SimulatedData, HaveNoFaultsBecauseOfACause) {
  RecordingPlan plan;
  const auto model = test::robot("nao_h21_v33");
  plan.model = std::make_shared<RobotModel>(stripped(suspend(*model)));
  plan.motions = standardRecording(plan.model);
  plan.repeats = 1;
  plan.step = std::chrono::milliseconds(2);
  for (const char* cause : {"command_hold", "backlash", "torque_limit"}) {
    plan.extra = {{"process_noise", {}, {}, ""}, {cause, {}, {}, ""}};
    const std::vector<DataFault> found = findDataFaults(recordSimulated(plan), model.get());
    EXPECT_FALSE(anyFault(found)) << cause << ": " << found.front().sentence;
  }
}

TEST(SimulatedData, TellDroppedReadings) {
  RecordingPlan plan;
  const auto model = test::robot("nao_h21_v33");
  plan.model = std::make_shared<RobotModel>(stripped(suspend(*model)));
  plan.motions = standardRecording(plan.model);
  plan.repeats = 1;
  plan.step = std::chrono::milliseconds(1);
  plan.extra = {{"process_noise", {}, {}, ""}, {"dropped_samples", {}, {}, ""}};
  const std::vector<DataFault> found = findDataFaults(recordSimulated(plan), model.get());
  ASSERT_TRUE(anyFault(found));
  for (const DataFault& fault : found) {
    EXPECT_TRUE(fault.note || fault.kind == DataFaultKind::Duplicates) << fault.sentence;
  }
}

}  // namespace
}  // namespace nao::validation
