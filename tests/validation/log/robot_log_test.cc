#include "validation/log/robot_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <ostream>

#include "core/check.h"
#include "core/random.h"
#include "tests/core/temporary_folder.h"

namespace nao::validation {
namespace {

using ::testing::HasSubstr;

LogSet makeSet() {
  LogSet set;
  set.name = "two joints";
  set.source = "made by a test";
  set.licence = "CC0";
  set.robot = "nao_h21_v33";
  set.version = "V3.3";
  set.serial = "ND-1";
  set.body_mass = 4.9999999999999991;
  set.rate = 100;
  set.clock = {"simulated", "executed", "measured"};
  set.environment = {"wood", 0.01, 21.5, true};
  LogJoint knee;
  knee.name = "LKneePitch";
  knee.encoder_quantum = 2 * M_PI / 4096;
  knee.kp = 151.15;
  LogJoint hip;
  hip.name = "LHipPitch";
  hip.sign = -1;
  set.joints = {knee, hip};
  Random random(3, "robot log");
  for (int r = 0; r < 2; ++r) {
    LogRun run;
    run.file = "run_" + std::to_string(r) + ".csv";
    run.motion = "tones";
    run.repeat = r;
    run.robot_id = "a";
    run.split = r == 0 ? Split::Fit : Split::Test;
    run.notes = "with \"quotes\", and commas";
    if (r == 1) run.load = LogLoad{"LTibia", 0.1, {0.01, 0, -0.05}}, run.kp_scale = 0.5;
    for (int i = 0; i < 50; ++i) {
      run.t.push_back(i / 100.0);
      for (const char* name : {"cmd.LKneePitch", "q.LKneePitch", "q.LHipPitch", "imu.acc.x"}) {
        run.columns[name].push_back(random.normal() * std::pow(10, random.uniform(-12, 12)));
      }
      run.columns["bat.v"].push_back(i % 10 == 0 ? 21.0 : kUnknown);
    }
    set.runs.push_back(run);
  }
  return set;
}

void expectSame(double a, double b) {
  if (std::isnan(a)) {
    EXPECT_TRUE(std::isnan(b));
  } else {
    EXPECT_EQ(a, b);
  }
}

TEST(RobotLog, ReadsBackWhatItWroteToTheLastBit) {
  const TemporaryFolder folder;
  const LogSet set = makeSet();
  writeLogSet(set, folder.path() + "/set");
  const LogSet back = readLogSet(folder.path() + "/set");
  EXPECT_EQ(back.serial, set.serial);
  EXPECT_EQ(back.body_mass, set.body_mass);
  EXPECT_EQ(back.clock.command_stamp, "executed");
  EXPECT_EQ(back.environment.tilt, 0.01);
  EXPECT_TRUE(back.environment.suspended);
  ASSERT_EQ(back.joints.size(), 2u);
  EXPECT_EQ(back.joints[0].encoder_quantum, set.joints[0].encoder_quantum);
  EXPECT_TRUE(std::isnan(back.joints[0].kd));
  EXPECT_EQ(back.joints[1].sign, -1);
  ASSERT_EQ(back.runs.size(), 2u);
  EXPECT_FALSE(back.runs[0].load);
  EXPECT_EQ(back.runs[1].load->p_BoBcm_B, set.runs[1].load->p_BoBcm_B);
  EXPECT_EQ(back.runs[1].kp_scale, 0.5);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(back.runs[r].split, set.runs[r].split);
    EXPECT_EQ(back.runs[r].notes, set.runs[r].notes);
    EXPECT_EQ(back.runs[r].t, set.runs[r].t);
    ASSERT_EQ(back.runs[r].columns.size(), set.runs[r].columns.size());
    for (const auto& [name, values] : set.runs[r].columns) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        expectSame(values[i], back.runs[r].find(name)->at(i));
      }
    }
  }
}

TEST(RobotLog, ReadsPackedRows) {
  const TemporaryFolder folder;
  writeLogSet(makeSet(), folder.path());
  LogSet set = makeSet();
  const std::string plain = folder.path() + "/run_0.csv";
  std::ifstream in(plain);
  const std::string rows{std::istreambuf_iterator<char>(in), {}};
  set.runs[0].file = "run_0.csv.gz";
  writeLogSet(set, folder.path());
  gzFile out = gzopen((plain + ".gz").c_str(), "wb");
  gzwrite(out, rows.data(), static_cast<unsigned>(rows.size()));
  gzclose(out);
  EXPECT_EQ(readLogSet(folder.path()).runs[0].t.size(), 50u);
}

struct Breakage {
  const char* name;
  const char* file;
  const char* from;
  const char* to;
  const char* said;
};

void PrintTo(const Breakage& one, std::ostream* out) { *out << one.name; }

class BrokenSet : public ::testing::TestWithParam<Breakage> {};

const Breakage kBreakages[] = {
    {"NoJson", "meta.json", "\"name\": \"two", "name: \"two",
     "meta.json:3: expected JSON, found a mistake in it"},
    {"OtherFormat", "meta.json", "RobotLog 1", "RobotLog 7",
     "meta.json: meta.format: expected \"RobotLog 1\", found \"RobotLog 7\""},
    {"NoSplit", "meta.json", "\"split\": \"test\",", "",
     "meta.json: meta.runs[1].split: expected a text, found nothing"},
    {"WrongSplit", "meta.json", "\"split\": \"test\"", "\"split\": \"train\"",
     "meta.runs[1].split: expected fit, select or test, found \"train\""},
    {"TextForNumber", "meta.json", "\"rate_hz\": 100.0", "\"rate_hz\": \"fast\"",
     "meta.clock.rate_hz: expected a number, found \"fast\""},
    {"UnknownKey", "meta.json", "\"tilt_rad\"", "\"tild_rad\"",
     "meta.environment.tild_rad: expected no such key"},
    {"TwiceTheSameFile", "meta.json", "run_1.csv", "run_0.csv",
     "meta.runs[1].file: expected every file once, found \"run_0.csv\""},
    {"OutsideTheFolder", "meta.json", "run_1.csv", "../run_1.csv",
     "meta.runs[1].file: expected the name of a file beside meta.json"},
    {"MissingRun", "meta.json", "run_1.csv", "run_2.csv",
     "run_2.csv: expected a file, found none that can be read"},
    {"NoTime", "run_1.csv", "t,", "time,",
     "run_1.csv: row 1: column 1: expected t, the time in seconds, found 'time'"},
    {"UnknownSignal", "run_1.csv", "imu.acc.x", "imu.acc.w",
     "run_1.csv: row 1: column 4: expected a signal that docs/robot_log.md lists, found"},
    {"UnknownJoint", "run_1.csv", "q.LHipPitch", "q.LHipPinch",
     "run_1.csv: row 1: column 5: expected a joint that meta.json lists, found 'q.LHipPinch'"},
    {"ColumnTwice", "run_1.csv", "q.LHipPitch", "q.LKneePitch",
     "run_1.csv: row 1: column 6: expected every column once, found 'q.LKneePitch'"},
    {"TooFewCells", "run_1.csv", "\n0.01,", "\n",
     "row 3: expected 6 cells as in the header, found 5"},
    {"NoNumber", "run_1.csv", "\n0.01,", "\n0.01,x",
     "run_1.csv: row 3: column bat.v: expected a number or an empty cell, found 'x"},
    {"NoTimeInARow", "run_1.csv", "\n0.01,", "\n,",
     "run_1.csv: row 3: column t: expected a number, found ''"},
    {"NotANumber", "run_1.csv", "\n0.01,", "\nnan,",
     "run_1.csv: row 3: column t: expected a number, found 'nan'"},
};
INSTANTIATE_TEST_SUITE_P(All, BrokenSet, ::testing::ValuesIn(kBreakages),
                         [](const auto& test) { return test.param.name; });

TEST_P(BrokenSet, IsToldWithPlaceAndWhatWasExpected) {
  const Breakage& broken = GetParam();
  const TemporaryFolder folder;
  writeLogSet(makeSet(), folder.path());
  const std::string file = folder.path() + "/" + broken.file;
  std::ifstream in(file);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t place = text.find(broken.from);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, std::string(broken.from).size(), broken.to);
  std::ofstream(file) << text;
  try {
    readLogSet(folder.path());
    FAIL() << "read without an error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(broken.said));
    EXPECT_THAT(error.what(), HasSubstr(folder.path()));
  }
}

TEST(RobotLog, TellsAMissingSetAndOneWithoutRows) {
  const TemporaryFolder folder;
  EXPECT_THROW(readLogSet(folder.path() + "/none"), InputError);
  writeLogSet(makeSet(), folder.path());
  std::ofstream(folder.path() + "/run_0.csv") << "t,q.LKneePitch\n";
  EXPECT_THROW(readLogSet(folder.path()), InputError);
}

TEST(LogSet, SaysWhichSplitItLacks) {
  LogSet set;
  set.name = "kicks";
  set.runs.resize(1);
  set.runs[0].split = Split::Test;
  EXPECT_NO_THROW(requireRuns(set, {Split::Select, Split::Test}));
  try {
    requireRuns(set, {Split::Fit, Split::Select});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "kicks: expected at least one run with the split fit or select");
  }
}

}  // namespace
}  // namespace nao::validation
