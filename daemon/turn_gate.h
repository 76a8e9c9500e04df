#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "clock/clock_page.h"
#include "daemon/stream.h"

namespace nao::daemon {

/// The door between the sockets of clients that take turns with the world and their sessions: what
/// comes while it is another's turn waits here, so that neither the kernel's speed nor ours decides
/// in which order the world hears them. I/O thread.
class TurnGate {
 public:
  explicit TurnGate(clock::ClockPage& page) : page_(page) {}

  /// The same stream behind the gate; in the order of these calls its clients are heard.
  std::unique_ptr<Stream> guard(std::unique_ptr<Stream> inner, std::uint16_t from_port,
                                std::uint16_t to_port);

  /// Whether all that clients have sent until now is here, and all who have gone are known to be.
  bool hasAll();

  /// Hands what waits to the sessions. Whether there was anything.
  bool open();

  /// Bytes that clients were given, ever.
  std::uint64_t given() const { return given_; }

 private:
  class Guarded;
  struct Flow;

  Flow* flowOf(const clock::Link& link);
  clock::Link* linkOf(const Flow& flow);
  void count(const Flow& flow, std::size_t bytes);
  bool isComplete(clock::Link& link);
  void leave(const std::shared_ptr<Flow>& flow);

  clock::ClockPage& page_;
  std::vector<std::shared_ptr<Flow>> flows_;
  std::uint64_t given_ = 0;
};

}  // namespace nao::daemon
