// LoLA's frames: bytes out of what a robot senses, and the body's commands out of bytes.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <set>

#include "core/leds.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/wire/lola_actuators.h"
#include "naoqi_api/wire/lola_command.h"
#include "naoqi_api/wire/lola_leds.h"
#include "naoqi_api/wire/lola_sensors.h"
#include "naoqi_api/wire/msgpack_codec.h"
#include "tests/support/models.h"

namespace nao::wire {
namespace {

using rpc::Value;

Value decoded(const std::string& bytes) {
  MsgpackReader reader;
  reader.push(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return reader.next().value_or(Value());
}

float narrow(double number) { return static_cast<float>(number); }

Value at(const Value& map, const std::string& key) {
  const auto* entries = map.find<Value::Map>();
  if (!entries) return {};
  for (const auto& [name, value] : entries->entries) {
    if (*name.findText() == key) return value;
  }
  return {};
}

// Numbers of the wire are float32.
float at(const Value& map, const std::string& key, std::size_t i) {
  const Value list = at(map, key);
  return narrow(list.findItems()->at(i).findNumber().value());
}

// Every number is its own, so that one in another's place shows.
SensorFrame someFrame(const RobotModel& model) {
  SensorFrame frame;
  frame.angle = frame.current = frame.temperature = JointArray<double>(model.jointCount());
  frame.overheating = JointArray<std::uint8_t>(model.jointCount());
  for (std::size_t i = 0; i < model.jointCount(); ++i) {
    frame.angle[i] = 0.01 * static_cast<double>(i);
    frame.current[i] = 1 + static_cast<double>(i);
    frame.temperature[i] = 38 + static_cast<double>(i);
    frame.overheating[i] = i % 4;
  }
  frame.accelerometer = Vec3(0.1, 0.2, -9.81);
  frame.gyroscope = Vec3(0.3, 0.4, 0.5);
  frame.angle_x = 0.6;
  frame.angle_y = 0.7;
  for (std::size_t i = 0; i < 8; ++i) {
    frame.feet[i / 4].force[i % 4] = 9.80665 * static_cast<double>(i + 1);
  }
  frame.sonar[0][0] = 0.8;
  frame.sonar[1][0] = 0.9;
  frame.battery = {0.75, -0.5, 28, 31};
  return frame;
}

class LolaSensorsTest : public testing::Test {
 protected:
  std::string encode(const SensorFrame& frame, LolaBattery battery = LolaBattery::StatusFirst) {
    JointCommand command{frame.angle, JointArray<double>(model_->jointCount(), 0.25)};
    return LolaSensors(*model_, lolaIdentity(0), battery).encode(frame, command);
  }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h25_v60");
};

TEST_F(LolaSensorsTest, WritesWhatARobotSensesWhereClientsLook) {
  const SensorFrame frame = someFrame(*model_);
  const Value map = decoded(encode(frame));
  for (std::size_t i = 0; i < kLolaJoints.size(); ++i) {
    const Joint joint = model_->findJoint(kLolaJoints[i]).value();
    EXPECT_FLOAT_EQ(at(map, "Position", i), narrow(frame.angle[joint])) << kLolaJoints[i];
    EXPECT_FLOAT_EQ(at(map, "Current", i), narrow(frame.current[joint])) << kLolaJoints[i];
    EXPECT_FLOAT_EQ(at(map, "Temperature", i), narrow(frame.temperature[joint])) << kLolaJoints[i];
    EXPECT_EQ(at(map, "Status", i), frame.overheating[joint]) << kLolaJoints[i];
    EXPECT_EQ(at(map, "Stiffness", i), 0.25);
  }
  EXPECT_FLOAT_EQ(at(map, "Accelerometer", 2), -9.81F);
  EXPECT_FLOAT_EQ(at(map, "Gyroscope", 2), 0.5F);
  EXPECT_FLOAT_EQ(at(map, "Angles", 1), 0.7F);
  EXPECT_FLOAT_EQ(at(map, "Sonar", 1), 0.9F);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_FLOAT_EQ(at(map, "FSR", i), narrow(1.0 + static_cast<double>(i)));
}

TEST_F(LolaSensorsTest, TouchComesInLolasOrder) {
  const std::vector<std::function<void(SensorFrame&)>> touches{
      [](SensorFrame& f) { f.touch.chest_button = true; },
      [](SensorFrame& f) { f.touch.head[0] = true; },
      [](SensorFrame& f) { f.touch.head[1] = true; },
      [](SensorFrame& f) { f.touch.head[2] = true; },
      [](SensorFrame& f) { f.feet[0].bumper[0] = true; },
      [](SensorFrame& f) { f.feet[0].bumper[1] = true; },
      [](SensorFrame& f) { f.touch.hand[0][1] = true; },  // its back
      [](SensorFrame& f) { f.touch.hand[0][0] = true; },
      [](SensorFrame& f) { f.touch.hand[0][2] = true; },
      [](SensorFrame& f) { f.feet[1].bumper[0] = true; },
      [](SensorFrame& f) { f.feet[1].bumper[1] = true; },
      [](SensorFrame& f) { f.touch.hand[1][1] = true; },
      [](SensorFrame& f) { f.touch.hand[1][0] = true; },
      [](SensorFrame& f) { f.touch.hand[1][2] = true; }};
  for (std::size_t touched = 0; touched < touches.size(); ++touched) {
    SensorFrame frame = someFrame(*model_);
    touches[touched](frame);
    const Value map = decoded(encode(frame));
    for (std::size_t i = 0; i < touches.size(); ++i) {
      EXPECT_EQ(at(map, "Touch", i), i == touched ? 1 : 0) << i << " of " << touched;
    }
  }
}

TEST_F(LolaSensorsTest, TheBatteryIsReadInEitherOrder) {
  const Value usual = decoded(encode(someFrame(*model_)));
  EXPECT_FLOAT_EQ(at(usual, "Battery", 0), 0.75F);
  EXPECT_EQ(at(usual, "Battery", 1), -32708);
  EXPECT_EQ(at(usual, "Battery", 2), -0.5);
  EXPECT_EQ(at(usual, "Battery", 3), 31);
  const Value other = decoded(encode(someFrame(*model_), LolaBattery::CurrentFirst));
  EXPECT_EQ(at(other, "Battery", 1), -0.5);
  EXPECT_EQ(at(other, "Battery", 2), -32708);
}

TEST_F(LolaSensorsTest, ItsSizeAndLayoutNeverChange) {
  SensorFrame still;
  still.angle = still.current = still.temperature = JointArray<double>(model_->jointCount());
  still.overheating = JointArray<std::uint8_t>(model_->jointCount());
  const std::string nothing = encode(still);
  const std::string something = encode(someFrame(*model_));
  ASSERT_EQ(nothing.size(), 896U);
  ASSERT_EQ(something.size(), 896U);
  // Every number is marked as float32 in the same place of both, and so are the keys.
  EXPECT_EQ(nothing.substr(0, 14), something.substr(0, 14));
  for (std::size_t i = 0; i + 4 < nothing.size(); ++i) {
    const std::string key = nothing.substr(i, 5);
    if (std::isalpha(key[0]) != 0 && std::isalpha(key[4]) != 0 && key.find('\xca') == key.npos) {
      EXPECT_EQ(key, something.substr(i, 5)) << i;
    }
  }
}

TEST_F(LolaSensorsTest, RobotsWithFewerJointsSendTheSameLayout) {
  model_ = test::robot("nao_h21_v33");
  const Value map = decoded(encode(someFrame(*model_)));
  EXPECT_EQ(at(map, "Position", 6), 0);  // LWristYaw
  EXPECT_EQ(at(map, "Position").findItems()->size(), 25U);
}

TEST_F(LolaSensorsTest, EveryRobotHasIdsOfTwentyLetters) {
  std::set<std::string> ids;
  for (const std::size_t robot : {0, 1, 21}) {
    for (const std::string& id : {lolaIdentity(robot).body, lolaIdentity(robot).head}) {
      EXPECT_EQ(id.size(), 20U);
      ids.insert(id);
    }
  }
  EXPECT_EQ(ids.size(), 6U);
  const Value config = at(decoded(encode(someFrame(*model_))), "RobotConfig");
  EXPECT_EQ(config.print(), "[\"" + lolaIdentity(0).body + "\", \"6.0.0\", \"" +
                                lolaIdentity(0).head + "\", \"6.0.0\"]");
}

// The order of keys and the kinds of numbers as in a frame that the Nao Devils' program accepts.
TEST_F(LolaSensorsTest, MarksOfAFrameThatClientsAcceptAreInTheSamePlaces) {
  std::ifstream file(NAO_SOURCE_DIR "/../shared/captures/lola_sensor_frame.bin", std::ios::binary);
  if (!file) GTEST_SKIP() << "../shared/captures is not there";
  const std::string captured{std::istreambuf_iterator<char>(file), {}};
  const std::string ours = encode(someFrame(*model_));
  ASSERT_EQ(captured.size(), ours.size());
  const auto marksOf = [](const Value& value) {
    std::string kinds;
    for (const auto& [key, list] : value.find<Value::Map>()->entries) {
      kinds += *key.findText() + ":";
      for (const Value& item : *list.findItems()) kinds += item.signature();
    }
    return kinds;
  };
  EXPECT_EQ(marksOf(decoded(ours)), marksOf(decoded(captured)));
}

Value numbers(std::size_t count, double value) {
  return Value::list(std::vector<Value>(count, Value(value)));
}

Value map(std::vector<std::pair<Value, Value>> entries) {
  return Value(Value::Map{"s", "m", std::move(entries)});
}

std::string refusal(const Value& frame) {
  try {
    readLolaActuators(frame);
  } catch (const rpc::CallError& error) {
    return error.what();
  }
  return "none";
}

TEST(LolaActuators, TakeAnySubsetOrderAndWidth) {
  std::vector<Value> mixed{Value(1.5F), Value(-0.5), Value(0)};  // float32, float64, int
  mixed.resize(25, Value(0.25F));
  const auto read = readLolaActuators(
      map({{"Sonar", Value::list({true, false})}, {"Position", Value::list(std::move(mixed))}}));
  ASSERT_EQ(read.position.size(), 25U);
  EXPECT_EQ(read.position[0], 1.5);
  EXPECT_EQ(read.position[1], -0.5);
  EXPECT_EQ(read.position[2], 0);
  EXPECT_TRUE(read.stiffness.empty());
  EXPECT_TRUE(readLolaActuators(map({})).leds.empty());
}

TEST(LolaActuators, EveryLightOfEveryRobotHasOnePlace) {
  std::set<std::string> named;
  for (const LolaLeds& leds : lolaLeds()) named.insert(leds.names.begin(), leds.names.end());
  const auto all = ledNames(*test::robot("nao_h25_v60"));
  EXPECT_EQ(named, std::set<std::string>(all.begin(), all.end()));
}

TEST(LolaActuators, LightsAreWhereOthersReadThem) {
  const auto nameAt = [](const std::string& key, std::size_t i) {
    for (const LolaLeds& leds : lolaLeds()) {
      if (leds.key == key) return leds.names.at(i);
    }
    return std::string();
  };
  EXPECT_EQ(nameAt("LEye", 0), "Face/Led/Red/Left/45Deg");
  EXPECT_EQ(nameAt("LEye", 2), "Face/Led/Red/Left/315Deg");
  EXPECT_EQ(nameAt("LEye", 7), "Face/Led/Red/Left/90Deg");
  EXPECT_EQ(nameAt("REye", 8), "Face/Led/Green/Right/0Deg");
  EXPECT_EQ(nameAt("LEar", 9), "Ears/Led/Left/324Deg");
  EXPECT_EQ(nameAt("REar", 0), "Ears/Led/Right/324Deg");
  EXPECT_EQ(nameAt("Skull", 0), "Head/Led/Front/Left/1");
  EXPECT_EQ(nameAt("Skull", 6), "Head/Led/Rear/Right/2");
  EXPECT_EQ(nameAt("Chest", 2), "ChestBoard/Led/Blue");
}

TEST(LolaActuators, SayWhatIsWrongWithABadFrame) {
  EXPECT_EQ(refusal(Value(7)), "expected a map of lists, found 7");
  EXPECT_EQ(refusal(map({{"Position", "stand"}})),
            "Position: expected a list of 25 numbers, found \"stand\"");
  EXPECT_EQ(refusal(map({{"Position", numbers(24, 0)}})),
            "Position: expected a list of 25 numbers, found 24 items");
  EXPECT_EQ(refusal(map({{"Stiffness", numbers(25, std::nan(""))}})),
            "Stiffness[0]: expected a number, found nan");
  EXPECT_NE(refusal(map({{"Position", numbers(25, HUGE_VAL)}})), "none");
  EXPECT_NE(refusal(map({{"Position", Value::list(std::vector<Value>(25, Value(true)))}})), "none");
  EXPECT_NE(refusal(map({{"LEye", numbers(23, 1)}})), "none");
  EXPECT_NE(refusal(map({{"Sonar", Value::list({"on", "off"})}})), "none");
  EXPECT_NE(refusal(map({{Value(3), numbers(25, 0)}})), "none");
}

class LolaCommandTest : public testing::Test {
 protected:
  static LolaActuators position(double value) {
    LolaActuators frame;
    frame.position.assign(25, 0);
    frame.position[0] = value;  // HeadYaw
    return frame;
  }
  double headYaw() const { return command_.body()->angle[model_->findJoint("HeadYaw").value()]; }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h25_v60");
  LolaCommand command_{model_};
};

TEST_F(LolaCommandTest, WhatAFrameDoesNotMentionStays) {
  EXPECT_FALSE(command_.body().has_value());
  command_.take(position(0.5));
  LolaActuators stiff;
  stiff.stiffness.assign(25, 0.75);
  command_.take(stiff);
  EXPECT_EQ(headYaw(), 0.5);
  EXPECT_EQ(command_.body()->stiffness[0], 0.75);
}

TEST_F(LolaCommandTest, LightsAloneAskNothingOfTheJoints) {
  LolaActuators light;
  light.leds = {{"ChestBoard/Led/Red", 1.0}};
  command_.take(light);
  EXPECT_FALSE(command_.body().has_value());
  EXPECT_EQ(command_.takeLeds().size(), 1U);
  command_.take(light);  // as it is already
  EXPECT_TRUE(command_.takeLeds().empty());
}

TEST_F(LolaCommandTest, AnglesALittleOutOfRangeAreHeldAtItsEnd) {
  const double upper = model_->actuators[0].upper;
  ASSERT_EQ(model_->actuators[0].name, "HeadYaw");
  EXPECT_NE(command_.take(position(upper + 0.3)), "");
  EXPECT_EQ(headYaw(), upper);
}

TEST_F(LolaCommandTest, LimpJointsMayBeAskedForAnything) {
  command_.take(position(0.5));
  EXPECT_NE(command_.take(position(3e29)), "");  // as ros-sports' client does, of unset memory
  EXPECT_EQ(headYaw(), 0.5);
}

TEST_F(LolaCommandTest, NothingOfAFrameFarOutOfRangeIsTaken) {
  command_.take(position(0.5));
  LolaActuators wild = position(45);  // degrees
  wild.stiffness.assign(25, 1);
  wild.leds = {{"ChestBoard/Led/Red", 1.0}};
  EXPECT_THROW(command_.take(wild), rpc::CallError);
  EXPECT_EQ(headYaw(), 0.5);
  EXPECT_EQ(command_.body()->stiffness[0], 0);
  EXPECT_TRUE(command_.takeLeds().empty());
}

TEST_F(LolaCommandTest, StiffnessIsOffBelowZeroAndOneAtMost) {
  LolaActuators frame;
  frame.stiffness.assign(25, -1);
  EXPECT_EQ(command_.take(frame), "");
  EXPECT_EQ(command_.body()->stiffness[0], -1);
  frame.stiffness.assign(25, 3);
  EXPECT_NE(command_.take(frame), "");
  EXPECT_EQ(command_.body()->stiffness[0], 1);
}

TEST_F(LolaCommandTest, JointsARobotHasNotAreIgnored) {
  LolaCommand h21(test::robot("nao_h21_v33"));
  LolaActuators frame = position(0.5);
  frame.position[6] = 9;  // a wrist
  EXPECT_NO_THROW(h21.take(frame));
}

TEST_F(LolaCommandTest, TellsOfAKeyThatIsNotLolas) {
  LolaActuators frame = position(0);
  frame.unknown = {"Tail"};
  EXPECT_EQ(command_.take(frame), "'Tail' is no key of LoLA's: ignored");
}

// Every command that comes of whatever bytes is one that the body can be given.
TEST_F(LolaCommandTest, NoBytesMakeAnUnsafeCommand) {
  const Value whole = map({{"Position", numbers(25, 0.1)},
                           {"Stiffness", numbers(25, 0.5)},
                           {"Sonar", Value::list({true, true})}});
  rpc::Bytes bytes;
  packValue(bytes, whole, {});
  std::mt19937 random(7);
  int taken = 0;
  for (int k = 0; k < 20000; ++k) {
    rpc::Bytes broken = bytes;
    for (int change = 0; change < 3; ++change) {
      broken[random() % broken.size()] = static_cast<std::uint8_t>(random());
    }
    MsgpackReader reader;
    reader.push(broken.data(), broken.size());
    const auto frame = reader.next();
    try {
      if (frame) command_.take(readLolaActuators(*frame));
      ++taken;
    } catch (const rpc::CallError&) {
      continue;
    }
    if (!command_.body()) continue;
    for (std::size_t i = 0; i < model_->jointCount(); ++i) {
      const double angle = command_.body()->angle[i];
      ASSERT_TRUE(std::isnan(angle) ||
                  (angle >= model_->actuators[i].lower && angle <= model_->actuators[i].upper));
      ASSERT_LE(std::abs(command_.body()->stiffness[i]), 1);
    }
  }
  EXPECT_GT(taken, 1000);  // it is not only refused
}

}  // namespace
}  // namespace nao::wire
