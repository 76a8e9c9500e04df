#include "daemon/places.h"

#include <algorithm>

namespace nao::daemon {

std::optional<std::size_t> whoGivesWay(const std::vector<Guest>& oldest_first,
                                       std::chrono::steady_clock::time_point now) {
  const auto begin = oldest_first.begin();
  const auto end = oldest_first.end();
  const auto silent = std::find_if(begin, end, [](const Guest& guest) { return !guest.is_open; });
  if (silent != end) return static_cast<std::size_t>(silent - begin);
  const auto quietest = std::min_element(
      begin, end, [](const Guest& a, const Guest& b) { return a.last_heard < b.last_heard; });
  if (quietest == end || now - quietest->last_heard < kIdle) return std::nullopt;
  return static_cast<std::size_t>(quietest - begin);
}

}  // namespace nao::daemon
