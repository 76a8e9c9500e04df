#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/server_watch.h"
#include "bench/wire_client.h"

namespace nao::bench {

/// 200 clients that all listen to 20 events, which one client raises 50 times a second.
class EventStorm {
 public:
  static constexpr int kListeners = 200;
  static constexpr int kEvents = 20;
  static constexpr int kCycles = 500;  // 10 s

  explicit EventStorm(const WireServer& server);
  EventStorm(const EventStorm&) = delete;
  EventStorm& operator=(const EventStorm&) = delete;
  ~EventStorm();

  void run(std::map<std::string, double>& figures);

 private:
  void pass(bool raising);
  void listen(WireClient& client, std::uint32_t subscriber, int event) const;
  void raiseAll(int cycle);
  void collect(Clock::time_point until);

  const WireServer& server_;
  WireClient publisher_;
  std::vector<std::unique_ptr<WireClient>> listeners_;
  int all_;  // epoll's descriptor of the listeners
  std::uint32_t memory_ = 0;
  std::uint32_t raise_ = 0;
  std::size_t got_ = 0;
  std::size_t pieces_ = 0;
};

}  // namespace nao::bench
