#pragma once

#include <sys/types.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nao::ci {

/// A program beside the world. It ends with this object, and whatever happens to us.
class ClientProcess {
 public:
  struct Start {
    std::vector<std::string> command;
    std::string folder;                              // to run in
    std::map<std::string, std::string> environment;  // beside our own
  };

  explicit ClientProcess(const Start& start);
  ~ClientProcess();
  ClientProcess(const ClientProcess&) = delete;
  ClientProcess& operator=(const ClientProcess&) = delete;

  pid_t id() const { return process_; }

  /// Its exit code once it has ended; 128 + n: by signal n, 127: it could not be started.
  std::optional<int> findEnd() const;

 private:
  pid_t process_;
};

}  // namespace nao::ci
