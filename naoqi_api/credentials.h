#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nao::rpc {

/// Who may be a client: the pairs of user and token of `--auth FILE`. Immutable.
class Credentials {
 public:
  static constexpr std::size_t kLongest = 256;  // letters of a user or a token

  /// How many wrong ones a connection may try.
  static constexpr int kMostFailures = 3;

  /// Reads lines of "user token"; empty ones and those that begin with # are skipped.
  /// @throws InputError with file and line
  static Credentials load(const std::string& path);

  /// Takes as long for a wrong pair as for a right one, wherever it is wrong.
  bool accept(std::string_view user, std::string_view token) const;

 private:
  struct Pair {
    std::string user;
    std::string token;
  };
  std::vector<Pair> pairs_;
};

}  // namespace nao::rpc
