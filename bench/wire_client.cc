#include "bench/wire_client.h"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "naoqi_api/services/service_info.h"
#include "naoqi_api/wire/codec.h"

namespace nao::bench {

using rpc::Value;

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "wire_bench: %s\n", what.c_str());
  std::exit(1);
}

}  // namespace

wire::Bytes callFrame(const wire::Address& address, const Value& arguments, std::uint32_t id) {
  wire::Message message;
  message.id = id;
  message.address = address;
  wire::encode(message.payload, arguments, rpc::Signature::of(arguments.signature()));
  return encodeFrame(message);
}

WireClient::WireClient(std::uint16_t port)
    : descriptor_(::socket(AF_INET, SOCK_STREAM, 0)), buffer_(1U << 20U) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(descriptor_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    fail("nobody listens");
  }
  const int on = 1;
  setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  reader_.setMaxPayload(wire::kMaxPayload);
}

WireClient::~WireClient() { ::close(descriptor_); }

void WireClient::send(const wire::Bytes& bytes) const {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = ::send(descriptor_, bytes.data() + sent, bytes.size() - sent, 0);
    if (count <= 0) fail("the daemon closed the connection");
    sent += static_cast<std::size_t>(count);
  }
}

std::size_t WireClient::receiveSome() {
  const ssize_t count = ::recv(descriptor_, buffer_.data(), buffer_.size(), 0);
  if (count <= 0) fail("the daemon closed the connection");
  reader_.push(buffer_.data(), static_cast<std::size_t>(count));
  return static_cast<std::size_t>(count);
}

wire::Message WireClient::receive() {
  for (;;) {
    if (auto message = reader_.next()) return *std::move(message);
    receiveSome();
  }
}

std::size_t WireClient::countMessages() {
  std::size_t count = 0;
  while (reader_.next()) ++count;
  return count;
}

wire::Bytes WireClient::call(const wire::Address& address, const Value& arguments) {
  const std::uint32_t id = next_id_++;
  send(callFrame(address, arguments, id));
  for (;;) {
    wire::Message message = receive();
    if (message.type == wire::MessageType::Error && message.id == id) {
      fail(wire::Decoder(message.payload).read("m").print());
    }
    if (message.type == wire::MessageType::Reply && message.id == id) return message.payload;
  }
}

std::uint32_t WireClient::service(const std::string& name) {
  const Value info = wire::Decoder(call({1, 1, 100}, Value::tuple({name})))
                         .read(services::serviceInfoSignature(services::ServiceInfoFields::Six));
  return services::serviceInfoOf(info).service_id;
}

std::uint32_t WireClient::method(std::uint32_t service, const std::string& name,
                                 const char* parameters) {
  const Value object = wire::Decoder(call({service, 1, 2}, Value::tuple({0U})))
                           .read("({I(Issss[(ss)]s)}{I(Iss)}{I(Iss)}s)");
  for (const auto& [uid, method] : object.findItems()->front().find<Value::Map>()->entries) {
    const auto& fields = *method.findItems();
    if (*fields[2].findText() == name && *fields[3].findText() == parameters) {
      return *uid.find<std::uint32_t>();
    }
  }
  fail("there is no method " + name + parameters);
}

}  // namespace nao::bench
