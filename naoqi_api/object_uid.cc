#include "naoqi_api/object_uid.h"

#include <cstdint>

namespace nao::rpc {

std::string objectUid(std::string_view seed) {
  std::string uid;
  std::uint64_t hash = 0xcbf29ce484222325U;  // FNV-1a, 64 bits
  constexpr std::uint64_t kPrime = 0x100000001b3U;
  while (uid.size() < 20) {
    for (char letter : seed) hash = (hash ^ static_cast<unsigned char>(letter)) * kPrime;
    hash = (hash ^ uid.size()) * kPrime;
    uid += static_cast<char>(hash >> 56U);
  }
  return uid;
}

}  // namespace nao::rpc
