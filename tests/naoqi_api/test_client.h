#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/service_hub.h"
#include "naoqi_api/wire/codec.h"
#include "naoqi_api/wire/qi_connection.h"
#include "tests/naoqi_api/demo_service.h"

namespace nao::wire {

/// A client of a hub in the same program: speaks frames to a QiConnection, keeps what comes back.
class TestClient {
 public:
  explicit TestClient(rpc::ServiceHub& hub)
      : connection(std::make_unique<QiConnection>(hub, "tcp://127.0.0.1:9559",
                                                  [this](const Bytes& frame) { take(frame); })) {}

  void send(const Message& message) { sendBytes(encodeFrame(message)); }
  void sendBytes(const Bytes& bytes) { connection->receive(bytes.data(), bytes.size()); }

  /// Sends a call with arguments of that signature, e.g. "(ii)"; returns its number.
  std::uint32_t call(const Address& address, const Value& arguments, std::uint8_t flags = 0,
                     MessageType type = MessageType::Call) {
    Message message;
    message.id = next_id++;
    message.type = type;
    message.flags = flags;
    message.address = address;
    if ((flags & kFlagDynamic) != 0) {
      encodeDynamic(message.payload, arguments);
    } else {
      encode(message.payload, arguments, Signature::of(arguments.signature()));
    }
    send(message);
    return message.id;
  }

  /// The opening of a client that can do these things.
  void authenticate(
      const rpc::Capabilities& capabilities = rpc::Personality::naoqi().capabilities) {
    Value::Map map{"s", "m", {}};
    for (const auto& [name, on] : capabilities) map.entries.emplace_back(name, on);
    Message message;
    message.id = next_id++;
    message.address = {0, 0, 8};
    encode(message.payload, map, Signature::of("{sm}"));
    send(message);
    received.clear();
  }

  /// The oldest message that came and was not taken, if there is one.
  std::optional<Message> next() {
    if (received.empty()) return std::nullopt;
    Message message = std::move(received.front());
    received.pop_front();
    return message;
  }

  /// The content of the next message, read as `signature`; of an error: its text.
  Value nextValue(const std::string& signature) {
    const auto message = next();
    if (!message) return "nothing came";
    const bool dynamic = message->type == MessageType::Error || (message->flags & 1U) != 0;
    return Decoder(message->payload).read(dynamic ? "m" : signature);
  }

  std::unique_ptr<QiConnection> connection;
  std::deque<Message> received;
  std::uint32_t next_id = 1;

 private:
  void take(const Bytes& frame) {
    FrameReader reader;
    reader.setMaxPayload(kMaxPayload);
    reader.push(frame.data(), frame.size());
    while (auto message = reader.next()) received.push_back(*std::move(message));
  }
};

/// A hub with the Demo service as number 2.
struct DemoHub {
  explicit DemoHub(rpc::Personality personality = rpc::Personality::naoqi(), rpc::Alarm alarm = {})
      : hub(options(std::move(personality), std::move(alarm))) {
    hub.add(demo.describe());
  }

  static rpc::HubOptions options(rpc::Personality personality, rpc::Alarm alarm) {
    rpc::HubOptions options;
    options.alarm = std::move(alarm);
    options.personality = std::move(personality);
    options.machine_id = "01234567-89ab-cdef-0123-456789abcdef";
    options.process_id = 42;
    return options;
  }

  rpc::Demo demo;
  rpc::ServiceHub hub;
};

}  // namespace nao::wire
