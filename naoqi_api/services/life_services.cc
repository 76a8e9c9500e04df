#include "naoqi_api/services/life_services.h"

#include <array>
#include <map>
#include <string>
#include <utility>

#include "naoqi_api/services/al_autonomous_life.h"
#include "naoqi_api/services/make_module.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/settings.h"

namespace nao::services {
namespace {

using rpc::Argument;

// A state that one method starts, another stops and a third tells.
struct OnOff {
  const char* start;
  const char* stop;
  const char* is_on;
};

void addOnOff(rpc::Service& service, const OnOff& names) {
  const auto on = std::make_shared<bool>(false);
  addFunction(
      service, names.start, [on] { *on = true; }, "Is kept: there is nothing it could react to.");
  addFunction(
      service, names.stop, [on] { *on = false; }, "Is kept.");
  addFunction(
      service, names.is_on, [on] { return *on; }, "What was kept; off at first.");
}

void addEnabled(rpc::Service& service) {
  const auto on = std::make_shared<bool>(true);
  addFunction(
      service, "setEnabled", [on](bool enabled) { *on = enabled; }, "Is kept.",
      Argument{"enabled", "True: on, false: off."});
  addFunction(
      service, "isEnabled", [on] { return *on; }, "What was kept; on at first.");
}

ServicePointer finish(const ServicePointer& service, const SettingDefaults& defaults = {}) {
  addSettings(*service, documentedService(service->name()), defaults);
  service->allAnswering(rpc::Answer::Simplified);
  return service;
}

ServicePointer makeBasicAwareness(const ServiceContext& context) {
  auto service = makeModule("ALBasicAwareness", "Looks at people; there are none.");
  for (const char* event : {"ALBasicAwareness/HumanTracked", "ALBasicAwareness/HumanLost",
                            "ALBasicAwareness/StimulusDetected", "ALBasicAwareness/PeopleLeft"}) {
    context.store().declareEvent(event, "ALBasicAwareness");
  }
  addOnOff(*service, {"startAwareness", "stopAwareness", "isAwarenessRunning"});
  addFunction(
      *service, "engagePerson", [](std::int32_t) { return false; },
      "False: there is nobody to engage.", Argument{"person", "Its number."});
  const auto detected = std::make_shared<std::map<std::string, bool>>(
      std::map<std::string, bool>{{"Sound", true},
                                  {"Movement", true},
                                  {"People", true},
                                  {"Touch", true},
                                  {"NavigationMotion", true}});
  const Argument stimulus{"stimulus", "Sound, Movement, People, Touch or NavigationMotion."};
  const auto at = [detected](const std::string& name) -> bool& {
    const auto found = detected->find(name);
    if (found == detected->end()) throw rpc::CallError("unknown stimulus: " + name);
    return found->second;
  };
  addFunction(
      *service, "setStimulusDetectionEnabled",
      [at](const std::string& name, bool on) { at(name) = on; }, "Is kept.", stimulus,
      Argument{"enabled", "True: on, false: off."});
  addFunction(
      *service, "isStimulusDetectionEnabled",
      [at](const std::string& name) -> bool { return at(name); }, "What was kept; on at first.",
      stimulus);
  return finish(service, {{"EngagementMode", "Unengaged"}, {"TrackingMode", "Head"}});
}

ServicePointer makeAutonomousMoves(const ServiceContext& /*context*/) {
  auto service = makeModule("ALAutonomousMoves", "Small moves of a robot that waits; none here.");
  const auto strategies =
      std::make_shared<std::array<std::string, 2>>(std::array<std::string, 2>{"none", "none"});
  const Argument strategy{"strategy", "none or backToNeutral."};
  const auto keep = [](std::string& held, const std::string& name) {
    if (name != "none" && name != "backToNeutral") {
      throw rpc::CallError("unknown strategy: " + name + ", expected none or backToNeutral");
    }
    held = name;
  };
  addFunction(
      *service, "setBackgroundStrategy",
      [strategies, keep](const std::string& name) { keep((*strategies)[0], name); }, "Is kept.",
      strategy);
  addFunction(
      *service, "getBackgroundStrategy", [strategies] { return (*strategies)[0]; },
      "What was kept; none at first.");
  addFunction(
      *service, "setExpressiveListeningEnabled",
      [strategies](bool on) { (*strategies)[1] = on ? "on" : "off"; }, "Is kept.",
      Argument{"enabled", "True: on, false: off."});
  addFunction(
      *service, "getExpressiveListeningEnabled", [strategies] { return (*strategies)[1] == "on"; },
      "What was kept; off at first.");
  return finish(service);
}

ServicePointer makeEnabled(const std::string& name, const std::string& meaning) {
  auto service = makeModule(name, meaning);
  addEnabled(*service);
  return finish(service);
}

ServicePointer makeExpressiveListening() {
  auto service = makeModule("ALExpressiveListening", "Nods to who speaks; nobody does.");
  addOnOff(*service, {"startListening", "stopListening", "isListening"});
  addOnOff(*service, {"pauseListening", "resumeListening", "isPaused"});
  return finish(service);
}

}  // namespace

std::vector<ServicePointer> makeLifeServices(const ServiceContext& context) {
  return {makeAlAutonomousLife(context),
          makeBasicAwareness(context),
          makeAutonomousMoves(context),
          makeEnabled("ALAutonomousBlinking", "Blinks; not here."),
          makeEnabled("ALBackgroundMovement", "Small moves of a robot that waits; none here."),
          makeEnabled("ALListeningMovement", "Small moves of a robot that listens; none here."),
          makeEnabled("ALSpeakingMovement", "Moves of a robot that speaks; none here."),
          makeExpressiveListening()};
}

}  // namespace nao::services
