#include "naoqi_api/services/al_motion_whole_body.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Answer;
using rpc::Argument;
using rpc::Value;

const Argument kIgnored{"value", "Ignored."};

bool isOn(const std::map<std::string, bool>& switches, const std::string& name) {
  const auto found = switches.find(name);
  return found != switches.end() && found->second;
}

}  // namespace

void AlMotionWholeBody::declareInner(rpc::Service& service) {
  addFunction(
      service, "_wbGetBalanceState", [this] { return asked_.balance; },
      "The feet that the centre of mass is kept over; nothing if it is not.")
      .at(211);
  addFunction(
      service, "_wbIsActive", [this] { return asked_.enabled; }, "Whether wbEnable is on.")
      .at(212);
  addFunction(
      service, "_wbDefaultConfiguration",
      [this] {
        wbFootState("Fixed", "Legs");
        wbEnableBalanceConstraint(true, "Legs");
      },
      "Both feet fixed, and the centre of mass over them.")
      .at(213);
  addFunction(
      service, "_wbGetFootState",
      [this](const std::string& foot) {
        const auto found = asked_.feet.find(foot);
        if (found == asked_.feet.end()) throw rpc::CallError("expected LLeg or RLeg, got " + foot);
        return found->second;
      },
      "How a foot stands: Fixed, Plane or Free.", Argument{"supportLeg", "LLeg or RLeg."})
      .at(214);
  declareEffectors(service);
  declareWeights(service);
}

void AlMotionWholeBody::declareEffectors(rpc::Service& service) {
  const Argument chain{"effectorName", "Head, LArm or RArm."};
  const Argument on{"isActive", "True: on, false: off."};
  const Argument mask{"axisMask", "Changes nothing: all that the effector can is led."};
  addFunction(
      service, "_wbEnableEffectorConstraint",
      [this](const std::string& name, bool active, int) { wbEnableEffectorControl(name, active); },
      "As wbEnableEffectorControl.", chain, on, mask)
      .at(220)
      .answering(Answer::Simplified);
  addFunction(
      service, "_wbGetEffectorConstraint",
      [this](const std::string& name) { return Value(isOn(asked_.controlled, name)); },
      "Whether an effector is led.", chain)
      .at(221);
  addFunction(
      service, "_wbAxisMaskEffector",
      [this](const std::string& name, bool active, int) {
        wbEnableEffectorOptimization(name, active);
      },
      "As wbEnableEffectorOptimization.", chain, on, mask)
      .at(222)
      .answering(Answer::Simplified);
  addFunction(
      service, "_wbGetEffectorOptimization",
      [this](const std::string& name) { return Value(isOn(asked_.optimized, name)); },
      "Whether an effector keeps its place over the feet.", chain)
      .at(224);
}

// The whole-body solver has weights of its own.
void AlMotionWholeBody::declareWeights(rpc::Service& service) {
  const char* const nothing = "Has no effect: the weights are the simulator's own.";
  const Argument joint{"jointName", "Ignored."};
  addFunction(
      service, "_wbSetReferencePosture", [](const std::string&) {}, nothing, kIgnored)
      .at(215)
      .answering(Answer::Simplified);
  addFunction(
      service, "_wbSetBalanceSecurityMargin", [](float, float) {}, nothing,
      Argument{"percentForwards", "Ignored."}, Argument{"percentSideways", "Ignored."})
      .at(216)
      .answering(Answer::Simplified);
  const auto number = [&](const char* name, std::uint32_t uid) {
    addFunction(
        service, name, [](const std::string&, float) {}, nothing, joint, kIgnored)
        .at(uid)
        .answering(Answer::Simplified);
  };
  number("_wbSetJointWeighting", 217);
  number("_wbSetJointStiffness", 218);
  addFunction(
      service, "_wbSetArticularLimitPreview", [](const std::string&, int) {}, nothing, joint,
      kIgnored)
      .at(219)
      .answering(Answer::Simplified);
  addFunction(
      service, "_wbEnableJointOptimization", [](const std::string&, bool) {}, nothing, joint,
      kIgnored)
      .at(223)
      .answering(Answer::Simplified);
  const auto list = [&](const char* name, std::uint32_t uid) {
    addFunction(
        service, name, [](const std::string&, const Value&) {}, nothing, joint, kIgnored)
        .at(uid)
        .answering(Answer::Simplified);
  };
  list("_wbSetEffectorWeight", 225);
  list("_wbSetEffectorStiffness", 226);
}

}  // namespace nao::services
