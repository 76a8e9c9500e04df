#include "naoqi_api/wire/qijs_connection.h"

#include <algorithm>

#include "naoqi_api/call_error.h"
#include "naoqi_api/wire/metaobject.h"

namespace nao::wire {
namespace {

using rpc::CallError;
using rpc::Service;

constexpr char kDirectory[] = "ServiceDirectory";

const Value* field(const Value& object, const std::string& name) {
  const auto* map = object.find<Value::Map>();
  if (!map) return nullptr;
  for (const auto& [key, value] : map->entries) {
    if (*key.findText() == name) return &value;
  }
  return nullptr;
}

std::string textOf(const Value* value) {
  const std::string* text = value ? value->findText() : nullptr;
  return text ? *text : std::string();
}

// Structs become JSON objects with the names that their annotation gives, maps of numbers too.
void writeFields(JsonWriter& writer, const Value& fields, const std::vector<const char*>& names) {
  writer.writeRaw("{");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) writer.writeRaw(",");
    writer.writeText(names[i]);
    writer.writeRaw(":");
    writer.write(fields.findItems()->at(i));
  }
  writer.writeRaw("}");
}

void writeMembers(JsonWriter& writer, const Value& members, const std::vector<const char*>& names) {
  writer.writeRaw("{");
  bool first = true;
  for (const auto& [uid, fields] : members.find<Value::Map>()->entries) {
    if (!std::exchange(first, false)) writer.writeRaw(",");
    writer.writeText(uid.print());
    writer.writeRaw(":");
    writeFields(writer, fields, names);
  }
  writer.writeRaw("}");
}

void writeMetaObject(JsonWriter& writer, const Service& service) {
  const Value metaobject = metaObjectOf(service, true);
  const auto& parts = *metaobject.findItems();
  writer.writeRaw("{\"methods\":");
  writeMembers(writer, parts[0],
               {"uid", "returnSignature", "name", "parametersSignature", "description",
                "parameters", "returnDescription"});
  writer.writeRaw(",\"signals\":");
  writeMembers(writer, parts[1], {"uid", "name", "signature"});
  writer.writeRaw(",\"properties\":");
  writeMembers(writer, parts[2], {"uid", "name", "signature"});
  writer.writeRaw(",\"description\":");
  writer.write(parts[3]);
  writer.writeRaw("}");
}

}  // namespace

QijsConnection::QijsConnection(rpc::ServiceHub& hub, const std::string& endpoint, Send send,
                               std::function<void()> broken)
    : send_(std::move(send)),
      broken_(std::move(broken)),
      calls_(hub, endpoint),
      json_of_([this](const ObjectRef& object) { return jsonOf(object); }),
      alive_(std::make_shared<QijsConnection*>(this)) {
  send_("1::");
}

QijsConnection::~QijsConnection() {
  alive_.reset();
  send_ = {};
}

bool QijsConnection::receive(std::string_view text) {
  if (text.empty() || text.size() > kMaxText) return false;
  switch (text.front()) {
    case '1':
      return true;
    case '2':
      send_("2::");
      return true;
    case '5':
      break;
    default:
      return false;
  }
  std::size_t start = 0;  // of the data: after the third colon
  for (int colons = 0; colons < 3; ++colons) {
    start = text.find(':', start);
    if (start == text.npos) return false;
    ++start;
  }
  return takeEvent(text.substr(start));
}

bool QijsConnection::takeEvent(std::string_view json) {
  const auto event = readJson(json);
  if (!event || textOf(field(*event, "name")) != "call") return false;
  const Value* list = field(*event, "args");
  const auto* items = list ? list->findItems() : nullptr;
  const Value* asked = items && !items->empty() ? &items->front() : list;
  const Value* number = asked ? field(*asked, "idm") : nullptr;
  const Value* params = asked ? field(*asked, "params") : nullptr;
  const Value* object = params ? field(*params, "obj") : nullptr;
  if (!number || !number->isNumber() || !object) return false;
  Call call{*number, textOf(object), textOf(field(*params, "member")), {}};
  if (object->isNumber()) call.object = "#" + object->print();
  if (call.member.empty()) call.member = textOf(field(*params, "method"));
  const Value* arguments = field(*params, "args");
  if (arguments && arguments->isList()) call.arguments = *arguments->findItems();
  run(call);
  return true;
}

void QijsConnection::run(const Call& call) {
  const auto done = [weak = std::weak_ptr(alive_),
                     number = call.number](const rpc::Outcome<Value>& outcome) {
    if (const auto self = weak.lock()) (*self)->answer(number, outcome);
  };
  const bool asks_for_service = call.object == kDirectory && call.member == "service";
  if (asks_for_service) return findService(call).whenDone(done);
  calls_.find(call.object).whenDone([weak = std::weak_ptr(alive_), call, done](const auto& found) {
    const auto self = weak.lock();
    if (!self) return;
    if (!found.value) return done({{}, found.error.value_or("canceled")});
    const bool is_property = (*found.value)->findProperty(call.member) != nullptr;
    const bool is_signal = is_property || (*found.value)->findSignal(call.member) != nullptr;
    const bool is_registration = call.member == "registerEvent" || call.member == "unregisterEvent";
    if (is_signal || is_registration) {
      return (*self)->runSignal(call, call.object, is_property).whenDone(done);
    }
    (*self)->runMember(call, call.object).whenDone(done);
  });
}

QijsConnection::Result QijsConnection::runMember(const Call& call, const std::string& target) {
  return calls_.call(target, call.member, call.arguments);
}

// A service comes as an object; null if there is none, as pages expect.
QijsConnection::Result QijsConnection::findService(const Call& call) {
  Result result;
  const std::string name = call.arguments.empty() ? std::string() : textOf(&call.arguments[0]);
  calls_.find(name).whenDone(
      [result](const auto& found) { result.resolve(found.value ? Value(*found.value) : Value()); });
  return result;
}

QijsConnection::Result QijsConnection::runSignal(const Call& call, const std::string& target,
                                                 bool is_property) {
  const auto& arguments = call.arguments;
  const auto argument = [&](std::size_t i) {
    if (i >= arguments.size()) throw CallError("expected one argument more");
    return arguments[i];
  };
  try {
    if (call.member == "registerEvent") return listen(call, target, argument(0).to<std::string>());
    const bool is_old = call.member == "unregisterEvent";
    const std::string what = is_old ? "disconnect" : argument(0).to<std::string>();
    if (what == "connect") return listen(call, target, call.member);
    if (what == "disconnect") {
      const bool known = calls_.unsubscribe(argument(1).to<std::uint64_t>());
      return known ? Result::done() : Result::failed("no such link");
    }
    if (is_property && what == "value") return calls_.property(target, call.member);
    if (is_property && what == "setValue") {
      return calls_.setProperty(target, call.member, argument(1));
    }
    return Result::failed("expected connect, disconnect, value or setValue, got " + what);
  } catch (const CallError& error) {
    return Result::failed(error.what());
  }
}

QijsConnection::Result QijsConnection::listen(const Call& call, const std::string& target,
                                              const std::string& signal) {
  const std::string object =
      call.object.front() == '#' ? call.object.substr(1) : "\"" + std::string(kDirectory) + "\"";
  const auto tell = [weak = std::weak_ptr(alive_), object, signal](
                        std::uint64_t link, const std::vector<Value>& arguments) {
    const auto self = weak.lock();
    if (!self) return;
    JsonWriter writer((*self)->json_of_);
    try {
      writer.writeRaw("{\"result\":{\"obj\":" + object + ",\"signal\":");
      writer.writeText(signal);
      writer.writeRaw(",\"data\":");
      writer.write(Value::list(arguments));
      writer.writeRaw(",\"link\":" + std::to_string(link) + "}}");
      (*self)->sendEvent("signal", writer.json());
    } catch (const CallError&) {  // events are never dropped silently
      (*self)->broken_();
    }
  };
  return calls_.subscribe(target, signal, tell);
}

void QijsConnection::answer(const Value& number, const rpc::Outcome<Value>& outcome) {
  std::string error = outcome.error.value_or("Call has been canceled.");
  if (outcome.value) {
    try {
      JsonWriter writer(json_of_);
      writer.writeRaw("{\"result\":");
      writer.write(*outcome.value);
      writer.writeRaw(",\"idm\":" + number.print() + "}");
      return sendEvent("reply", writer.json());
    } catch (const CallError& failure) {
      error = failure.what();
    }
  }
  JsonWriter writer(json_of_);
  writer.writeRaw("{\"result\":");
  writer.writeText(error);
  writer.writeRaw(",\"idm\":" + number.print() + "}");
  sendEvent("error", writer.json());
}

void QijsConnection::sendEvent(const char* name, const std::string& json) {
  if (!send_) return;
  send_("5:::{\"name\":\"" + std::string(name) + "\",\"args\":[" + json + "]}");
}

std::string QijsConnection::jsonOf(const ObjectRef& object) {
  const std::int64_t number = calls_.give(object);
  const std::shared_ptr<Service> service =
      number < 0 ? nullptr : *calls_.find("#" + std::to_string(number)).outcome()->value;
  if (!service) return "null";
  JsonWriter writer(json_of_);
  writer.writeRaw("{\"pyobject\":" + std::to_string(number) + ",\"metaobject\":");
  writeMetaObject(writer, *service);
  writer.writeRaw("}");
  return writer.json();
}

}  // namespace nao::wire
