// The declaration of ALMemory: names, numbers and meanings as clients see them. The numbers are
// those of a real robot (the ALMemory metaobject in idl/v5 of lugu/qiloop), 113 to 153.

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/al_memory.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;

Argument key() { return {"key", "Its name."}; }
Argument unused() { return {"deprecatedParameter", "Has no effect."}; }
Argument event() { return {"name", "Name of the event."}; }
Argument value() { return {"value", "Its new value."}; }
Argument module() { return {"callbackModule", "Name of the module to call."}; }
Argument method() { return {"callbackMethod", "Its method, of (name, value, message)."}; }
Argument message() { return {"callbackMessage", "Passed on to the method."}; }

}  // namespace

rpc::Service AlMemory::describe() {
  rpc::Service service = rpc::alModule("ALMemory", "What the robot senses, does and is told.");
  describeReading(service);
  describeWriting(service);
  describeEvents(service);
  describeSubscribing(service);
  describeInner(service);
  return service;
}

// What NaoQi's own modules use among themselves.
void AlMemory::describeInner(rpc::Service& service) {
  using Self = AlMemory;
  addFunction(
      service, "_insertObject",
      [this](const std::string& name, const rpc::Value& data, int) { insertData(name, data); },
      "As insertData.", key(), value(), Argument{"bufferSize", "Changes nothing."})
      .at(147);
  for (const char* name : {"getIntPtr", "getFloatPtr"}) {
    service.method(name, this, &Self::getDataPtr, "Only inside the robot; refused.", key())
        .returning("X");
  }
  addFunction(
      service, "_perf", [] {}, "Has no effect: nothing is measured.")
      .at(144)
      .answering(rpc::Answer::Simplified);
  addFunction(
      service, "_subscribeOnDataSetTimePolicy", [](const std::string&, const std::string&, int) {},
      "Has no effect.", key(), module(),
      Argument{"nPolicy", "Ignored: every event is told at once."})
      .at(148)
      .answering(rpc::Answer::Simplified);
  addFunction(
      service, "_subscribeOnDataSetSynchronizeResponse",
      [](const std::string&, const std::string&, bool) {}, "Has no effect.", key(), module(),
      Argument{"bSynchronizeResponse", "Ignored: nothing waits for a callback's answer."})
      .at(149)
      .answering(rpc::Answer::Simplified);
}

void AlMemory::describeReading(rpc::Service& service) {
  using Self = AlMemory;
  addMethod(service, "getData", this, &Self::getData, "The value of a key.", key()).at(115);
  addMethod(service, "getData", this, &Self::getDataOld, "The value of a key.", key(), unused())
      .at(116);
  addMethod(service, "getTimestamp", this, &Self::getTimestamp,
            "[value, seconds, microseconds]: the value of a key and when it was written.", key())
      .at(118);
  addMethod(service, "getEventHistory", this, &Self::getEventHistory,
            "[[value, [seconds, microseconds]], ...]: what an event was raised with.", key())
      .at(119);
  addMethod(service, "getDataList", this, &Self::getDataList, "The keys that contain a text.",
            Argument{"filter", "The text."})
      .at(120);
  addMethod(service, "getDataListName", this, &Self::getDataListName, "All keys.").at(121);
  addMethod(service, "getDataOnChange", this, &Self::getDataOnChange,
            "Waits until a key has another value, and returns that.", key(), unused())
      .at(122);
  service.method("getDataPtr", this, &Self::getDataPtr, "Only inside the robot; refused.", key())
      .at(123)
      .returning("X");
  addMethod(service, "getEventList", this, &Self::getEventList, "All events.").at(124);
  addMethod(service, "getExtractorEvent", this, &Self::getExtractorEvent,
            "The events that a module declared as its own.",
            Argument{"extractorName", "The module."})
      .at(125);
  addMethod(service, "getListData", this, &Self::getListData,
            "The values of several keys, of one moment.",
            Argument{"keyList", "Names; one that is not there gives nothing in its place."})
      .at(126);
  addMethod(service, "getMicroEventList", this, &Self::getMicroEventList, "All micro-events.")
      .at(127);
  addMethod(service, "getType", this, &Self::getType, "Data, Event or MicroEvent.", key()).at(129);
  addMethod(service, "getDescriptionList", this, &Self::getDescriptionList,
            "[[key, data or event, description], ...]",
            Argument{"keylist", "Keys; none: all that have a description."})
      .at(151);
}

void AlMemory::describeWriting(rpc::Service& service) {
  using Self = AlMemory;
  const char* meaning = "Writes a key without telling anybody.";
  addMethod(service, "insertData", this, &Self::insertInt, meaning, key(), value()).at(130);
  addMethod(service, "insertData", this, &Self::insertFloat, meaning, key(), value()).at(131);
  addMethod(service, "insertData", this, &Self::insertText, meaning, key(), value()).at(132);
  addMethod(service, "insertData", this, &Self::insertData, meaning, key(), value()).at(133);
  addMethod(service, "insertListData", this, &Self::insertListData, "Writes several keys.",
            Argument{"list", "[[key, value], ...]"})
      .at(134);
  addMethod(service, "removeData", this, &Self::removeData, "Removes a key.", key()).at(137);
  addMethod(service, "setDescription", this, &Self::setDescription, "Says what a key means.", key(),
            Argument{"description", "In words."})
      .at(150);
}

void AlMemory::describeEvents(rpc::Service& service) {
  using Self = AlMemory;
  addMethod(service, "declareEvent", this, &Self::declareEvent, "Makes a key an event.", event())
      .at(113);
  addMethod(service, "declareEvent", this, &Self::declareExtractorEvent, "Makes a key an event.",
            event(), Argument{"extractorName", "The module that raises it."})
      .at(114);
  addMethod(service, "raiseEvent", this, &Self::raiseEvent,
            "Writes a key, tells its subscribers and keeps it in the history.", event(), value())
      .at(135);
  addMethod(service, "raiseMicroEvent", this, &Self::raiseMicroEvent,
            "Writes a key and tells its subscribers.", event(), value())
      .at(136);
  addMethod(service, "removeEvent", this, &Self::removeEvent,
            "Removes an event and its subscriptions.", event())
      .at(138);
  addMethod(service, "removeMicroEvent", this, &Self::removeEvent,
            "Removes a micro-event and its subscriptions.", event())
      .at(139);
}

void AlMemory::describeSubscribing(rpc::Service& service) {
  using Self = AlMemory;
  addMethod(service, "subscriber", this, &Self::subscriber,
            "An object whose signal `signal` tells of an event.", event())
      .at(117);
  addMethod(service, "getSubscribers", this, &Self::getSubscribers,
            "The modules that an event is told to.", event())
      .at(128);
  addMethod(service, "subscribeToEvent", this, &Self::subscribeToEvent,
            "Calls a module of the caller whenever the event is raised.", event(), module(),
            method())
      .at(140);
  addMethod(service, "subscribeToEvent", this, &Self::subscribeWithMessage,
            "Calls a module of the caller whenever the event is raised.", event(), module(),
            message(), method())
      .at(141);
  addMethod(service, "subscribeToMicroEvent", this, &Self::subscribeWithMessage,
            "Calls a module of the caller whenever the micro-event is raised.", event(), module(),
            message(), method())
      .at(142);
  addMethod(service, "unregisterModuleReference", this, &Self::unregisterModuleReference,
            "Ends all subscriptions of a module.", Argument{"moduleName", "Its name."})
      .at(143);
  addMethod(service, "unsubscribeToEvent", this, &Self::unsubscribeToEvent, "Ends a subscription.",
            event(), module())
      .at(145);
  addMethod(service, "unsubscribeToMicroEvent", this, &Self::unsubscribeToEvent,
            "Ends a subscription.", event(), module())
      .at(146);
  addMethod(service, "addMapping", this, &Self::addMapping,
            "Raises an event whenever a service of the robot emits a signal.",
            Argument{"service", "Name of the service."}, Argument{"signal", "Its signal."},
            Argument{"event", "What to raise."})
      .at(152);
  addMethod(service, "addMapping", this, &Self::addMappings,
            "Raises events whenever a service of the robot emits signals.",
            Argument{"service", "Name of the service."},
            Argument{"signalEvent", "What to raise for which signal."})
      .at(153);
}

}  // namespace nao::services
