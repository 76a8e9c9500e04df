#include "naoqi_api/wire/base_actions.h"

#include "core/check.h"
#include "naoqi_api/wire/metaobject.h"

namespace nao::wire {
namespace {

using rpc::CallError;
using rpc::Pending;
using Arguments = std::vector<Value>;

const rpc::Emitter& signalOf(const BaseContext& context, std::uint32_t uid) {
  const rpc::Emitter* emitter = uid == base_action::kTraceObject
                                    ? &context.service.monitor().traceObject()
                                    : context.service.findSignal(uid);
  if (!emitter) throw CallError("No such signal");
  return *emitter;
}

// Answered once whoever raises the signal knows, so that nothing raised from then on is lost.
Pending<Value> registerEvent(const BaseContext& context, const Arguments& arguments) {
  const auto uid = arguments[1].to<std::uint32_t>();
  const auto link = arguments[2].to<std::uint64_t>();
  const rpc::Emitter emitter = signalOf(context, uid);
  std::string wished;
  if (arguments.size() > 3) wished = arguments[3].to<std::string>();
  const Address signal{context.address.service, context.address.object, uid};
  const auto number = context.subscriptions.add(signal, link, emitter, std::move(wished));
  Pending<Value> registered;
  emitter.heard().whenDone(
      [registered, number, drop = context.subscriptions.dropper(number)](const auto& outcome) {
        if (outcome.value) return registered.resolve(number);
        drop();
        registered.fail(outcome.error.value_or("canceled"));
      });
  return registered;
}

Value unregisterEvent(const BaseContext& context, const Arguments& arguments) {
  const auto uid = arguments[1].to<std::uint32_t>();
  const auto link = arguments[2].to<std::uint64_t>();
  if (!context.subscriptions.remove({context.address.service, context.address.object, uid}, link)) {
    throw CallError("Unregister request failed for " + std::to_string(link) + " " +
                    std::to_string(context.address.service));
  }
  return {};
}

// A main object stays whatever a client says.
Value terminate(const BaseContext& context) {
  const Address& address = context.address;
  if (address.object == ObjectHost::kMain) return {};
  context.subscriptions.removeObject(address.service, address.object);
  context.objects.drop(address.service, address.object);
  return {};
}

const rpc::PropertyMember& propertyOf(const BaseContext& context, const Value& key) {
  if (const std::string* name = key.findText()) {
    const auto* property = context.service.findProperty(*name);
    if (!property) throw CallError("property \"" + *name + "\" was not found");
    return *property;
  }
  const auto* property = context.service.findProperty(key.to<std::uint32_t>());
  if (!property) throw CallError("cannot find property");
  return *property;
}

Pending<Value> setProperty(const BaseContext& context, const Arguments& arguments) {
  const auto& property = propertyOf(context, arguments[0]);
  const auto fitting =
      rpc::convert(arguments[1], Signature::of(property.signature), rpc::Bend::Declared);
  if (!fitting) {
    throw CallError("Failed to set object property '" + std::to_string(property.uid) +
                    "', reason: Conversion from " + arguments[1].bare().signature() + " to " +
                    property.signature + " failed");
  }
  Pending<Value> result;
  property.set(*fitting).whenDone([result](const auto& outcome) {
    if (outcome.value) return result.resolve();
    result.fail(outcome.error.value_or("canceled"));
  });
  return result;
}

Value propertyNames(const rpc::Service& service) {
  std::vector<std::string> names;
  for (const auto& [uid, property] : service.properties()) names.push_back(property.name);
  return rpc::toValue(names);
}

Value setFlag(bool& flag, const Value& value) {
  flag = value.to<bool>();
  return {};
}

// Those that end at once.
Value runAtOnce(const BaseContext& context, const Arguments& arguments) {
  rpc::Monitor& monitor = context.service.monitor();
  switch (context.address.action) {
    case base_action::kUnregisterEvent:
      return unregisterEvent(context, arguments);
    case base_action::kMetaObject:
      return metaObjectOf(context.service, context.documents_members);
    case base_action::kTerminate:
      return terminate(context);
    case base_action::kProperties:
      return propertyNames(context.service);
    case base_action::kIsStatsEnabled:
      return monitor.stats_enabled;
    case base_action::kEnableStats:
      return setFlag(monitor.stats_enabled, arguments[0]);
    case base_action::kStats:
      return monitor.statistics();
    case base_action::kClearStats:
      monitor.clear();
      return {};
    case base_action::kIsTraceEnabled:
      return monitor.trace_enabled;
    case base_action::kEnableTrace:
      return setFlag(monitor.trace_enabled, arguments[0]);
    default:
      NAO_CHECK(!"a base action");
      return {};
  }
}

}  // namespace

Pending<Value> runBaseAction(const BaseContext& context, const Arguments& arguments) {
  switch (context.address.action) {
    case base_action::kRegisterEvent:
    case base_action::kRegisterEventWithSignature:
      return registerEvent(context, arguments);
    case base_action::kProperty:
      return propertyOf(context, arguments[0]).get();
    case base_action::kSetProperty:
      return setProperty(context, arguments);
    default:
      return Pending<Value>::done(runAtOnce(context, arguments));
  }
}

}  // namespace nao::wire
