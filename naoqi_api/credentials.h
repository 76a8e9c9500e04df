#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nao::rpc {

/// Who may be a client: the pairs of user and token of `--auth FILE`.
class Credentials {
 public:
  static constexpr std::size_t kLongest = 256;  // letters of a user or a token

  /// How many wrong ones a connection may try.
  static constexpr int kMostFailures = 3;

  /// Reads lines of "user token"; empty ones and those that begin with # are skipped.
  /// @throws InputError with file and line
  static Credentials load(const std::string& path);

  /// One more, of the program's own.
  void add(std::string user, std::string token) {
    pairs_.push_back({std::move(user), std::move(token)});
  }

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
