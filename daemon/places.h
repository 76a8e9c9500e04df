#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

namespace nao::daemon {

/// One of those who hold the places of a server.
struct Guest {
  bool is_open = false;  // has said enough to be a client
  std::chrono::steady_clock::time_point last_heard{};
};

/// How long an open client may be silent and keep its place although all are taken. Free choice.
constexpr std::chrono::seconds kIdle{60};

/// Which of them gives its place to one that comes when all are taken: the first that has not
/// opened its connection, else the one that has been silent longest, if longer than kIdle.
std::optional<std::size_t> whoGivesWay(const std::vector<Guest>& oldest_first,
                                       std::chrono::steady_clock::time_point now);

}  // namespace nao::daemon
