#pragma once

#include <sys/types.h>

#include <csignal>
#include <functional>
#include <string>
#include <vector>

namespace nao::app {

constexpr int kNotFound = 127;  // exit code, as a shell's, when there is no such program
constexpr int kBySignal = 128;  // + n, as a shell's: ended by signal n

/// Blocks the signals that a parent of children waits for, for this thread and its children to
/// come.
sigset_t blockWatchedSignals();
sigset_t watchedSignals();

/// Ends with its parent, whatever ends that.
class ChildProcess {
 public:
  /// `work` returns the exit code.
  ChildProcess(const std::function<int()>& work, const sigset_t& signals);
  /// Another program; kNotFound if there is none.
  ChildProcess(std::vector<std::string> words, const sigset_t& signals);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  pid_t id() const { return id_; }
  void signal(int number) const;

  /// Whether it has ended.
  bool hasEnded();
  /// After the end.
  int exitCode() const { return exit_code_; }

 private:
  pid_t id_ = 0;
  bool ended_ = false;
  int exit_code_ = 0;
};

}  // namespace nao::app
