#include "naoqi_api/sdk/cpp/src/session.h"

#include <unistd.h>

#include <utility>

#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/wire/codec.h"

namespace nao::client {
namespace {

using rpc::CallError;
using rpc::Value;

constexpr std::uint32_t kDirectory = 1;
constexpr std::uint32_t kMetaObject = 2;
constexpr std::uint32_t kPost = 101;  // __pCall
constexpr char kMetaObjectType[] = "({I(Issss[(ss)]s)}{I(Iss)}{I(Iss)}s)";
constexpr char kServiceInfo[] =
    "(sIsI[s]s)<ServiceInfo,name,serviceId,machineId,processId,endpoints,sessionId>";

// Of the directory, whose methods have these ids in every NAOqi.
namespace directory {
constexpr std::uint32_t kService = 100;
constexpr std::uint32_t kRegister = 102;
constexpr std::uint32_t kUnregister = 103;
constexpr std::uint32_t kReady = 104;
}  // namespace directory

Value ownInfo(const std::string& name) {
  const auto process = static_cast<std::uint32_t>(::getpid());
  return Value::tuple(kServiceInfo, {name, std::uint32_t{0}, "", process, Value::listOf("s", {}),
                                     "usarnaoqi-" + std::to_string(process)});
}

}  // namespace

Session::Session(const Endpoint& endpoint) : endpoint_(endpoint) {
  connection_ = std::make_unique<Connection>(
      endpoint, [this](const wire::Message& message) { take(message); });
}

Session::~Session() { close(); }

std::shared_ptr<Session> Session::shared(const Endpoint& endpoint) {
  struct Known {
    std::mutex mutex;
    std::map<std::string, std::shared_ptr<Session>> sessions;
    std::vector<std::shared_ptr<Session>> lost;
  };
  // Never destroyed, and no session in it: threads may be using them until the very end.
  static Known* known = new Known;
  const std::lock_guard lock(known->mutex);
  auto& session = known->sessions[endpoint.text()];
  if (session && session->isOpen()) return session;
  if (session) known->lost.push_back(std::move(session));
  session = std::make_shared<Session>(endpoint);
  return session;
}

void Session::close() {
  workers_.stop();
  connection_->close();
}

void Session::find(const std::string& service) {
  auto fresh = fetch(service);
  const std::lock_guard lock(mutex_);
  services_[service] = std::move(fresh);
}

std::shared_ptr<const Session::Service> Session::findService(const std::string& name) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = services_.find(name);
    if (found != services_.end()) return found->second;
  }
  find(name);
  const std::lock_guard lock(mutex_);
  return services_.at(name);
}

// The first two fields of a ServiceInfo are the same in every NAOqi.
std::shared_ptr<const Session::Service> Session::fetch(const std::string& name) {
  Service service;
  const Value info =
      connection_->call({kDirectory, 1, directory::kService}, Value::tuple({name}), "(sI)");
  service.id = (*info.findItems())[1].to<std::uint32_t>();
  const Value object =
      connection_->call({service.id, 1, kMetaObject}, Value::tuple({service.id}), kMetaObjectType);
  for (const auto& [uid, fields] : object.findItems()->front().find<Value::Map>()->entries) {
    const std::vector<Value>& items = *fields.findItems();
    service.methods.push_back({uid.to<std::uint32_t>(), *items[2].findText(), *items[3].findText(),
                               *items[1].findText()});
  }
  return std::make_shared<const Service>(std::move(service));
}

Session::Chosen Session::choose(const std::string& service, const std::string& method,
                                const std::vector<Value>& arguments) {
  const auto known = findService(service);
  const Value tuple = Value::tuple(arguments);
  for (const bool exact : {true, false}) {
    for (const Method& one : known->methods) {
      if (one.name != method || (exact && one.parameters != tuple.signature())) continue;
      const auto parameters = rpc::Signature::parse(one.parameters);
      auto fitting = parameters ? rpc::convert(tuple, *parameters, rpc::Bend::Loose) : std::nullopt;
      if (fitting) return {known->id, one, *std::move(fitting)};
    }
  }
  throw CallError("Can't find method: " + method + " (resolved to '" + tuple.signature() + "')");
}

Value Session::call(const std::string& service, const std::string& method,
                    const std::vector<Value>& arguments) {
  const Chosen chosen = choose(service, method, arguments);
  return connection_->call({chosen.service, 1, chosen.method.uid}, chosen.arguments,
                           chosen.method.returns);
}

int Session::post(const std::string& service, const std::string& method,
                  const std::vector<Value>& arguments) {
  const Chosen chosen = choose(service, method, arguments);
  const Value posted =
      Value::tuple({chosen.method.uid, Value::list(*chosen.arguments.findItems())});
  return connection_->call({chosen.service, 1, kPost}, posted, "i").to<int>();
}

std::uint32_t Session::offer(const std::string& name, std::shared_ptr<HostedObject> object) {
  const Value id =
      connection_->call({kDirectory, 1, directory::kRegister}, Value::tuple({ownInfo(name)}), "I");
  const auto number = id.to<std::uint32_t>();
  {
    const std::lock_guard lock(mutex_);
    hosted_[number] = std::move(object);
  }
  connection_->call({kDirectory, 1, directory::kReady}, Value::tuple({number}), "v");
  return number;
}

void Session::withdraw(std::uint32_t id) {
  if (isOpen()) {
    connection_->call({kDirectory, 1, directory::kUnregister}, Value::tuple({id}), "v");
  }
  const std::lock_guard lock(mutex_);
  hosted_.erase(id);
}

// On the reading thread.
void Session::take(const wire::Message& call) {
  const std::lock_guard lock(mutex_);
  const auto found = hosted_.find(call.address.service);
  const auto object = found == hosted_.end() ? nullptr : found->second;
  workers_.post([this, object, call] {
    wire::Message answer;
    if (object) {
      answer = object->answer(call);
    } else {
      answer.id = call.id;
      answer.address = call.address;
      answer.type = wire::MessageType::Error;
      wire::encodeDynamic(answer.payload, Value("no module has the number " +
                                                std::to_string(call.address.service) + " here"));
    }
    if (call.type == wire::MessageType::Call) connection_->send(answer);
  });
}

}  // namespace nao::client
