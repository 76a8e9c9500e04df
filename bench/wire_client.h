#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "naoqi_api/wire/frame.h"

namespace nao::bench {

/// A raw client of the qi wire on loopback: one blocking socket, one thread, frames made once and
/// sent again and again.
class WireClient {
 public:
  explicit WireClient(std::uint16_t port);
  ~WireClient();
  WireClient(const WireClient&) = delete;
  WireClient& operator=(const WireClient&) = delete;

  int descriptor() const { return descriptor_; }
  void send(const wire::Bytes& bytes) const;

  /// One recv(): what has come, at most as much as fits. Returns the number of bytes.
  std::size_t receiveSome();

  /// The next message; waits for it.
  wire::Message receive();

  /// Whole messages among what receiveSome() has taken.
  std::size_t countMessages();

  /// Calls and waits; the payload of the reply. Aborts on an error.
  wire::Bytes call(const wire::Address& address, const rpc::Value& arguments);

  std::uint32_t service(const std::string& name);
  /// By name and parameters' signature.
  std::uint32_t method(std::uint32_t service, const std::string& name, const char* parameters);

 private:
  int descriptor_;
  wire::FrameReader reader_;
  std::vector<std::uint8_t> buffer_;
  std::uint32_t next_id_ = 1;
};

wire::Bytes callFrame(const wire::Address& address, const rpc::Value& arguments, std::uint32_t id);

}  // namespace nao::bench
