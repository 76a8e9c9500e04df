#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "core/random.h"
#include "core/sim_time.h"
#include "daemon/stream.h"

namespace nao::daemon {

/// What happens to packets between a robot and its clients, for a while.
struct WireFault {
  Duration delay{};  // of each packet, on each way
  double loss = 0;   // part of the packets that are lost once, and come again
  SimTime until{};
};

/// The wire of one robot: holds back what passes while a fault lasts, in simulated time. A packet
/// is a piece that leaves in one write or comes in one read. One that is lost comes after TCP has
/// sent it again, kAgain later and each time twice as late; nothing overtakes it. I/O thread.
class WireDelay {
 public:
  static constexpr Duration kAgain = std::chrono::milliseconds(200);  // Linux' least (RTO_MIN)

  explicit WireDelay(std::uint64_t seed) : random_(seed, "wire") {}

  void set(const WireFault& fault) { fault_ = fault; }

  /// Lets happen what is due.
  void advance(SimTime now);

  /// The same stream over this wire, which outlives it.
  std::unique_ptr<Stream> over(std::unique_ptr<Stream> inner);

 private:
  class Held;

  /// When a packet that leaves now arrives; not before `earliest`.
  SimTime arrival(SimTime earliest);
  void later(SimTime at, std::function<void()> job) { jobs_.emplace(at, std::move(job)); }

  SimTime now_{};
  WireFault fault_;
  Random random_;
  std::multimap<SimTime, std::function<void()>> jobs_;  // equal times in their order
};

}  // namespace nao::daemon
