#pragma once

#include <sys/types.h>

#include <array>
#include <atomic>
#include <cstdint>

namespace nao::bench {

/// How late each cycle of the simulation was, written by the daemon's process, seen by both.
struct Lateness {
  static constexpr std::size_t kMost = 65536;  // cycles; later ones overwrite the first
  std::atomic<std::size_t> count{0};
  std::array<float, kMost> late_ms{};
};

/// A daemon in a process of its own: one Nao at 1x, and an echo socket on the daemon's own I/O
/// thread, which answers each message of so many bytes with one of so many others. A client of
/// the echo says both numbers first, as two u32.
struct WireServer {
  pid_t process = 0;
  std::uint16_t port = 0;
  std::uint16_t echo_port = 0;
  const Lateness* lateness = nullptr;
};

/// To be called before the process has threads.
WireServer startWireServer();
void stopWireServer(const WireServer& server);

}  // namespace nao::bench
