#pragma once

#include <sys/socket.h>
#include <sys/time.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/services/service_info.h"
#include "naoqi_api/wire/codec.h"
#include "naoqi_api/wire/frame.h"

namespace nao::daemon {

/// A plain blocking client on loopback. A silence of 20 s is the end of the test, not of patience.
class TcpClient {
 public:
  explicit TcpClient(std::uint16_t port) : socket_(io_) {
    socket_.connect({boost::asio::ip::make_address("127.0.0.1"), port});
    const timeval patience{20, 0};
    setsockopt(socket_.native_handle(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    setsockopt(socket_.native_handle(), SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    reader_.setMaxPayload(wire::kMaxPayload);
  }

  void sendBytes(const wire::Bytes& bytes) {
    boost::asio::write(socket_, boost::asio::buffer(bytes));
  }

  /// False when the other side has closed.
  bool trySendBytes(const wire::Bytes& bytes) {
    boost::system::error_code error;
    boost::asio::write(socket_, boost::asio::buffer(bytes), error);
    return !error;
  }

  std::uint32_t call(const wire::Address& address, const rpc::Value& arguments) {
    wire::Message message;
    message.id = next_id_++;
    message.address = address;
    wire::encode(message.payload, arguments, rpc::Signature::of(arguments.signature()));
    sendBytes(encodeFrame(message));
    return message.id;
  }

  /// The next message; nothing once the other side has closed.
  std::optional<wire::Message> receive() {
    for (;;) {
      if (auto message = reader_.next()) return message;
      std::uint8_t buffer[65536];
      const ssize_t count = ::recv(socket_.native_handle(), buffer, sizeof buffer, 0);
      if (count == 0 || (count < 0 && errno == ECONNRESET)) return std::nullopt;
      if (count < 0) throw std::runtime_error("the daemon is silent");
      reader_.push(buffer, static_cast<std::size_t>(count));
    }
  }

  /// The answer to a call, read as `signature`; messages between are dropped.
  rpc::Value answer(std::uint32_t id, const std::string& signature) {
    for (;;) {
      const auto message = receive();
      if (!message) throw std::runtime_error("the daemon closed the connection");
      const bool error = message->type == wire::MessageType::Error;
      if (message->id != id || (message->type != wire::MessageType::Reply && !error)) continue;
      return wire::Decoder(message->payload).read(error ? "m" : signature);
    }
  }

  /// The service number of `name`, asked from the directory without authentication, as an old
  /// client does.
  std::uint32_t service(const std::string& name) {
    const auto id = call({1, 1, 100}, rpc::Value::tuple({name}));
    const rpc::Value info = answer(
        id, "(sIsI[s]s)<ServiceInfo,name,serviceId,machineId,processId,endpoints,sessionId>");
    return services::serviceInfoOf(info).service_id;
  }

  /// The number of a method by its name; the first of several.
  std::uint32_t method(std::uint32_t service, const std::string& name) {
    const rpc::Value object = answer(call({service, 1, 2}, rpc::Value::tuple({0U})),
                                     "({I(Issss[(ss)]s)}{I(Iss)}{I(Iss)}s)");
    for (const auto& [uid, method] : object.findItems()->front().find<rpc::Value::Map>()->entries) {
      if (*method.findItems()->at(2).findText() == name) return *uid.find<std::uint32_t>();
    }
    throw std::runtime_error("there is no method " + name);
  }

  /// What a service's method returns, read as `signature`.
  rpc::Value result(const std::string& service, const std::string& method,
                    std::vector<rpc::Value> arguments, const std::string& signature) {
    const std::uint32_t id = this->service(service);
    const wire::Address address{id, 1, this->method(id, method)};
    return answer(call(address, rpc::Value::tuple(std::move(arguments))), signature);
  }

  void shutDown() { socket_.close(); }

 private:
  boost::asio::io_context io_;
  boost::asio::ip::tcp::socket socket_;
  wire::FrameReader reader_;
  std::uint32_t next_id_ = 1;
};

}  // namespace nao::daemon
