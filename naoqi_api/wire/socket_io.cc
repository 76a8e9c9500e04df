#include "naoqi_api/wire/socket_io.h"

#include <charconv>
#include <cstdint>

namespace nao::wire {
namespace {

constexpr std::string_view kMark = "\xEF\xBF\xBD";  // U+FFFD

// How many UTF-16 units the letter that begins with this byte of UTF-8 takes.
std::size_t unitsOf(char byte) {
  const auto bits = static_cast<std::uint8_t>(byte);
  if ((bits & 0xC0U) == 0x80U) return 0;  // within a letter
  return bits >= 0xF0U ? 2 : 1;
}

// The bytes that so many units take, if there are as many.
std::optional<std::size_t> bytesOf(std::string_view text, std::size_t units) {
  std::size_t at = 0;
  while (at < text.size() && units >= unitsOf(text[at])) units -= unitsOf(text[at++]);
  if (units > 0) return std::nullopt;
  return at;
}

bool take(std::string_view& text, std::string_view wanted) {
  if (text.substr(0, wanted.size()) != wanted) return false;
  text.remove_prefix(wanted.size());
  return true;
}

}  // namespace

std::string joinPackets(const std::deque<std::string>& packets) {
  if (packets.size() == 1) return packets.front();
  std::string body;
  for (const std::string& packet : packets) {
    std::size_t units = 0;
    for (const char byte : packet) units += unitsOf(byte);
    body += kMark;
    body += std::to_string(units);
    body += kMark;
    body += packet;
  }
  return body;
}

std::optional<std::vector<std::string_view>> splitPackets(std::string_view body) {
  if (body.substr(0, kMark.size()) != kMark) return std::vector{body};
  std::vector<std::string_view> packets;
  while (!body.empty()) {
    std::size_t units = 0;
    if (!take(body, kMark)) return std::nullopt;
    const auto read = std::from_chars(body.data(), body.data() + body.size(), units);
    if (read.ec != std::errc()) return std::nullopt;
    body.remove_prefix(static_cast<std::size_t>(read.ptr - body.data()));
    if (!take(body, kMark)) return std::nullopt;
    const auto bytes = bytesOf(body, units);
    if (!bytes) return std::nullopt;
    packets.push_back(body.substr(0, *bytes));
    body.remove_prefix(*bytes);
  }
  return packets;
}

}  // namespace nao::wire
