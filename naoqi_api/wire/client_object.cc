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

ClientObject::ClientObject(const Value& metaobject, std::uint32_t service, std::uint32_t object,
                           std::shared_ptr<ClientCalls> calls)
    : service_(service), object_(object), calls_(std::move(calls)) {
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

rpc::Pending<Value> ClientObject::call(std::string_view name, const std::vector<Value>& arguments) {
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
