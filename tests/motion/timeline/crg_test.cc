#include "motion/timeline/crg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "core/check.h"
#include "motion/timeline/gunzip.h"
#include "motion/timeline/motion_file.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kExact = 1e-9;

// A behavior of ours, packed with tar, gzip and ar: four joints, four keys at 8 frames a second.
const char* const kPacked = NAO_SOURCE_DIR "/tests/data/motions/nod.crg";

std::string bytesOf(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

std::string packed() {
  std::ifstream file(kPacked, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string errorOf(const std::string& bytes) {
  try {
    readCrg(bytes, "a.crg", *makeTestRobot());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const char* const kFixed = "1f8b0800000000000203cbcb4f51c8436000249e43aa0f000000";
const char* const kStored =
    "1f8b0800000000000403010f00f0ff6e6f64206e6f64206e6f64206e6f64249e43aa0f000000";

TEST(Gunzip, UnpacksFixedAndStoredBlocks) {
  EXPECT_EQ(gunzip(bytesOf(kFixed)), "nod nod nod nod");
  EXPECT_EQ(gunzip(bytesOf(kStored)), "nod nod nod nod");
}

TEST(Gunzip, EveryCutAndEveryChangedByteOfTheDataIsNoticed) {
  const std::string good = bytesOf(kFixed);
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_THROW(gunzip(good.substr(0, size)), GzipError) << size;
  }
  constexpr std::size_t kHeader = 10;  // time and system say nothing about the data
  for (std::size_t i = kHeader; i < good.size(); ++i) {
    std::string broken = good;
    broken[i] = static_cast<char>(broken[i] ^ 0x55);
    EXPECT_THROW(gunzip(broken), GzipError) << i;
  }
}

TEST(Crg, TheBehaviorInsideIsPlayed) {
  const auto robot = makeTestRobot();
  const Timeline timeline = loadMotion(kPacked, *robot);
  EXPECT_NEAR(timeline.length, 5, kExact);  // 40 frames
  ASSERT_EQ(timeline.curves.size(), 4u);
  for (const Curve& curve : timeline.curves) {
    if (curve.joint != *robot->findJoint("RShoulderPitch")) continue;
    EXPECT_NEAR(curve.keys.at(2).time, 30 / 8.0, kExact);
    EXPECT_NEAR(curve.keys.at(2).angle, 65 * kDegree, kExact);
  }
}

TEST(Crg, WhatIsWrongIsTold) {
  const std::string good = packed();
  EXPECT_EQ(errorOf("text"), "a.crg:1: this is no ar archive");
  EXPECT_EQ(errorOf("!<arch>\n"), "a.crg:1: expected a data.tar.gz in this archive");
  EXPECT_EQ(errorOf(good.substr(0, good.size() - 50)),
            "a.crg:1: expected a data.tar.gz in this archive");
  std::string broken = good;
  broken[good.size() - 40] = static_cast<char>(broken[good.size() - 40] ^ 0x55);
  EXPECT_EQ(errorOf(broken).rfind("a.crg:1: its data.tar.gz can not be unpacked: ", 0), 0u);
}

}  // namespace
}  // namespace nao::motion
