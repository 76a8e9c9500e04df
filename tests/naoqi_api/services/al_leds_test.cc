#include "naoqi_api/services/al_leds.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "naoqi_api/services/led_names.h"
#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

class AlLedsTest : public ServicesBench {
 protected:
  // What the robot was asked to show, as its lights' boards would take it over.
  void cycleWithLights() {
    cycle();
    const auto names = ledNames(*bench_.model);
    for (const LedOrder& order : bench_.ports->leds.drain()) {
      for (const std::size_t light : findLeds(names, order.leds)) {
        bench_.frame.leds[light] = order.brightness;
      }
    }
  }
  void runLights(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 100 + 0.5); ++i) cycleWithLights();
  }
  double shown(const std::string& light) {
    return number(data("Device/SubDeviceList/" + light + "/Actuator/Value"));
  }
};

TEST_F(AlLedsTest, FadesInTimeAndEndsThen) {
  const auto fading = start("ALLeds", "fadeRGB", {"FaceLeds", 0xFF8000, 1.0F});
  runLights(0.5);
  EXPECT_FALSE(fading.isDone());
  EXPECT_NEAR(shown("Face/Led/Red/Left/0Deg"), 0.5, 0.04);
  EXPECT_NEAR(shown("Face/Led/Green/Right/90Deg"), 0.25, 0.02);
  EXPECT_EQ(shown("Face/Led/Blue/Left/0Deg"), 0);
  runLights(0.6);
  EXPECT_TRUE(fading.isDone());
  EXPECT_NEAR(shown("Face/Led/Red/Left/0Deg"), 1, 1e-6);
}

TEST_F(AlLedsTest, ALaterFadeHasTheLight) {
  start("ALLeds", "fade", {"ChestLeds", 1.0F, 1.0F});
  runLights(0.5);
  start("ALLeds", "off", {"ChestLeds"});
  runLights(1);
  EXPECT_EQ(shown("ChestBoard/Led/Red"), 0);
}

TEST_F(AlLedsTest, KnowsGroupsSectorsColoursAndDevices) {
  const auto names = ledNames(*bench_.model);
  EXPECT_EQ(findLedsNamed(names, "FaceLeds").size(), 48U);
  EXPECT_EQ(findLedsNamed(names, "FaceLed0").size(), 6U);
  EXPECT_EQ(findLedsNamed(names, "LeftFaceLed8").size(), 3U);
  EXPECT_EQ(findLedsNamed(names, "RightFaceLedsGreen").size(), 8U);
  EXPECT_EQ(findLedsNamed(names, "LeftEarLed10").size(), 1U);
  EXPECT_EQ(findLedsNamed(names, "Device/SubDeviceList/LFoot/Led/Red/Actuator/Value").size(), 1U);
  EXPECT_TRUE(findLedsNamed(names, "FaceLed9").empty());
  EXPECT_EQ(call("ALLeds", "on", {"NoLeds"}),
            Value("! \tALLeds::on\n\tunknown light or group: NoLeds"));
}

TEST_F(AlLedsTest, AGroupThatAClientMadeIsAGroup) {
  call("ALLeds", "createGroup", {"mine", Value::list({"ChestLeds", "LeftEarLed1"})});
  EXPECT_EQ(call("ALLeds", "listGroup", {"mine"}).findItems()->size(), 4U);
  start("ALLeds", "setIntensity", {"mine", 0.5F});
  runLights(0.1);
  EXPECT_NEAR(shown("Ears/Led/Left/0Deg"), 0.5, 1e-6);
}

TEST_F(AlLedsTest, ShowsTakeTheirTime) {
  const auto show = start("ALLeds", "rotateEyes", {0x0000FF, 0.8F, 1.6F});
  runLights(1.5);
  EXPECT_FALSE(show.isDone());
  runLights(0.3);
  EXPECT_TRUE(show.isDone());
}

TEST_F(AlLedsTest, AShowWithoutEndIsALongOne) {
  const auto rasta = start("ALLeds", "rasta", {1e30F});
  const auto turn = start("ALLeds", "rotateEyes", {0x0000FF, 1e30F, 1e30F});
  runLights(1);
  EXPECT_FALSE(rasta.isDone());
  EXPECT_FALSE(turn.isDone());
}

TEST_F(AlLedsTest, AShowOfCountlessStepsEnds) {
  const auto show = start("ALLeds", "rotateEyes", {0x0000FF, 1e-40F, 1e30F});
  runLights(1);
  EXPECT_TRUE(show.isDone());
}

TEST_F(AlLedsTest, AShowOfNoNumberIsAnError) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(*call("ALLeds", "rasta", {none}).findText(),
              testing::HasSubstr("expected a finite number"));
}

}  // namespace
}  // namespace nao::services
