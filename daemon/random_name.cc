#include "daemon/random_name.h"

#include <openssl/rand.h>

#include "core/check.h"

namespace nao::daemon {

std::string makeRandomName() {
  unsigned char bytes[16];
  NAO_CHECK(RAND_bytes(bytes, sizeof bytes) == 1);
  constexpr char kDigits[] = "0123456789abcdef";
  std::string name;
  for (const unsigned char byte : bytes) {
    name += kDigits[byte >> 4U];
    name += kDigits[byte & 15U];
  }
  return name;
}

}  // namespace nao::daemon
