#include "naoqi_api/services/dcm.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

class DcmTest : public ServicesBench {
 protected:
  static Value point(double value, int time) {
    return Value::list({static_cast<float>(value), time});
  }
  int time(int offset) { return static_cast<int>(number(call("DCM", "getTime", {offset}))); }
  Value set(const std::string& name, const std::string& type, std::vector<Value> points) {
    return call("DCM", "set", {Value::list({name, type, Value::list(std::move(points))})});
  }
  double command(const std::string& joint) {
    return number(data("Device/SubDeviceList/" + joint + "/Position/Actuator/Value"));
  }
  void stiffen() {
    set("HeadYaw/Hardness/Actuator/Value", "ClearAll", {point(1, time(0))});
    set("Device/SubDeviceList/HeadPitch/Hardness/Actuator/Value", "Merge", {point(1, time(0))});
    run(0.05);
  }
};

TEST_F(DcmTest, MovesAJointAlongALine) {
  stiffen();
  const double before = command("HeadYaw");
  set("HeadYaw/Position/Actuator/Value", "ClearAll", {point(before + 0.4, time(1000))});
  run(0.5);
  EXPECT_NEAR(command("HeadYaw"), before + 0.2, 0.02);
  run(0.6);
  EXPECT_NEAR(command("HeadYaw"), before + 0.4, 1e-3);
}

TEST_F(DcmTest, AnAliasMovesItsActuatorsSeparatelyOrMixed) {
  stiffen();
  const Value made = call(
      "DCM", "createAlias",
      {Value::list(
          {"Head", Value::list({"HeadYaw/Position/Actuator/Value", "Nose/Position/Actuator/Value",
                                "HeadPitch/Position/Actuator/Value"})})});
  EXPECT_EQ((*(*made.findItems())[1].findItems())[1], Value(""));
  const int end = time(200);
  call("DCM", "setAlias",
       {Value::list(
           {"Head", "ClearAll", "time-separate", 0, Value::list({end}),
            Value::list({Value::list({0.3F}), Value::list({0.0F}), Value::list({0.1F})})})});
  run(0.3);
  EXPECT_NEAR(command("HeadYaw"), 0.3, 1e-3);
  EXPECT_NEAR(command("HeadPitch"), 0.1, 1e-3);
  const int later = time(200);
  call("DCM", "setAlias",
       {Value::list({"Head", "ClearAll", "time-mixed",
                     Value::list({Value::list({point(0, later)}), Value::list({}),
                                  Value::list({point(0.2, later)})})})});
  run(0.3);
  EXPECT_NEAR(command("HeadYaw"), 0, 1e-3);
  EXPECT_NEAR(command("HeadPitch"), 0.2, 1e-3);
}

TEST_F(DcmTest, LightsFollowTheirTimes) {
  set("ChestBoard/Led/Red/Actuator/Value", "ClearAll", {point(1, time(400))});
  double last = -1;
  for (int i = 0; i < 60; ++i) {
    cycle();
    for (const LedOrder& order : bench_.ports->leds.drain()) last = order.brightness;
    if (i == 20) {
      EXPECT_NEAR(last, 0.5, 0.1);
    }
  }
  EXPECT_NEAR(last, 1, 1e-6);
}

TEST_F(DcmTest, ALightOfTheFarthestPastIsLitAtOnce) {
  set("ChestBoard/Led/Red/Actuator/Value", "ClearAll", {point(1, std::numeric_limits<int>::min())});
  run(0.1);
  double last = -1;
  for (const LedOrder& order : bench_.ports->leds.drain()) last = order.brightness;
  EXPECT_NEAR(last, 1, 1e-6);
}

TEST_F(DcmTest, TheClockWrapsAtItsEnd) {
  const int now = time(0);
  EXPECT_EQ(time(std::numeric_limits<int>::max()), std::numeric_limits<int>::min() + now - 1);
}

TEST_F(DcmTest, SaysWhatItDoesNotUnderstand) {
  EXPECT_EQ(set("Nose/Position/Actuator/Value", "ClearAll", {point(1, 0)}),
            Value("! \tDCM::set\n\tunknown actuator or alias: Nose/Position/Actuator/Value"));
  EXPECT_EQ(set("HeadYaw/Position/Actuator/Value", "Clear", {point(1, 0)}),
            Value("! \tDCM::set\n\tunknown update type: Clear, expected ClearAll, Merge, "
                  "ClearAfter or ClearBefore"));
  const std::vector<Value> many(513, point(0, 1'000'000));
  EXPECT_EQ(set("HeadYaw/Position/Actuator/Value", "ClearAll", many).findText()->substr(0, 1), "!");
}

}  // namespace
}  // namespace nao::services
