#include "daemon/qi_client_connection.h"

#include <sys/socket.h>
#include <sys/time.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/write.hpp>
#include <utility>

#include "core/check.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/wire/codec.h"

namespace nao::daemon {
namespace {

using boost::asio::ip::tcp;

constexpr wire::Address kAuthenticate{0, 0, 8};

}  // namespace

using rpc::Value;

QiClientConnection::QiClientConnection(const std::string& host, std::uint16_t port)
    : name_(host + ":" + std::to_string(port)), socket_(io_) {
  try {
    tcp::resolver resolver(io_);
    boost::asio::connect(socket_, resolver.resolve(host, std::to_string(port)));
    socket_.set_option(tcp::no_delay(true));
  } catch (const boost::system::system_error& error) {
    throw InputError(name_ + ": expected a robot that answers there: " + error.code().message());
  }
  const timeval patience{kPatience, 0};
  setsockopt(socket_.native_handle(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  reader_.setMaxPayload(wire::kMaxPayload);
  authenticate();
}

std::uint32_t QiClientConnection::send(const wire::Address& address, const Value& arguments) {
  wire::Message message;
  message.id = next_id_++;
  message.address = address;
  wire::encode(message.payload, arguments, rpc::Signature::of(arguments.signature()));
  boost::system::error_code error;
  boost::asio::write(socket_, boost::asio::buffer(encodeFrame(message)), error);
  if (error) throw InputError(name_ + ": the robot closed the connection");
  return message.id;
}

wire::Message QiClientConnection::receive(std::uint32_t id) {
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

bool QiClientConnection::hasAnswer(std::uint32_t id) {
  while (answers_.count(id) == 0 && socket_.available() > 0) take(receiveNext());
  return answers_.count(id) > 0;
}

Value QiClientConnection::answer(std::uint32_t id, const std::string& signature) {
  const wire::Message message = receive(id);
  const bool dynamic = (message.flags & wire::kFlagDynamic) != 0;
  if (message.type == wire::MessageType::Error) {
    const Value error = wire::Decoder(message.payload).read("m");
    throw rpc::CallError(error.findText() ? *error.findText() : "the call failed");
  }
  if (signature == "v") return {};
  return wire::Decoder(message.payload).read(dynamic ? "m" : signature);
}

// Robots older than 2.4 know no authentication: whatever they say, the connection is open.
void QiClientConnection::authenticate() {
  const Value::Map none{"s", "m", {}};
  wire::Message message;
  message.id = next_id_++;
  message.address = kAuthenticate;
  wire::encode(message.payload, none, rpc::Signature::of("{sm}"));
  boost::asio::write(socket_, boost::asio::buffer(encodeFrame(message)));
  receive(message.id);
}

void QiClientConnection::take(wire::Message message) {
  const bool reply = message.type == wire::MessageType::Reply ||
                     message.type == wire::MessageType::Error ||
                     message.type == wire::MessageType::Canceled;
  if (reply) answers_[message.id] = std::move(message);
}

wire::Message QiClientConnection::receiveNext() {
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

}  // namespace nao::daemon
