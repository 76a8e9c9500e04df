#pragma once

#include <sys/types.h>

#include <csignal>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nao::daemon {

constexpr int kNotFound = 127;  // exit code, as a shell's, when there is no such program
constexpr int kBySignal = 128;  // + n, as a shell's: ended by signal n

/// Blocks the signals that a parent of children waits for, for this thread and its children to
/// come; returns those that were blocked before.
sigset_t blockWatchedSignals();
sigset_t watchedSignals();

/// A program's words as the system wants them; made before a fork, used after it.
class Words {
 public:
  explicit Words(std::vector<std::string> words);
  Words(const Words&) = delete;
  Words& operator=(const Words&) = delete;

  /// This process becomes that program. Returns kNotFound, and says why, if there is none.
  int become() const;

 private:
  std::vector<std::string> words_;
  std::vector<char*> pointers_;
};

/// A child that does `work`, which returns its exit code, with these `signals` blocked, and is sent
/// `at_parents_end` when we end, whatever ends us.
pid_t startChild(const std::function<int()>& work, const sigset_t& signals, int at_parents_end);

/// Of a status as waitpid() tells it.
int exitCodeOf(int status);

/// A child that ends with this object, and with its parent.
class ChildProcess {
 public:
  struct Program {
    std::vector<std::string> command;
    std::string folder = ".";                        // to run in
    std::map<std::string, std::string> environment;  // beside our own
  };

  /// `work` returns the exit code; it can end well when the parent ends.
  ChildProcess(const std::function<int()>& work, const sigset_t& signals);
  /// Another program; kNotFound if there is none.
  ChildProcess(const Program& program, const sigset_t& signals);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  pid_t id() const { return id_; }
  void signal(int number) const;

  bool hasEnded() const { return findEnd().has_value(); }
  /// Its exit code once it has ended.
  std::optional<int> findEnd() const;

 private:
  pid_t id_;
};

}  // namespace nao::daemon
