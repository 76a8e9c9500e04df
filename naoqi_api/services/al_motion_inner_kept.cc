// Those of ALMotion's methods with an underscore that keep what they are told.

#include <map>

#include "naoqi_api/services/al_motion_inner.h"
#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Answer;
using rpc::Argument;
using rpc::Value;

}  // namespace

void AlMotionInner::declareKept(rpc::Service& service) {
  const auto accept = [&service](const char* name, std::uint32_t uid) {
    addFunction(
        service, name, [](bool) {}, "Has no effect.", Argument{"pEnable", "Ignored."})
        .at(uid)
        .answering(Answer::Simplified);
  };
  accept("_setAnimationModeEnabled", 303);
  accept("_setSimulationModeEnabled", 320);
  accept("_setBreathStaticLegs", 283);
  addFunction(
      service, "_enablePhysicalInteractionForChain", [](const std::string&, bool) {},
      "Has no effect.", Argument{"pChain", "Ignored."}, Argument{"pEnabled", "Ignored."})
      .at(230)
      .answering(Answer::Simplified);
  addFunction(
      service, "_saveWholeBodyDump", [] {}, "Has no effect: nothing is written.")
      .at(316)
      .answering(Answer::Simplified);
  service
      .method("_getMotionToDCM", std::function<Value()>([]() -> Value {
                throw rpc::CallError("ALMotion::_getMotionToDCM Cannot be called remotely");
              }),
              "Only inside the robot; refused.")
      .at(321)
      .returning("X");
  addFunction(
      service, "_naoqiIsReadyCallback", [] {}, "Has no effect: nothing waits for it.")
      .at(268)
      .answering(Answer::Simplified);
  addFunction(
      service, "_preferenceUpdatedCallback",
      [](const std::string&, const Value&, const std::string&) {}, "Has no effect.",
      Argument{"event", "Ignored."}, Argument{"value", "Ignored."}, Argument{"message", "Ignored."})
      .at(269)
      .answering(Answer::Simplified);
  const auto unfeasible = std::make_shared<int>(0);
  addFunction(
      service, "_resetCartesianUnfeasible", [unfeasible] { *unfeasible = 0; }, "Counts from 0.")
      .at(313);
  addFunction(
      service, "_setCartesianUnfeasible", [unfeasible] { ++*unfeasible; }, "Counts one more.")
      .at(314);
  addFunction(
      service, "_getCartesianUnfeasible", [unfeasible] { return *unfeasible; },
      "What _setCartesianUnfeasible has counted; goals out of reach are approached and not "
      "counted.")
      .at(315)
      .answering(Answer::Simplified);
  declareBlindZones(service);
}

// Where a Pepper's lasers do not see; nothing here asks for it.
void AlMotionInner::declareBlindZones(rpc::Service& service) {
  struct Zones {
    std::map<std::string, float> offsets;
    float distance = 0;
  };
  constexpr std::size_t kMost = 64;
  const auto zones = std::make_shared<Zones>();
  const Argument name{"Name", "Name of a zone."};
  addFunction(
      service, "_setBlindZoneOffset",
      [zones](const std::string& zone, float offset) {
        if (zones->offsets.size() < kMost) zones->offsets[zone] = offset;
      },
      "Is kept.", name, Argument{"Offset", "[m]"})
      .at(323)
      .answering(Answer::Simplified);
  addFunction(
      service, "_getBlindZoneOffset",
      [zones](const std::string& zone) {
        const auto found = zones->offsets.find(zone);
        return found == zones->offsets.end() ? 0.0F : found->second;
      },
      "What was kept; 0 before.", name)
      .at(322)
      .answering(Answer::Simplified);
  addFunction(
      service, "_setBlindZoneDistance", [zones](float distance) { zones->distance = distance; },
      "Is kept.", Argument{"Distance", "[m]"})
      .at(325)
      .answering(Answer::Simplified);
  addFunction(
      service, "_getBlindZoneDistance", [zones] { return zones->distance; },
      "What was kept; 0 before.")
      .at(324)
      .answering(Answer::Simplified);
  for (const auto& [method, uid] :
       {std::pair("_getBlindZones", 326U), std::pair("_getBlindZonesWithNames", 327U)}) {
    addFunction(
        service, method, [] { return Value::list({}); }, "None: a Nao has no lasers.")
        .at(uid);
  }
}

}  // namespace nao::services
