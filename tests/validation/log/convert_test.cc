#include "validation/log/convert.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/check.h"
#include "tests/core/temporary_folder.h"
#include "tests/support/models.h"
#include "validation/log/data_faults.h"
#include "validation/log/lola_rows.h"
#include "validation/log/robot_log_files.h"

namespace nao::validation {
namespace {

using ::testing::HasSubstr;

// Measured data are beside the source tree, on machines that have them.
std::string measured(const std::string& name) {
  return std::string(NAO_SOURCE_DIR) + "/../shared/measured/" + name;
}

std::string bam(int gain, double first) {
  return R"({"mass": 0.49, "length": 0.1, "kp": )" + std::to_string(gain) +
         R"(, "vin": 7.4, "motor": "xl330", "trajectory": "up_and_down", "entries": [
         {"position": )" +
         std::to_string(first) +
         R"(, "speed": 0.5, "load": 3, "input_volts": 7.3, "temp": 28, "timestamp": 0.0035,
          "goal_position": 0.25, "torque_enable": true},
         {"position": 0.1, "speed": 0, "load": 3, "input_volts": 7.3, "temp": 28,
          "timestamp": 0.0088, "goal_position": 0.25, "torque_enable": false}]})";
}

TEST(Convert, KeepsGainsOfOneServoInOneSplitEach) {
  const TemporaryFolder folder;
  folder.write("b.json", bam(100, 0.125));
  folder.write("a.json", bam(800, 0.5));
  folder.write("c.json", bam(200, 0.5));
  ASSERT_EQ(guessFormat(folder.path()), LogFormat::Bam);
  const LogSet set = convertLog(folder.path(), LogFormat::Bam, {});
  ASSERT_EQ(set.runs.size(), 3u);
  EXPECT_EQ(set.robot, "xl330_pendulum");
  EXPECT_EQ(set.runs[1].motion, "up_and_down_kp100");
  EXPECT_EQ(set.runs[0].split, Split::Fit);
  EXPECT_EQ(set.runs[1].split, Split::Fit);
  EXPECT_EQ(set.runs[2].split, Split::Select);
  EXPECT_EQ(set.runs[0].kp_scale, 8);
  EXPECT_EQ(set.runs[1].t, (std::vector<double>{0.0035, 0.0088}));
  EXPECT_EQ(*set.runs[1].find("q.pendulum"), (Column{0.125, 0.1}));
  EXPECT_EQ(*set.runs[1].find("cmd.pendulum"), (Column{0.25, 0.25}));
  EXPECT_EQ(*set.runs[1].find("cmd_stiffness.pendulum"), (Column{1, -1}));
  EXPECT_EQ(*set.runs[1].find("bat.v"), (Column{7.3, 7.3}));
}

TEST(Convert, KeepsABlindGainForTheTest) {
  const TemporaryFolder folder;
  folder.write("a.json", bam(300, 0.5));
  EXPECT_EQ(convertLog(folder.path(), LogFormat::Bam, {}).runs[0].split, Split::Test);
}

TEST(Convert, TellsWhatIsMissingInAServosLog) {
  const TemporaryFolder folder;
  std::string text = bam(100, 0);
  text.replace(text.find("goal_position"), 13, "goal");
  folder.write("a.json", text);
  try {
    convertLog(folder.path(), LogFormat::Bam, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(
        error.what(),
        HasSubstr("a.json: top.entries[0].goal_position: expected a number, found nothing"));
  }
}

TEST(Convert, TurnsPoppysDegreesIntoRadians) {
  const TemporaryFolder folder;
  const std::string file = folder.write("log.csv",
                                        "segment,step,t,load.knee,position.knee,target.knee\n"
                                        "0,0,1.0,3,90,180\n0,1,1.1,3,45,\n"
                                        "1,0,2.0,3,0,0\n1,1,2.1,3,0,0\n"
                                        "2,0,3.0,3,0,0\n2,1,3.1,3,0,0\n");
  ASSERT_EQ(guessFormat(file), LogFormat::Poppy);
  const LogSet set = convertLog(file, LogFormat::Poppy, {});
  ASSERT_EQ(set.runs.size(), 3u);
  EXPECT_DOUBLE_EQ(set.runs[0].find("q.knee")->at(0), M_PI / 2);
  EXPECT_TRUE(std::isnan(set.runs[0].find("cmd.knee")->at(1)));
  EXPECT_NEAR(set.runs[0].t[1], 0.1, 1e-12);
  EXPECT_EQ(set.runs[1].split, Split::Select);
  EXPECT_EQ(set.runs[2].split, Split::Test);
}

TEST(Convert, ReadsLogsOfMemoryKeys) {
  const TemporaryFolder folder;
  const std::string devices = "Device/SubDeviceList/";
  const std::string file =
      folder.write("log.csv", "Time," + devices + "HeadYaw/Position/Actuator/Value," + devices +
                                  "HeadYaw/Position/Sensor/Value," + devices +
                                  "HeadYaw/Hardness/Actuator/Value," + devices +
                                  "InertialSensor/AccX/Sensor/Value," + devices +
                                  "RFoot/FSR/RearLeft/Sensor/Value,Unknown\n"
                                  "0,0.5,0.25,1,-0.1,0.5,7\n0.01,0.5,0.375,1,-0.1,0.5,7\n");
  ASSERT_EQ(guessFormat(file), LogFormat::Almemory);
  const LogSet set = convertLog(file, LogFormat::Almemory, {"nao_h21_v40", "CC0", {}, "", false});
  const LogRun& run = set.runs[0];
  EXPECT_EQ(set.robot, "nao_h21_v40");
  EXPECT_EQ(set.licence, "CC0");
  EXPECT_EQ(*run.find("cmd.HeadYaw"), (Column{0.5, 0.5}));
  EXPECT_EQ(*run.find("q.HeadYaw"), (Column{0.25, 0.375}));
  EXPECT_EQ(*run.find("cmd_stiffness.HeadYaw"), (Column{1, 1}));
  EXPECT_EQ(*run.find("imu.acc.x"), (Column{-0.1, -0.1}));
  EXPECT_NEAR(run.find("fsr.R.rl")->at(0), 4.903, 0.001);
  EXPECT_EQ(run.columns.size(), 5u);
  writeLogSet(set, folder.path() + "/set");
  EXPECT_EQ(readLogSet(folder.path() + "/set").runs[0].columns.size(), 5u);
}

TEST(Convert, MakesARunOfEachLogOfMemoryKeysAndCountsFromItsBegin) {
  const TemporaryFolder folder;
  const std::string key = "Device/SubDeviceList/HeadYaw/Position/Sensor/Value";
  for (const char* name : {"nod", "shake", "bow"}) {
    folder.write(name + std::string(".csv"), "Time, " + key + "\n 86.5, 0.25\n86.75,0.375 \n");
  }
  const LogSet set = convertLog(folder.path(), LogFormat::Almemory, {});
  ASSERT_EQ(set.runs.size(), 3u);
  const std::vector<std::pair<std::string, Split>> expected = {
      {"bow", Split::Fit}, {"nod", Split::Select}, {"shake", Split::Test}};
  for (std::size_t r = 0; r < expected.size(); ++r) {
    EXPECT_EQ(set.runs[r].motion, expected[r].first);
    EXPECT_EQ(set.runs[r].split, expected[r].second);
    EXPECT_EQ(set.runs[r].t, (std::vector<double>{0, 0.25}));
    EXPECT_EQ(*set.runs[r].find("q.HeadYaw"), (Column{0.25, 0.375}));
  }
}

TEST(Convert, MakesRepeatsOfOneMotionWhereItIsToldTo) {
  const TemporaryFolder folder;
  const std::string key = "Device/SubDeviceList/LWristYaw/Position/Sensor/Value";
  for (const char* name : {"one", "two"}) {
    folder.write(name + std::string(".csv"), "Time," + key + "\n0,0.25\n0.01,0.375\n");
  }
  const LogSet set =
      convertLog(folder.path(), LogFormat::Almemory, {"", "", Split::Fit, "nod", true});
  ASSERT_EQ(set.runs.size(), 2u);
  EXPECT_TRUE(set.environment.suspended);
  EXPECT_EQ(set.robot, "nao_h25_v50");  // it has wrists
  for (const LogRun& run : set.runs) EXPECT_EQ(run.motion, "nod");
  EXPECT_EQ(set.runs[1].repeat, 1);
  EXPECT_EQ(set.runs[1].split, Split::Fit);
}

TEST(Convert, LeavesOutJointsThatTheRobotDoesNotHave) {
  const TemporaryFolder folder;
  const std::string devices = "Device/SubDeviceList/", sensor = "/Position/Sensor/Value";
  const std::string file =
      folder.write("log.csv", "Time," + devices + "HeadYaw" + sensor + "," + devices + "LWristYaw" +
                                  sensor + "\n0,0.25,1\n0.01,0.375,1\n");
  LogSet set = convertLog(file, LogFormat::Almemory, {});
  const auto left_out = leaveOutUnknownJoints(set, *test::robot("nao_h21_v33"));
  EXPECT_EQ(left_out, std::vector<std::string>{"LWristYaw"});
  ASSERT_EQ(set.joints.size(), 1u);
  EXPECT_EQ(set.joints[0].name, "HeadYaw");
  EXPECT_EQ(set.runs[0].columns.size(), 1u);
}

// "Position", "Angles": arrays of float32, as the robot sends them.
std::string pack(const char* key, const std::vector<float>& values) {
  std::string bytes(1, static_cast<char>(0xa0 | std::string(key).size()));
  bytes += key;
  bytes += {'\xdc', '\0', static_cast<char>(values.size())};
  for (const float value : values) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    bytes += '\xca';
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(bits >> shift & 0xff);
  }
  return bytes;
}

TEST(Convert, ReadsLolaFramesAndTheCommandsBetweenThem) {
  const TemporaryFolder folder;
  const std::string sensors =
      "\x82" + pack("Position", std::vector<float>(25, 0.25f)) + pack("Angles", {0.5f, 0.125f});
  const std::string command = "\x81" + pack("Position", std::vector<float>(25, 0.75f));
  const std::string file = folder.write("dump.lola", sensors + command + sensors);
  ASSERT_EQ(guessFormat(file), LogFormat::Lola);
  const LogSet set = convertLog(file, LogFormat::Lola, {});
  EXPECT_EQ(set.joints.size(), 25u);
  EXPECT_EQ(set.runs[0].t, (std::vector<double>{0, 0.012}));
  EXPECT_EQ(set.runs[0].find("q.RHand")->at(1), 0.25);
  EXPECT_EQ(set.runs[0].find("imu.ang.y")->at(0), 0.125);
  EXPECT_EQ(set.runs[0].find("cmd.LAnkleRoll")->at(0), 0.75);
  EXPECT_TRUE(std::isnan(set.runs[0].find("cmd.LAnkleRoll")->at(1)));

  const std::string broken = folder.write("broken.lola", sensors + command.substr(0, 40));
  try {
    convertLog(broken, LogFormat::Lola, {});
    FAIL();
  } catch (const InputError& error) {
    const std::string place = "byte " + std::to_string(sensors.size());
    EXPECT_THAT(error.what(), HasSubstr(place + ": expected a whole MessagePack map"));
  }
}

TEST(Convert, MakesARunOfEachFileOfLolaFrames) {
  const TemporaryFolder folder;
  const std::string frame =
      "\x82" + pack("Position", std::vector<float>(25, 0.5F)) + pack("Angles", {0.1F, 0.2F});
  for (const char* name : {"walk.lola", "kick.lola"}) folder.write(name, frame + frame);
  ASSERT_EQ(guessFormat(folder.path()), LogFormat::Lola);
  const LogSet set = convertLog(folder.path(), LogFormat::Lola, {});
  ASSERT_EQ(set.runs.size(), 2u);
  EXPECT_EQ(set.runs[0].motion, "kick");
  EXPECT_EQ(set.runs[1].split, Split::Test);
}

TEST(Convert, WritesLolaCommandsThatItReads) {
  std::vector<double> angles(25), stiffness(25, 1);
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = 0.125 * static_cast<double>(i);
  const std::string command = encodeLolaCommand(angles, stiffness);
  EXPECT_LT(command.size(), 300u);  // 32 bits a number
  EXPECT_EQ(readLolaAngles(command), angles);
  EXPECT_THROW(readLolaAngles("nothing"), InputError);
}

TEST(Convert, ReadsFramesAsARealClientSawThem) {
  const std::string captures = std::string(NAO_SOURCE_DIR) + "/../shared/captures/";
  if (!std::filesystem::exists(captures + "lola_sensor_frame.bin")) GTEST_SKIP() << "no captures";
  const std::string sensors = readPacked(captures + "lola_sensor_frame.bin");
  const std::string command = readPacked(captures + "lola_actuator_frame.bin");
  const LogRun run = readLolaRows(sensors + command + sensors, "frames");
  EXPECT_EQ(run.t.size(), 2u);
  EXPECT_EQ(run.columns.size(), 25u * 5 + 3 + 3 + 2 + 8);
  EXPECT_NEAR(run.find("imu.acc.z")->at(1), -9.81, 1e-6);
  EXPECT_EQ(readLolaAngles(sensors).size(), 25u);
}

TEST(Convert, KnowsNoOtherFiles) {
  const TemporaryFolder folder;
  EXPECT_THROW(guessFormat(folder.write("a.csv", "x,y\n1,2\n")), InputError);
  EXPECT_THROW(guessFormat(folder.path() + "/none"), InputError);
}

TEST(Convert, FindsNoFaultInTheRealServosRunsButItsEncoder) {
  if (!std::filesystem::exists(measured("rhoban_xl330"))) GTEST_SKIP() << "no measured data here";
  const LogSet set = convertLog(measured("rhoban_xl330"), LogFormat::Bam, {});
  EXPECT_EQ(set.runs.size(), 12u);
  const std::vector<DataFault> found = findDataFaults(set, nullptr);
  ASSERT_EQ(found.size(), 1u) << found.back().sentence;
  EXPECT_EQ(found[0].kind, DataFaultKind::Quantum);
  EXPECT_TRUE(found[0].note);
  EXPECT_THAT(found[0].sentence, HasSubstr("1.5340 mrad"));
}

TEST(Convert, NamesTheFaultsOfTheRealPoppysLog) {
  if (!std::filesystem::exists(measured("poppy_walk"))) GTEST_SKIP() << "no measured data here";
  const LogSet set = convertLog(measured("poppy_walk"), LogFormat::Poppy, {});
  EXPECT_EQ(set.joints.size(), 25u);
  const std::vector<DataFault> found = findDataFaults(set, nullptr);
  bool irregular = false, repeated = false;
  for (const DataFault& fault : found) {
    irregular = irregular || fault.kind == DataFaultKind::Rate;
    repeated = repeated || fault.kind == DataFaultKind::Duplicates;
    const bool expected = fault.note || fault.kind == DataFaultKind::Rate ||
                          fault.kind == DataFaultKind::Duplicates ||
                          fault.kind == DataFaultKind::Constant;
    EXPECT_TRUE(expected) << fault.sentence;
  }
  EXPECT_TRUE(irregular);
  EXPECT_TRUE(repeated);
}

}  // namespace
}  // namespace nao::validation
