#include "naoqi_api/wire/client_object.h"

#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/client_offer.h"
#include "naoqi_api/wire/metaobject.h"

namespace nao::wire {

using rpc::Pending;
using rpc::Service;

ClientObject::ClientObject(const Address& address, std::shared_ptr<ClientCalls> calls)
    : address_(address), calls_(std::move(calls)) {}

std::shared_ptr<ClientObject> ClientObject::make(const Value& metaobject, const Address& address,
                                                 std::shared_ptr<ClientCalls> calls) {
  auto made = std::make_shared<ClientObject>(address, std::move(calls));
  made->learn(metaobject);
  return made;
}

void ClientObject::learn(const Value& metaobject) {
  if (!metaobject_.isVoid()) return;
  metaobject_ = metaobject;
  for (const auto& [uid, fields] : metaObjectEntries(metaobject, 0)) {
    const auto parameters = Signature::parse(*fields[3].findText());  // "m" takes any tuple
    if (!parameters) continue;
    methods_.push_back({uid, *fields[2].findText(), *parameters, *fields[1].findText()});
  }
}

ClientObject::~ClientObject() {
  if (address_.object <= 1) return;  // a service outlives our interest in it
  Bytes service;
  appendNumber(service, address_.service);
  calls_->post(member(base_action::kTerminate), std::move(service));
}

Pending<std::shared_ptr<Service>> ClientObject::offer() {
  Pending<std::shared_ptr<Service>> result;
  if (auto known = offered_.lock()) {
    result.resolve(std::move(known));
    return result;
  }
  if (!metaobject_.isVoid()) {
    auto made = offerOf(metaobject_, shared_from_this());
    offered_ = made;
    result.resolve(std::move(made));
    return result;
  }
  // Asked once for all who wait, so that their calls keep their order.
  if (asked_) return *asked_;
  asked_ = result;
  callMember(base_action::kMetaObject, Value::tuple({0U}), Signature::of("(I)"),
             metaObjectSignature())
      .whenDone([self = shared_from_this(), result](const rpc::Outcome<Value>& metaobject) {
        self->asked_.reset();
        if (!metaobject.value) return result.fail(metaobject.error.value_or("canceled"));
        self->learn(*metaobject.value);
        self->offer().whenDone([result](const auto& known) { result.resolve(*known.value); });
      });
  return result;
}

Pending<Value> ClientObject::call(std::string_view name, const std::vector<Value>& arguments) {
  if (!metaobject_.isVoid()) return callKnown(name, arguments);
  Pending<Value> result;
  offer().whenDone([self = shared_from_this(), result, method = std::string(name),
                    arguments](const rpc::Outcome<std::shared_ptr<Service>>& known) {
    if (!known.value) return result.fail(known.error.value_or("canceled"));
    const auto called = self->callKnown(method, arguments);
    called.whenDone([result](const rpc::Outcome<Value>& outcome) {
      if (outcome.value) return result.resolve(*outcome.value);
      result.fail(outcome.error.value_or("canceled"));
    });
  });
  return result;
}

Pending<Value> ClientObject::callKnown(std::string_view name, const std::vector<Value>& arguments) {
  for (const Method& method : methods_) {
    if (method.name != name) continue;
    const auto fitting = rpc::convert(Value::tuple(arguments), method.parameters, rpc::Bend::Loose);
    if (fitting) return callMember(method.uid, *fitting, method.parameters, method.returns);
  }
  return Pending<Value>::failed("the client's object has no " + std::string(name) + " that takes " +
                                Value::tuple(arguments).print());
}

}  // namespace nao::wire
