#pragma once

#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/value.h"
#include "naoqi_api/wire/msgpack_codec.h"

namespace nao::daemon {

/// A LoLA client as teams write them: blocking, one receive of 896 bytes a frame, maps of float32.
/// A silence of 20 s is the end of the test, not of patience.
class LolaClient {
 public:
  using Value = rpc::Value;
  using Map = std::vector<std::pair<std::string, Value>>;

  static constexpr std::size_t kFrame = 896;  // bytes

  explicit LolaClient(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_STREAM, 0)) {
    const timeval patience{20, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    if (::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
      throw std::runtime_error("nobody answers at " + path);
    }
  }
  ~LolaClient() { close(); }
  LolaClient(const LolaClient&) = delete;
  LolaClient& operator=(const LolaClient&) = delete;

  void close() {
    if (socket_ >= 0) ::close(std::exchange(socket_, -1));
  }

  /// The bytes of one receive; none once the robot has closed. `most`: with room for more than a
  /// frame, two at once show; where the world does not wait, one may come while another is read.
  std::string receiveBytes(std::size_t most = 4 * kFrame) {
    std::string bytes(most, '\0');
    const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
    if (count < 0 && errno != ECONNRESET) throw std::runtime_error("the robot is silent");
    bytes.resize(static_cast<std::size_t>(count > 0 ? count : 0));
    return bytes;
  }

  /// The next frame. @throws std::runtime_error unless it came whole.
  Value receive() {
    const std::string bytes = receiveBytes(kFrame);
    wire::MsgpackReader reader;
    reader.push(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    auto frame = reader.next();
    if (bytes.size() != kFrame || !frame || reader.bytesHeld() != 0) {
      throw std::runtime_error("a malformed frame of " + std::to_string(bytes.size()) + " bytes");
    }
    return *frame;
  }

  /// False once the robot has closed.
  bool send(const std::string& bytes) {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const ssize_t count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) return false;
      sent += static_cast<std::size_t>(count);
    }
    return true;
  }
  bool send(const Map& map) { return send(packed(map)); }

  static std::string packed(const Map& map) {
    Value::Map entries{"s", "m", {}};
    for (const auto& [key, value] : map) entries.entries.emplace_back(key, value);
    rpc::Bytes bytes;
    wire::packValue(bytes, Value(std::move(entries)), {});
    return {bytes.begin(), bytes.end()};
  }

  /// As many times the same number.
  static Value list(float value, std::size_t count = 25) {
    return Value::list(std::vector<Value>(count, Value(value)));
  }

  static double at(const Value& frame, const std::string& key, std::size_t i) {
    for (const auto& [name, value] : frame.find<Value::Map>()->entries) {
      if (*name.findText() == key) return value.findItems()->at(i).findNumber().value();
    }
    throw std::runtime_error("the frame has no " + key);
  }

 private:
  int socket_;
};

}  // namespace nao::daemon
