#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nao::wire {

// Where socket.io 0.9 has no messages of its own to put its packets in, as in a body of HTTP:
//   one packet       as it is
//   more of them     each as  U+FFFD length U+FFFD packet , its length in UTF-16 units

/// One body of all `packets`, of which there is at least one.
std::string joinPackets(const std::deque<std::string>& packets);

/// The packets of a body; nothing if it is not well-formed.
std::optional<std::vector<std::string_view>> splitPackets(std::string_view body);

}  // namespace nao::wire
