#include "naoqi_api/services/board_services.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "naoqi_api/services/chest_button.h"
#include "naoqi_api/services/extractor.h"
#include "naoqi_api/services/make_module.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/repeat.h"

namespace nao::services {
namespace {

using rpc::Answer;
using rpc::Argument;
using rpc::Value;

constexpr std::chrono::milliseconds kPeriod{100};  // free: how often a person would look

void addExtractor(rpc::Service& service, const ServiceContext& context,
                  const Extractor::Outputs& outputs) {
  const auto extractor = std::make_shared<Extractor>(context.store(), service.name(), outputs);
  extractor->declare(service);
  service.owning(extractor);
}

ServicePointer makeSensors(const ServiceContext& context) {
  auto service = makeModule("ALSensors", "Touch, bumpers and the feet's contact, as events.");
  addExtractor(
      *service, context,
      {{"FrontTactilTouched", "MiddleTactilTouched", "RearTactilTouched", "LeftBumperPressed",
        "RightBumperPressed", "ChestButtonPressed", "footContactChanged"},
       {"footContact", "leftFootContact", "rightFootContact"}});
  addFunction(
      *service, "run", [] {}, "Has no effect: its events are always raised.")
      .answering(Answer::Simplified);
  return service;
}

// ALSonar's rule: something is on a side when its receiver hears an echo from nearer than this.
constexpr double kNear = 0.5;  // [m] free: the documentation gives no figure

ServicePointer makeSonar(const ServiceContext& context) {
  auto service = makeModule("ALSonar", "What the sonar hears, as events.");
  const auto extractor = std::make_shared<Extractor>(
      context.store(), "ALSonar",
      Extractor::Outputs{{"SonarLeftDetected", "SonarRightDetected", "SonarLeftNothingDetected",
                          "SonarRightNothingDetected"},
                         {"Device/SubDeviceList/US/Left/Sensor/Value",
                          "Device/SubDeviceList/US/Right/Sensor/Value"}});
  extractor->declare(*service);
  const auto was_near = std::make_shared<std::array<int, 2>>();  // 0: not known, 1: no, 2: yes
  extractor->onWorking([was_near](bool) { was_near->fill(0); });
  RobotLink& link = context.link;
  repeat(context.later, kPeriod, extractor,
         [&link, &store = context.store(), was_near, raw = extractor.get()] {
           if (!raw->isWorking()) return;
           const auto sensors = link.sensors();
           for (std::size_t side = 0; side < 2; ++side) {
             const double distance = sensors->sonar[side][0];
             const int is_near = distance > 0 && distance < kNear ? 2 : 1;
             if ((*was_near)[side] == is_near) continue;
             (*was_near)[side] = is_near;
             const std::string event = side == 0 ? "SonarLeft" : "SonarRight";
             store.raiseEvent(event + (is_near == 2 ? "Detected" : "NothingDetected"),
                              static_cast<float>(distance));
           }
         });
  addFunction(
      *service, "getFilteredValues",
      [&link] {
        const auto sensors = link.sensors();
        return std::vector<float>{static_cast<float>(sensors->sonar[0][0]),
                                  static_cast<float>(sensors->sonar[1][0])};
      },
      "The nearest echo of the left and of the right receiver [m].");
  service->owning(extractor);
  return service;
}

struct TouchPlace {
  std::string name;
  std::function<bool(const SensorFrame&)> read;
};

std::vector<TouchPlace> touchPlaces(const RobotModel& model) {
  std::vector<TouchPlace> places;
  if (model.feet.size() != 2) return places;
  const std::array<const char*, 3> head = {"Front", "Middle", "Rear"};
  for (std::size_t i = 0; i < 3; ++i) {
    places.push_back({std::string("Head/Touch/") + head[i],
                      [i](const SensorFrame& frame) { return frame.touch.head[i]; }});
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const std::string letter = side == 0 ? "L" : "R";
    for (std::size_t i = 0; i < 2; ++i) {
      places.push_back(
          {letter + "Foot/Bumper/" + (i == 0 ? "Left" : "Right"),
           [side, i](const SensorFrame& frame) { return frame.feet[side].bumper[i]; }});
    }
    if (!model.findJoint("LHand")) continue;
    const std::array<const char*, 3> hand = {"Left", "Back", "Right"};
    for (std::size_t i = 0; i < 3; ++i) {
      places.push_back({letter + "Hand/Touch/" + hand[i],
                        [side, i](const SensorFrame& frame) { return frame.touch.hand[side][i]; }});
    }
  }
  places.push_back(
      {"ChestBoard/Button", [](const SensorFrame& frame) { return frame.touch.chest_button; }});
  return places;
}

ServicePointer makeTouch(const ServiceContext& context) {
  auto service = makeModule("ALTouch", "Where the robot is touched.");
  context.store().declareEvent("TouchChanged", "ALTouch");
  const auto places = std::make_shared<std::vector<TouchPlace>>(touchPlaces(context.link.model()));
  addFunction(
      *service, "getSensorList",
      [places] {
        std::vector<std::string> names;
        for (const TouchPlace& place : *places) names.push_back(place.name);
        return names;
      },
      "The places where touch is felt.");
  RobotLink& link = context.link;
  addFunction(
      *service, "getStatus",
      [places, &link] {
        const auto frame = link.sensors();
        std::vector<Value> list;
        for (const TouchPlace& place : *places) {
          list.push_back(Value::list({place.name, place.read(*frame), Value::list({})}));
        }
        return Value::list(std::move(list));
      },
      "[[place, whether it is touched, []], ...]");
  const auto touched = std::make_shared<std::map<std::string, bool>>();
  link.onTouch([places, touched, &store = context.store()](const auto& frame) {
    std::vector<Value> changed;
    for (const TouchPlace& place : *places) {
      const bool now = place.read(*frame);
      if (std::exchange((*touched)[place.name], now) == now) continue;
      changed.push_back(Value::list({place.name, now}));
    }
    if (!changed.empty()) store.raiseEvent("TouchChanged", Value::list(std::move(changed)));
  });
  service->owning(places);
  return service;
}

ServicePointer makeSentinel(const ServiceContext& /*context*/) {
  auto service = makeModule("ALSentinel", "What NAOqi 1.x does by itself; here it does nothing.");
  const Argument enable{"enable", "Is kept, without effect."};
  for (const char* name :
       {"enableDefaultActionSimpleClick", "enableDefaultActionDoubleClick",
        "enableDefaultActionTripleClick", "enablePowerMonitoring", "enableHeatMonitoring",
        "enableBatteryMeasure", "enableTemperatureMeasure", "enableRobotCameraState"}) {
    addFunction(
        *service, name, [](bool) {},
        "Has no effect: a press of the chest button is an event alone.", enable)
        .answering(Answer::Simplified);
  }
  return service;
}

ServicePointer makeBattery(const ServiceContext& context) {
  auto service = makeModule("ALBattery", "How full the battery is.");
  for (const char* event :
       {"BatteryChargeChanged", "BatteryLowDetected", "BatteryNearlyEmpty", "BatteryEmpty",
        "BatteryChargingFlagChanged", "BatteryDisChargingFlagChanged",
        "BatteryFullChargedFlagChanged", "BatteryPowerPluggedChanged", "BatteryNotDetected",
        "BatteryChargeCellVoltageMinChanged"}) {
    context.store().declareEvent(event, "ALBattery");
  }
  RobotLink& link = context.link;
  const auto percent = [&link] {
    return static_cast<std::int32_t>(std::lround(100 * link.sensors()->battery.charge));
  };
  addFunction(*service, "getBatteryCharge", percent, "0 to 100 [%].");
  const auto told = std::make_shared<std::int32_t>(-1);
  repeat(context.later, std::chrono::seconds(1), told,
         [percent, raw = told.get(), &store = context.store()] {
           const std::int32_t now = percent();
           if (*raw == now) return;
           if (*raw >= 0) {
             store.raiseEvent("BatteryChargeChanged", now);
             if (*raw >= 20 && now < 20) store.raiseEvent("BatteryLowDetected", true);
           }
           *raw = now;
         });
  service->owning(told);
  addFunction(
      *service, "enablePowerMonitoring", [](bool) {}, "Has no effect: events are always raised.",
      Argument{"enable", "Ignored."})
      .answering(Answer::Simplified);
  return service;
}

// [worst level, [device, ...]]: what holds back because it is hot.
Value diagnose(const RobotModel& model, const SensorFrame& frame) {
  int worst = 0;
  std::vector<Value> devices;
  for (std::size_t i = 0; i < model.jointCount(); ++i) {
    const int level = frame.overheating[i];
    if (level == 0) continue;
    worst = std::max(worst, level);
    devices.emplace_back(model.actuators[i].name);
  }
  if (worst == 0) return Value::list({});
  return Value::list({worst, Value::list(std::move(devices))});
}

ServicePointer makeBodyTemperature(const ServiceContext& context) {
  auto service = makeModule("ALBodyTemperature", "Which motors are hot.");
  for (const char* event : {"TemperatureStatusChanged", "TemperatureDiagnosisErrorChanged",
                            "HotDeviceDetected", "DeviceNoLongerHotDetected", "HotJointDetected"}) {
    context.store().declareEvent(event, "ALBodyTemperature");
  }
  RobotLink& link = context.link;
  const auto now = [&link] { return diagnose(link.model(), *link.sensors()); };
  addFunction(*service, "getTemperatureDiagnosis", now,
              "[worst level, [motor, ...]] of those that hold back, 1 to 3; empty if none does.");
  const auto notifies = std::make_shared<bool>(true);
  const auto told = std::make_shared<Value>(Value::list({}));
  repeat(context.later, std::chrono::seconds(1), told,
         [now, notifies, raw = told.get(), &store = context.store()] {
           const Value hot = now();
           if (hot == *raw) return;
           *raw = hot;
           if (*notifies) store.raiseEvent("TemperatureDiagnosisErrorChanged", hot);
         });
  service->owning(told);
  addFunction(
      *service, "setEnableNotifications", [notifies](bool on) { *notifies = on; },
      "Whether its events are raised.", Argument{"enable", "True at first."});
  addFunction(
      *service, "areNotificationsEnabled", [notifies] { return *notifies; },
      "Whether its events are raised.");
  return service;
}

}  // namespace

std::vector<ServicePointer> makeBoardServices(const ServiceContext& context) {
  return {makeSensors(context),
          makeSonar(context),
          makeTouch(context),
          makeModule("ALFsr", "The feet's contact: see footContact and footContactChanged."),
          makeChestButton(context),
          makeSentinel(context),
          makeBattery(context),
          makeBodyTemperature(context)};
}

}  // namespace nao::services
