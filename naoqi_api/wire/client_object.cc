#include "naoqi_api/wire/client_object.h"

#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/metaobject.h"

namespace nao::wire {
namespace {

rpc::Pending<Value> failed(std::string text) {
  rpc::Pending<Value> result;
  result.fail(std::move(text));
  return result;
}

}  // namespace

ClientObject::ClientObject(std::uint32_t service, std::uint32_t object,
                           std::shared_ptr<ClientCalls> calls)
    : service_(service), object_(object), calls_(std::move(calls)) {}

ClientObject::ClientObject(const Value& metaobject, std::uint32_t service, std::uint32_t object,
                           std::shared_ptr<ClientCalls> calls)
    : ClientObject(service, object, std::move(calls)) {
  learn(metaobject);
}

void ClientObject::learn(const Value& metaobject) {
  is_known_ = true;
  const auto* fields = metaobject.findItems();
  if (!fields || fields->empty()) return;
  const auto* methods = fields->front().find<Value::Map>();
  if (!methods) return;
  for (const auto& [uid, method] : methods->entries) {
    const auto& items = *method.findItems();  // MetaMethod: uid, returns, name, parameters, ...
    methods_[uid.to<std::uint32_t>()] = {*items[2].findText(), *items[3].findText(),
                                         *items[1].findText()};
  }
}

ClientObject::~ClientObject() {
  if (object_ <= 1) return;  // a service outlives our interest in it
  Bytes service;
  appendNumber(service, service_);
  calls_->post({service_, object_, base_action::kTerminate}, std::move(service));
}

rpc::Pending<Value> ClientObject::ask() {
  return calls_->call({service_, object_, base_action::kMetaObject}, Value::tuple({0U}),
                      Signature::of("(I)"), metaObjectSignature());
}

rpc::Pending<Value> ClientObject::call(std::string_view name, const std::vector<Value>& arguments) {
  if (is_known_) return callKnown(name, arguments);
  rpc::Pending<Value> result;
  ask().whenDone([self = shared_from_this(), result, method = std::string(name),
                  arguments](const rpc::Outcome<Value>& metaobject) {
    if (!metaobject.value) return result.fail(metaobject.error.value_or("canceled"));
    if (!self->is_known_) self->learn(*metaobject.value);
    self->callKnown(method, arguments).whenDone([result](const rpc::Outcome<Value>& outcome) {
      if (outcome.value) return result.resolve(*outcome.value);
      result.fail(outcome.error.value_or("canceled"));
    });
  });
  return result;
}

rpc::Pending<Value> ClientObject::callKnown(std::string_view name,
                                            const std::vector<Value>& arguments) {
  for (const auto& [uid, method] : methods_) {
    if (method.name != name) continue;
    const auto parameters = Signature::parse(method.parameters);  // "m" takes any tuple
    if (!parameters) continue;
    const auto fitting = rpc::convert(Value::tuple(arguments), *parameters, rpc::Bend::Loose);
    if (!fitting) continue;
    return calls_->call({service_, object_, uid}, *fitting, *parameters, method.returns);
  }
  return failed("the client's object has no " + std::string(name) + " that takes " +
                Value::tuple(arguments).print());
}

}  // namespace nao::wire
