#include "daemon/qi_client.h"

#include <sys/socket.h>
#include <sys/time.h>

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <map>
#include <optional>

#include "core/check.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/services/service_info.h"
#include "naoqi_api/wire/codec.h"
#include "naoqi_api/wire/frame.h"

namespace nao::daemon {
namespace {

using boost::asio::ip::tcp;
using rpc::Value;

constexpr wire::Address kAuthenticate{0, 0, 8};
constexpr wire::Address kFindService{1, 1, 100};
constexpr std::uint32_t kMetaObject = 2;
constexpr const char* kMetaObjectType = "({I(Issss[(ss)]s)}{I(Iss)}{I(Iss)}s)";

/// One socket: frames out, frames in, answers kept until they are asked for.
class Connection {
 public:
  Connection(const std::string& host, std::uint16_t port)
      : name_(host + ":" + std::to_string(port)), socket_(io_) {
    try {
      tcp::resolver resolver(io_);
      boost::asio::connect(socket_, resolver.resolve(host, std::to_string(port)));
      socket_.set_option(tcp::no_delay(true));
    } catch (const boost::system::system_error& error) {
      throw InputError(name_ + ": expected a robot that answers there: " + error.code().message());
    }
    const timeval patience{20, 0};
    setsockopt(socket_.native_handle(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    reader_.setMaxPayload(wire::kMaxPayload);
    authenticate();
  }

  const std::string& name() const { return name_; }

  std::uint32_t send(const wire::Address& address, const Value& arguments) {
    wire::Message message;
    message.id = next_id_++;
    message.address = address;
    wire::encode(message.payload, arguments, rpc::Signature::of(arguments.signature()));
    boost::system::error_code error;
    boost::asio::write(socket_, boost::asio::buffer(encodeFrame(message)), error);
    if (error) throw InputError(name_ + ": the robot closed the connection");
    return message.id;
  }

  wire::Message receive(std::uint32_t id) {
    for (;;) {
      const auto kept = answers_.find(id);
      if (kept != answers_.end()) {
        wire::Message message = std::move(kept->second);
        answers_.erase(kept);
        return message;
      }
      take(receiveNext());
    }
  }

  /// The answer to a call, read as `signature`. @throws rpc::CallError
  Value answer(std::uint32_t id, const std::string& signature) {
    const wire::Message message = receive(id);
    const bool dynamic = (message.flags & wire::kFlagDynamic) != 0;
    if (message.type == wire::MessageType::Error) {
      const Value error = wire::Decoder(message.payload).read("m");
      throw rpc::CallError(error.findText() ? *error.findText() : "the call failed");
    }
    if (signature == "v") return {};
    return wire::Decoder(message.payload).read(dynamic ? "m" : signature);
  }

 private:
  // Robots older than 2.4 know no authentication: whatever they say, the connection is open.
  void authenticate() {
    const Value::Map none{"s", "m", {}};
    wire::Message message;
    message.id = next_id_++;
    message.address = kAuthenticate;
    wire::encode(message.payload, none, rpc::Signature::of("{sm}"));
    boost::asio::write(socket_, boost::asio::buffer(encodeFrame(message)));
    receive(message.id);
  }

  void take(wire::Message message) {
    const bool reply = message.type == wire::MessageType::Reply ||
                       message.type == wire::MessageType::Error ||
                       message.type == wire::MessageType::Canceled;
    if (reply) answers_[message.id] = std::move(message);
  }

  wire::Message receiveNext() {
    for (;;) {
      if (auto message = reader_.next()) return *std::move(message);
      if (reader_.isBroken()) throw InputError(name_ + ": expected the qi protocol, found another");
      std::array<std::uint8_t, 65536> buffer;
      const ssize_t count = ::recv(socket_.native_handle(), buffer.data(), buffer.size(), 0);
      if (count == 0) throw InputError(name_ + ": the robot closed the connection");
      if (count < 0) throw InputError(name_ + ": the robot is silent");
      reader_.push(buffer.data(), static_cast<std::size_t>(count));
    }
  }

  std::string name_;
  boost::asio::io_context io_;
  tcp::socket socket_;
  wire::FrameReader reader_;
  std::map<std::uint32_t, wire::Message> answers_;
  std::uint32_t next_id_ = 1;
};

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
    connections_.push_back(std::make_unique<Connection>(host, port));
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
        Connection& connection = *connections_[known.connection];
        const wire::Address address{known.id, 1, one.uid};
        return {known.connection, connection.send(address, *fitting), one.result};
      }
    }
    throw rpc::CallError(service + " has no method " + method + " for these arguments");
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
    Connection& connection = *connections_[known.connection];
    const auto id = connection.send({known.id, 1, kMetaObject}, Value::tuple({known.id}));
    known.methods = readMethods(connection.answer(id, kMetaObjectType));
    return services_[name] = std::move(known);
  }

  services::ServiceInfo askDirectory(const std::string& name) {
    using services::ServiceInfoFields;
    Connection& directory = *connections_.front();
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
    connections_.push_back(std::make_unique<Connection>(host_, *port));
    return connections_.size() - 1;
  }

  std::string host_;
  std::uint16_t port_;
  std::vector<std::unique_ptr<Connection>> connections_;  // the first is the directory's
  std::map<std::string, Known> services_;
};

QiClient::QiClient(const std::string& host, std::uint16_t port)
    : impl_(std::make_unique<Impl>(host, port)) {}
QiClient::~QiClient() = default;

QiClient::Ticket QiClient::begin(const std::string& service, const std::string& method,
                                 const std::vector<Value>& arguments) {
  return impl_->begin(service, method, arguments);
}

Value QiClient::finish(const Ticket& ticket) { return impl_->finish(ticket); }

Value QiClient::call(const std::string& service, const std::string& method,
                     const std::vector<Value>& arguments) {
  return finish(begin(service, method, arguments));
}

}  // namespace nao::daemon
