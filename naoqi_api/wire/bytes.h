#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "naoqi_api/value.h"

namespace nao::wire {

// The bytes of numbers are the host's, which is taken to be little-endian like the wire.
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "swap bytes in naoqi_api/wire/bytes.h");

template <class T>
void appendNumber(rpc::Bytes& out, T number) {
  const std::size_t at = out.size();
  out.resize(at + sizeof(T));
  std::memcpy(out.data() + at, &number, sizeof(T));
}

/// @param bytes at least sizeof(T) of them.
template <class T>
T readNumber(const std::uint8_t* bytes) {
  T number;
  std::memcpy(&number, bytes, sizeof(T));
  return number;
}

inline void appendText(rpc::Bytes& out, std::string_view text) {
  appendNumber(out, static_cast<std::uint32_t>(text.size()));
  out.insert(out.end(), text.begin(), text.end());
}

}  // namespace nao::wire
