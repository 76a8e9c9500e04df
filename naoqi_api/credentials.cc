#include "naoqi_api/credentials.h"

#include <cstdint>
#include <fstream>
#include <sstream>

#include "core/check.h"

namespace nao::rpc {
namespace {

// 0 if both are the same; every letter of the longest possible text is looked at.
unsigned difference(std::string_view known, std::string_view given) {
  unsigned different = known.size() == given.size() ? 0U : 1U;
  for (std::size_t i = 0; i < Credentials::kLongest; ++i) {
    const unsigned a = i < known.size() ? static_cast<std::uint8_t>(known[i]) : 0U;
    const unsigned b = i < given.size() ? static_cast<std::uint8_t>(given[i]) : 0U;
    different |= a ^ b;
  }
  return different;
}

}  // namespace

Credentials Credentials::load(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": can not be read, expected lines of 'user token'");
  Credentials credentials;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    std::istringstream words(line);
    Pair pair;
    std::string rest;
    if (!(words >> pair.user) || pair.user.front() == '#') continue;
    const bool two = words >> pair.token && !(words >> rest);
    if (!two || pair.user.size() > kLongest || pair.token.size() > kLongest) {
      throw InputError(path + ":" + std::to_string(number) +
                       ": expected a user and a token of at most " + std::to_string(kLongest) +
                       " letters, without blanks");
    }
    credentials.pairs_.push_back(std::move(pair));
  }
  if (credentials.pairs_.empty()) {
    throw InputError(path + ":" + std::to_string(number) + ": expected at least one 'user token'");
  }
  return credentials;
}

bool Credentials::accept(std::string_view user, std::string_view token) const {
  unsigned accepted = 0;
  for (const Pair& pair : pairs_) {
    const unsigned wrong = difference(pair.user, user) | difference(pair.token, token);
    accepted |= wrong == 0 ? 1U : 0U;
  }
  return accepted != 0;
}

}  // namespace nao::rpc
