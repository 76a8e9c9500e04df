#pragma once

#include <sys/types.h>

#include <cstdint>

namespace nao::bench {

/// A daemon in a process of its own: one Nao at 1x, and an echo socket on the daemon's own I/O
/// thread, which answers each message of so many bytes with one of so many others. A client of
/// the echo says both numbers first, as two u32.
struct WireServer {
  pid_t process = 0;
  std::uint16_t port = 0;
  std::uint16_t echo_port = 0;
};

/// To be called before the process has threads.
WireServer startWireServer();
void stopWireServer(const WireServer& server);

}  // namespace nao::bench
