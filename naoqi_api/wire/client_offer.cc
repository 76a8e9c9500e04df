#include "naoqi_api/wire/client_offer.h"

#include <string>

#include "naoqi_api/wire/event_values.h"
#include "naoqi_api/wire/metaobject.h"

namespace nao::wire {
namespace {

using rpc::Caller;
using rpc::Emitter;
using rpc::Pending;
using rpc::Service;
using Weak = std::weak_ptr<ClientObject>;

constexpr std::size_t kFields[] = {7, 3, 3};  // of MetaMethod, MetaSignal, MetaProperty

bool isOfArguments(const std::string& signature) {
  const auto type = Signature::parse(signature);
  return type && carriesArguments(*type);
}

Pending<Value> gone() { return Pending<Value>::failed("the client has gone"); }

void addMethod(Service& offer, std::uint32_t uid, const std::vector<Value>& fields,
               const Weak& object) {
  rpc::Method method;
  method.uid = uid;
  method.return_signature = *fields[1].findText();
  method.name = *fields[2].findText();
  method.parameters_signature = *fields[3].findText();
  method.meaning = *fields[4].findText();
  const auto parameters = Signature::parse(method.parameters_signature);
  if (!parameters || !(parameters->is('(') || parameters->is('m'))) return;
  if (!Signature::parse(method.return_signature)) return;
  method.call = [object, uid, parameters = *parameters, returns = method.return_signature](
                    const Caller& /*caller*/, const std::vector<Value>& arguments) {
    const auto there = object.lock();
    if (!there) return gone();
    return there->callMember(uid, Value::tuple(parameters.text(), arguments), parameters, returns);
  };
  if (parameters->is('m')) {
    method.call = [object, uid, parameters = *parameters, returns = method.return_signature](
                      const Caller& /*caller*/, const std::vector<Value>& arguments) {
      const auto there = object.lock();
      return there ? there->callMember(uid, Value::tuple(arguments), parameters, returns) : gone();
    };
  }
  offer.insert(std::move(method));
}

// The client is asked for events as long as somebody here listens.
Emitter emitterOf(std::uint32_t uid, const std::string& signature, const Weak& object) {
  Emitter emitter(signature);
  const auto listening = std::make_shared<bool>(false);
  emitter.onListeners(
      [object, uid, signature, listening, weak = emitter.weak()](std::size_t listeners) {
        const auto there = object.lock();
        const auto own = weak();
        const bool wanted = listeners > 0;
        if (!there || !own || *listening == wanted) return;
        *listening = wanted;
        if (wanted) return own->setHeard(there->listen(uid, *own));
        there->stopListening(uid);
      });
  return emitter;
}

void addSignal(Service& offer, std::uint32_t uid, const std::vector<Value>& fields,
               const Weak& object) {
  const std::string& signature = *fields[2].findText();
  if (!isOfArguments(signature)) return;
  offer.insert(rpc::SignalMember{uid, *fields[1].findText(), emitterOf(uid, signature, object)});
}

void addProperty(Service& offer, std::uint32_t uid, const std::vector<Value>& fields,
                 const Weak& object) {
  const std::string& signature = *fields[2].findText();
  const std::string as_tuple = "(" + signature + ")";
  if (!isOfArguments(as_tuple)) return;
  rpc::PropertyMember property{
      uid, *fields[1].findText(), signature, emitterOf(uid, as_tuple, object), {}, {}};
  property.get = [object, uid] {
    const auto there = object.lock();
    if (!there) return gone();
    return there->callMember(base_action::kProperty, Value::tuple("(m)", {uid}),
                             Signature::of("(m)"), "m");
  };
  property.set = [object, uid](const Value& value) {
    const auto there = object.lock();
    if (!there) return Pending<void>::failed("the client has gone");
    Pending<void> result;
    there
        ->callMember(base_action::kSetProperty, Value::tuple("(mm)", {uid, value}),
                     Signature::of("(mm)"), "v")
        .whenDone([result](const rpc::Outcome<Value>& outcome) {
          if (outcome.value) return result.resolve();
          result.fail(outcome.error.value_or("canceled"));
        });
    return result;
  };
  offer.insert(std::move(property));
}

}  // namespace

std::map<std::uint32_t, std::vector<Value>> metaObjectEntries(const Value& metaobject,
                                                              std::size_t which) {
  std::map<std::uint32_t, std::vector<Value>> entries;
  const auto* maps = metaobject.findItems();
  const auto* map = maps && maps->size() > which ? (*maps)[which].find<Value::Map>() : nullptr;
  if (!map) return entries;
  for (const auto& [key, entry] : map->entries) {
    const auto* uid = key.find<std::uint32_t>();
    const auto* fields = entry.findItems();
    if (!uid || !fields || fields->size() != kFields[which]) continue;
    bool is_text = true;
    const std::size_t texts = which == 0 ? 5 : 3;
    for (std::size_t i = 1; i < texts; ++i) is_text = is_text && (*fields)[i].findText();
    if (is_text) entries[*uid] = *fields;
  }
  return entries;
}

std::shared_ptr<Service> offerOf(const Value& metaobject,
                                 const std::shared_ptr<ClientObject>& object) {
  auto offer = std::make_shared<Service>("", "");
  offer->owning(object);
  const auto properties = metaObjectEntries(metaobject, 2);
  for (const auto& [uid, fields] : metaObjectEntries(metaobject, 0)) {
    if (uid >= Service::kFirstUid) addMethod(*offer, uid, fields, object);
  }
  for (const auto& [uid, fields] : metaObjectEntries(metaobject, 1)) {
    const bool is_property = properties.count(uid) > 0;  // which is a signal, too
    if (uid >= Service::kFirstUid && !is_property) addSignal(*offer, uid, fields, object);
  }
  for (const auto& [uid, fields] : properties) {
    if (uid >= Service::kFirstUid) addProperty(*offer, uid, fields, object);
  }
  return offer;
}

}  // namespace nao::wire
