#pragma once

#include <sys/types.h>
#include <string>
#include <vector>

namespace nao {

/// A program that runs beside the test: started at its making, asked to end (SIGTERM) and waited
/// for at its end.
class Process {
 public:
  /// Its standard output can be read. `settings`: NAME=VALUE for its environment.
  explicit Process(std::vector<std::string> words, std::vector<std::string> settings = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// The next line it prints, without its end; empty once it has closed its output.
  std::string readLine();
  /// The first line from here on with `text` in it; empty if there is none.
  std::string readLineWith(const std::string& text);

  void interrupt();
  /// Waits for its end; its exit code, -1 if a signal ended it.
  int wait();

 private:
  pid_t process_ = 0;
  int output_ = -1;
};

/// A daemon with one nao_h25_v50 on a free port, as fast as it goes unless `speed` says otherwise.
class RobotProcess {
 public:
  explicit RobotProcess(const std::vector<std::string>& options = {},
                        const std::string& speed = "max");

  int port() const { return port_; }
  /// For the environment of programs that name another address.
  std::string setting() const { return "NAOQI_ADDRESS=127.0.0.1:" + std::to_string(port_); }
  Process& process() { return process_; }

 private:
  Process process_;
  int port_ = 0;
};

}  // namespace nao
