#include "naoqi_api/memory/device_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "naoqi_api/memory/idle_devices.h"
#include "tests/support/models.h"

namespace nao::memory {
namespace {

namespace fs = std::filesystem;
using rpc::Value;
using ::testing::UnorderedElementsAreArray;

constexpr char kPrefix[] = "Device/SubDeviceList/";

// A robot whose every sensor and command shows a number of its own.
class DeviceKeysTest : public ::testing::Test {
 protected:
  explicit DeviceKeysTest(const std::string& robot = "nao_h21_v33")
      : model_(test::robot(robot)),
        ports_(std::make_shared<motion::RobotPorts>()),
        keys_(*model_, ports_) {}

  void publish() {
    ports_->sensors.publish(frame_);
    ports_->state.publish(state_);
  }

  float read(const std::string& key) const {
    const auto value = keys_.find(key);
    const auto* number = value ? value->find<float>() : nullptr;
    return number ? *number : std::nanf("");
  }

  SensorFrame makeFrame() const {
    SensorFrame frame;
    frame.angle = JointArray<double>(model_->jointCount());
    frame.current = JointArray<double>(model_->jointCount());
    frame.temperature = JointArray<double>(model_->jointCount(), 27);
    frame.overheating = JointArray<std::uint8_t>(model_->jointCount());
    return frame;
  }

  motion::MotionState makeState() const {
    motion::MotionState state;
    state.command.angle = JointArray<double>(model_->jointCount());
    state.command.stiffness = JointArray<double>(model_->jointCount());
    return state;
  }

  std::shared_ptr<const RobotModel> model_;
  std::shared_ptr<motion::RobotPorts> ports_;
  DeviceKeys keys_;
  SensorFrame frame_ = makeFrame();
  motion::MotionState state_ = makeState();
};

TEST_F(DeviceKeysTest, HasNothingToShowBeforeTheFirstCycle) {
  EXPECT_NE(keys_.findView("Device/SubDeviceList/HeadYaw/Position/Sensor/Value"), nullptr);
  EXPECT_FALSE(keys_.find("Device/SubDeviceList/HeadYaw/Position/Sensor/Value"));
}

TEST_F(DeviceKeysTest, ShowsEachJointsOwnValues) {
  for (std::size_t i = 0; i < model_->jointCount(); ++i) {
    const double n = 0.01 * static_cast<double>(i);
    frame_.angle[i] = 1 + n;
    frame_.current[i] = 2 + n;
    frame_.temperature[i] = 30 + n;
    state_.command.angle[i] = 3 + n;
    state_.command.stiffness[i] = n;
  }
  publish();
  for (std::size_t i = 0; i < model_->jointCount(); ++i) {
    const std::string device = kPrefix + model_->actuators[i].name + "/";
    const auto n = 0.01F * static_cast<float>(i);
    EXPECT_FLOAT_EQ(read(device + "Position/Sensor/Value"), 1 + n);
    EXPECT_FLOAT_EQ(read(device + "ElectricCurrent/Sensor/Value"), 2 + n);
    EXPECT_FLOAT_EQ(read(device + "Temperature/Sensor/Value"), 30 + n);
    EXPECT_FLOAT_EQ(read(device + "Position/Actuator/Value"), 3 + n);
    EXPECT_FLOAT_EQ(read(device + "Hardness/Actuator/Value"), n);
  }
}

TEST_F(DeviceKeysTest, TheSharedHipMotorHasOneDeviceAndTwoMotionKeys) {
  const auto hip = model_->findJoint("LHipYawPitch");
  ASSERT_TRUE(hip);
  frame_.angle[*hip] = -0.5;
  publish();
  EXPECT_EQ(keys_.findView("Device/SubDeviceList/RHipYawPitch/Position/Sensor/Value"), nullptr);
  EXPECT_FLOAT_EQ(read("Motion/Position/Sensor/LHipYawPitch"), -0.5F);
  EXPECT_FLOAT_EQ(read("Motion/Position/Sensor/RHipYawPitch"), -0.5F);
}

TEST_F(DeviceKeysTest, FollowsTheNewestFrame) {
  publish();
  EXPECT_FLOAT_EQ(read("Device/SubDeviceList/InertialSensor/AngleX/Sensor/Value"), 0);
  frame_.angle_x = 0.25;
  publish();
  EXPECT_FLOAT_EQ(read("Device/SubDeviceList/InertialSensor/AngleX/Sensor/Value"), 0.25F);
}

TEST_F(DeviceKeysTest, KeysReadFromOneMomentAgree) {
  publish();
  const DeviceKeys::Frames before = keys_.frames();
  frame_.angle_x = 0.25;
  publish();
  const auto value = keys_.find("Device/SubDeviceList/InertialSensor/AngleX/Sensor/Value", before);
  EXPECT_EQ(value, Value(0.0F));
}

TEST_F(DeviceKeysTest, InertialKeysOfBothGenerationsShowTheSame) {
  frame_.accelerometer = Vec3(0.1, 0.2, -9.8);
  frame_.gyroscope = Vec3(1, 2, 3);
  frame_.angle_x = 0.4;
  frame_.angle_y = 0.5;
  frame_.angle_z = 0.6;
  publish();
  const std::string device = "Device/SubDeviceList/InertialSensor/";
  const std::string axes = "XYZ";
  for (int i = 0; i < 3; ++i) {
    const std::string end = axes.substr(static_cast<std::size_t>(i), 1) + "/Sensor/Value";
    const auto acceleration = static_cast<float>(frame_.accelerometer[i]);
    const auto rate = static_cast<float>(frame_.gyroscope[i]);
    EXPECT_FLOAT_EQ(read(device + "Acc" + end), acceleration);
    EXPECT_FLOAT_EQ(read(device + "Accelerometer" + end), acceleration);
    EXPECT_FLOAT_EQ(read(device + "Gyr" + end), rate);
    EXPECT_FLOAT_EQ(read(device + "Gyroscope" + end), rate);
    EXPECT_FLOAT_EQ(read(device + "Angle" + end), 0.4F + 0.1F * static_cast<float>(i));
  }
}

TEST_F(DeviceKeysTest, FeetWeighInKilograms) {
  FootForces& left = frame_.feet[index(Foot::Left)];
  left.force = {9.80665, 2 * 9.80665, 0, 0.5 * 9.80665};
  left.total = 3.5 * 9.80665;
  left.cop_x = 0.02;
  left.cop_y = -0.01;
  publish();
  const std::string fsr = "Device/SubDeviceList/LFoot/FSR/";
  EXPECT_FLOAT_EQ(read(fsr + "FrontLeft/Sensor/Value"), 1);
  EXPECT_FLOAT_EQ(read(fsr + "FrontRight/Sensor/Value"), 2);
  EXPECT_FLOAT_EQ(read(fsr + "RearRight/Sensor/Value"), 0.5F);
  EXPECT_FLOAT_EQ(read(fsr + "TotalWeight/Sensor/Value"), 3.5F);
  EXPECT_FLOAT_EQ(read(fsr + "CenterOfPressure/X/Sensor/Value"), 0.02F);
  EXPECT_FLOAT_EQ(read(fsr + "CenterOfPressure/Y/Sensor/Value"), -0.01F);
  EXPECT_FLOAT_EQ(read("leftFootTotalWeight"), 3.5F);
  EXPECT_FLOAT_EQ(read("rightFootTotalWeight"), 0);
  EXPECT_FLOAT_EQ(read("leftFootContact"), 1);
  EXPECT_FLOAT_EQ(read("rightFootContact"), 0);
  EXPECT_FLOAT_EQ(read("footContact"), 1);
}

TEST_F(DeviceKeysTest, ButtonsAndBumpersShowOneWhenPressed) {
  frame_.touch.chest_button = true;
  frame_.feet[index(Foot::Right)].bumper = {false, true};
  publish();
  EXPECT_FLOAT_EQ(read("Device/SubDeviceList/ChestBoard/Button/Sensor/Value"), 1);
  EXPECT_FLOAT_EQ(read("Device/SubDeviceList/RFoot/Bumper/Left/Sensor/Value"), 0);
  EXPECT_FLOAT_EQ(read("Device/SubDeviceList/RFoot/Bumper/Right/Sensor/Value"), 1);
  EXPECT_FLOAT_EQ(read("RightBumperPressed"), 1);
  EXPECT_FLOAT_EQ(read("LeftBumperPressed"), 0);
  EXPECT_EQ(keys_.findView("RightBumperPressed")->type, KeyType::Event);
}

TEST_F(DeviceKeysTest, EveryEchoOfBothReceiversHasItsKey) {
  for (std::size_t echo = 0; echo < kSonarEchoes; ++echo) {
    frame_.sonar[0][echo] = 0.3 + 0.1 * static_cast<double>(echo);
    frame_.sonar[1][echo] = 1.3 + 0.1 * static_cast<double>(echo);
  }
  publish();
  const std::string device = "Device/SubDeviceList/US/";
  EXPECT_FLOAT_EQ(read(device + "Left/Sensor/Value"), 0.3F);
  EXPECT_FLOAT_EQ(read(device + "Left/Sensor/Value9"), 1.2F);
  EXPECT_FLOAT_EQ(read(device + "Right/Sensor/Value"), 1.3F);
  EXPECT_FLOAT_EQ(read(device + "Right/Sensor/Value4"), 1.7F);
  EXPECT_FLOAT_EQ(read(device + "Sensor/Value"), 0.3F);
}

TEST_F(DeviceKeysTest, BatteryKeysShowTheBattery) {
  frame_.battery = {0.75, -2.5, 24, 31};
  publish();
  const std::string battery = "Device/SubDeviceList/Battery/";
  EXPECT_FLOAT_EQ(read(battery + "Charge/Sensor/Value"), 0.75F);
  EXPECT_FLOAT_EQ(read(battery + "Current/Sensor/Value"), -2.5F);
  EXPECT_FLOAT_EQ(read(battery + "Temperature/Sensor/Value"), 31);
}

TEST_F(DeviceKeysTest, AHotMotorSaysSoAndItsNeighbourDoesNot) {
  frame_.overheating[*model_->findJoint("LKneePitch")] = 2;
  publish();
  EXPECT_EQ(keys_.find("Device/SubDeviceList/LKneePitch/Temperature/Sensor/Status"), Value(2));
  EXPECT_EQ(keys_.find("Device/SubDeviceList/RKneePitch/Temperature/Sensor/Status"), Value(0));
}

TEST_F(DeviceKeysTest, EveryLightShowsItsOwnBrightness) {
  const std::vector<std::string> names = ledNames(*model_);
  for (std::size_t i = 0; i < names.size(); ++i) {
    frame_.leds[i] = 0.01F * static_cast<float>(i);
  }
  publish();
  EXPECT_EQ(names.size(), 77U);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(read(kPrefix + names[i] + "/Actuator/Value"), 0.01F * static_cast<float>(i));
  }
}

TEST_F(DeviceKeysTest, EachPlaceOfTheHeadHasItsKeyAndItsEvent) {
  const std::array<std::string, 3> places = {"Front", "Middle", "Rear"};
  for (std::size_t touched = 0; touched < places.size(); ++touched) {
    frame_.touch.head = {};
    frame_.touch.head[touched] = true;
    publish();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const float expected = i == touched ? 1 : 0;
      EXPECT_EQ(read("Device/SubDeviceList/Head/Touch/" + places[i] + "/Sensor/Value"), expected);
      EXPECT_EQ(read(places[i] + "TactilTouched"), expected);
    }
  }
}

TEST_F(DeviceKeysTest, AwakeAndFallenAreShownAsEvents) {
  state_.awake = true;
  publish();
  EXPECT_EQ(keys_.find("robotIsWakeUp"), Value(true));
  EXPECT_EQ(keys_.find("robotHasFallen"), Value(false));
}

class DeviceKeysOfHumanHands : public DeviceKeysTest {
 protected:
  DeviceKeysOfHumanHands() : DeviceKeysTest("nao_h25_v50") {}
};

TEST_F(DeviceKeysOfHumanHands, EachPlaceOfAHandHasItsKeyAndItsEvent) {
  frame_.touch.hand[1] = {false, true, false};
  publish();
  EXPECT_EQ(read("Device/SubDeviceList/RHand/Touch/Back/Sensor/Value"), 1);
  EXPECT_EQ(read("Device/SubDeviceList/RHand/Touch/Left/Sensor/Value"), 0);
  EXPECT_EQ(read("Device/SubDeviceList/LHand/Touch/Back/Sensor/Value"), 0);
  EXPECT_EQ(read("HandRightBackTouched"), 1);
  EXPECT_EQ(read("HandLeftBackTouched"), 0);
}

std::set<std::string> storedKeys(const RobotModel& model) {
  std::set<std::string> names;
  for (const auto& [key, value] : idleDevices(model)) EXPECT_TRUE(names.insert(key).second) << key;
  for (const auto& [key, value] : fixedKeys(model, "nao")) {
    EXPECT_TRUE(names.insert(key).second) << key;
  }
  return names;
}

TEST_F(DeviceKeysTest, NoKeyIsBothStoredAndMeasured) {
  for (const std::string& key : storedKeys(*model_)) EXPECT_EQ(keys_.findView(key), nullptr) << key;
}

TEST_F(DeviceKeysTest, OnlyRobotsWithHandsHaveTheirKeys) {
  EXPECT_EQ(keys_.findView("Device/SubDeviceList/LHand/Touch/Back/Sensor/Value"), nullptr);
  EXPECT_EQ(keys_.findView("HandLeftBackTouched"), nullptr);
}

TEST_F(DeviceKeysTest, NamesTheBodyAsARobotDoes) {
  const auto with_hands = test::robot("nao_h25_v50");
  std::map<std::string, Value> keys;
  for (const auto& [key, value] : fixedKeys(*with_hands, "nao")) keys.emplace(key, value);
  EXPECT_EQ(keys["RobotConfig/Body/Type"], Value("Nao"));
  EXPECT_EQ(keys["RobotConfig/Body/BaseVersion"], Value("V5.0"));
  EXPECT_EQ(keys["RobotConfig/Body/Version"], Value("5.0.0"));
  EXPECT_EQ(keys["Device/DeviceList/ChestBoard/BodyNickName"], Value("nao"));
}

// The keys that NAOqi 2.1 documents for V3.3, V4 and V5, from the tables beside the repository.
std::set<std::string> documentedKeys(const fs::path& table) {
  std::set<std::string> keys;
  std::ifstream file(table);
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("2.1 ", 0) != 0) continue;
    std::vector<std::string> fields;
    std::size_t start = 0;
    for (std::size_t comma; (comma = line.find(',', start)) != std::string::npos;) {
      fields.push_back(line.substr(start, comma - start));
      start = comma + 1;
    }
    if (fields.size() > 3) keys.insert(fields[3]);
  }
  return keys;
}

// Documented keys that a body does not have, and no others.
std::vector<std::string> absentFrom(const RobotModel& model, const std::set<std::string>& all) {
  std::vector<std::string> absent;
  const auto contains = [](const std::string& key, const char* part) {
    return key.find(part) != std::string::npos;
  };
  for (const std::string& key : all) {
    // An H21 has fixed hands without touch sensors.
    const bool of_hands =
        contains(key, "WristYaw") || contains(key, "LHand") || contains(key, "RHand");
    // LEDs on the head came with V4.
    const bool of_head_leds = contains(key, "Head/Led");
    if ((of_hands && model.body_type == "H21") || (of_head_leds && model.version == "V3.3")) {
      absent.push_back(key);
    }
  }
  return absent;
}

void expectDocumentedKeys(const RobotModel& model, const DeviceKeys& views) {
  const fs::path table = fs::path(NAO_SOURCE_DIR) / ".." / "shared/data/almemory_device_keys.csv";
  if (!fs::exists(table)) GTEST_SKIP() << "needs " << table;
  const std::set<std::string> documented = documentedKeys(table);
  ASSERT_EQ(documented.size(), 415U);
  const std::set<std::string> stored = storedKeys(model);
  std::vector<std::string> missing;
  std::size_t measured = 0, kept = 0;
  for (const std::string& key : documented) {
    if (views.find(key)) {
      ++measured;
    } else if (stored.count(key) > 0) {
      ++kept;
    } else {
      missing.push_back(key);
    }
  }
  std::cout << model.name << ": of " << documented.size() << " documented keys " << measured
            << " are measured, " << kept << " stored, " << missing.size()
            << " are of devices it does not have; it has " << views.views().size() + stored.size()
            << " keys in all\n";
  EXPECT_THAT(missing, UnorderedElementsAreArray(absentFrom(model, documented)));
}

TEST_F(DeviceKeysTest, AnH21HasEveryDocumentedKeyOfItsDevices) {
  publish();
  expectDocumentedKeys(*model_, keys_);
}

TEST_F(DeviceKeysOfHumanHands, AnH25HasEveryDocumentedKey) {
  publish();
  expectDocumentedKeys(*model_, keys_);
}

}  // namespace
}  // namespace nao::memory
