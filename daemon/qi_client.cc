#include "daemon/qi_client.h"

#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "core/check.h"
#include "daemon/qi_client_connection.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/services/service_info.h"
#include "naoqi_api/wire/codec.h"

namespace nao::daemon {
namespace {

using rpc::Value;

constexpr wire::Address kFindService{1, 1, 100};
constexpr std::uint32_t kMetaObject = 2;
constexpr const char* kMetaObjectType = "({I(Issss[(ss)]s)}{I(Iss)}{I(Iss)}s)";

struct Method {
  std::uint32_t uid = 0;
  std::string name;
  std::string parameters;  // signature, a tuple
  std::string result;
};

std::vector<Method> readMethods(const Value& object) {
  std::vector<Method> methods;
  for (const auto& [uid, fields] : object.findItems()->front().find<Value::Map>()->entries) {
    const std::vector<Value>& items = *fields.findItems();
    methods.push_back({*uid.find<std::uint32_t>(), *items[2].findText(), *items[3].findText(),
                       *items[1].findText()});
  }
  return methods;
}

// "tcp://10.0.0.2:9559" -> host and port; nothing for other kinds of addresses.
std::optional<std::pair<std::string, std::uint16_t>> parseEndpoint(const std::string& text) {
  constexpr std::size_t kScheme = 6;
  const std::size_t colon = text.rfind(':');
  if (text.rfind("tcp://", 0) != 0 || colon <= kScheme) return {};
  const int port = std::atoi(text.c_str() + colon + 1);
  if (port <= 0 || port > 65535) return {};
  return std::pair(text.substr(kScheme, colon - kScheme), static_cast<std::uint16_t>(port));
}

}  // namespace

class QiClient::Impl {
 public:
  Impl(const std::string& host, std::uint16_t port) : host_(host), port_(port) {
    connections_.push_back(std::make_unique<QiClientConnection>(host, port));
  }

  Ticket begin(const std::string& service, const std::string& method,
               const std::vector<Value>& arguments) {
    const Known& known = findService(service);
    const Value tuple = Value::tuple(arguments);
    // An overload for exactly these types before one they can be bent to.
    for (const bool exact : {true, false}) {
      for (const Method& one : known.methods) {
        if (one.name != method || (exact && one.parameters != tuple.signature())) continue;
        const auto parameters = rpc::Signature::of(one.parameters);
        const auto fitting = rpc::convert(tuple, parameters, rpc::Bend::Loose);
        if (!fitting) continue;
        QiClientConnection& connection = *connections_[known.connection];
        const wire::Address address{known.id, 1, one.uid};
        return {known.connection, connection.send(address, *fitting), one.result};
      }
    }
    throw rpc::CallError(service + " has no method " + method + " for these arguments");
  }

  bool isAnswered(const Ticket& ticket) {
    return connections_[ticket.connection]->hasAnswer(ticket.id);
  }

  Value finish(const Ticket& ticket) {
    return connections_[ticket.connection]->answer(ticket.id, ticket.result);
  }

 private:
  struct Known {
    std::size_t connection = 0;
    std::uint32_t id = 0;
    std::vector<Method> methods;
  };

  const Known& findService(const std::string& name) {
    const auto found = services_.find(name);
    if (found != services_.end()) return found->second;
    const services::ServiceInfo info = askDirectory(name);
    Known known;
    known.id = info.service_id;
    known.connection = connectTo(info);
    QiClientConnection& connection = *connections_[known.connection];
    const auto id = connection.send({known.id, 1, kMetaObject}, Value::tuple({known.id}));
    known.methods = readMethods(connection.answer(id, kMetaObjectType));
    return services_[name] = std::move(known);
  }

  services::ServiceInfo askDirectory(const std::string& name) {
    using services::ServiceInfoFields;
    QiClientConnection& directory = *connections_.front();
    const wire::Message message =
        directory.receive(directory.send(kFindService, Value::tuple({name})));
    if (message.type == wire::MessageType::Error) {
      throw rpc::CallError("the robot has no service " + name);
    }
    for (const auto fields : {ServiceInfoFields::Seven, ServiceInfoFields::Six}) {
      try {
        wire::Decoder decoder(message.payload);
        const Value info = decoder.read(services::serviceInfoSignature(fields));
        if (decoder.left() == 0) return services::serviceInfoOf(info);
      } catch (const wire::CodecError&) {
        continue;  // it has six fields, then
      }
    }
    throw InputError(directory.name() + ": expected a ServiceInfo, found other bytes");
  }

  // Services of one process share a port, others have their own; behind a router only the host that
  // was dialled is sure to be reached.
  std::size_t connectTo(const services::ServiceInfo& info) {
    std::optional<std::uint16_t> port;
    for (const std::string& endpoint : info.endpoints) {
      const auto parsed = parseEndpoint(endpoint);
      if (!parsed) continue;
      if (parsed->second == port_) return 0;
      port = parsed->second;
    }
    if (!port) return 0;
    const std::string name = host_ + ":" + std::to_string(*port);
    for (std::size_t i = 0; i < connections_.size(); ++i) {
      if (connections_[i]->name() == name) return i;
    }
    connections_.push_back(std::make_unique<QiClientConnection>(host_, *port));
    return connections_.size() - 1;
  }

  std::string host_;
  std::uint16_t port_;
  std::vector<std::unique_ptr<QiClientConnection>> connections_;  // the first is the directory's
  std::map<std::string, Known> services_;
};

QiClient::QiClient(const std::string& host, std::uint16_t port)
    : impl_(std::make_unique<Impl>(host, port)) {}
QiClient::~QiClient() = default;

QiClient::Ticket QiClient::begin(const std::string& service, const std::string& method,
                                 const std::vector<Value>& arguments) {
  return impl_->begin(service, method, arguments);
}

bool QiClient::isAnswered(const Ticket& ticket) { return impl_->isAnswered(ticket); }

Value QiClient::finish(const Ticket& ticket) { return impl_->finish(ticket); }

Value QiClient::call(const std::string& service, const std::string& method,
                     const std::vector<Value>& arguments) {
  return finish(begin(service, method, arguments));
}

}  // namespace nao::daemon
