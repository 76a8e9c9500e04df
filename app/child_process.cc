#include "app/child_process.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "core/check.h"

namespace nao::app {
namespace {

pid_t forkWith(const std::function<int()>& work, const sigset_t& signals, int at_parents_end) {
  const pid_t parent = ::getpid();
  std::fflush(nullptr);
  const pid_t child = ::fork();
  NAO_CHECK(child >= 0);
  if (child != 0) return child;
  ::prctl(PR_SET_PDEATHSIG, at_parents_end);
  if (::getppid() != parent) ::_exit(kNotFound);  // we were too late to be told
  ::pthread_sigmask(SIG_SETMASK, &signals, nullptr);
  const int code = work();
  std::fflush(nullptr);
  ::_exit(code);
}

int become(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execvp(pointers[0], pointers.data());
  std::perror(pointers[0]);
  return kNotFound;
}

}  // namespace

sigset_t watchedSignals() {
  sigset_t watched;
  ::sigemptyset(&watched);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) ::sigaddset(&watched, signal);
  return watched;
}

sigset_t blockWatchedSignals() {
  const sigset_t watched = watchedSignals();
  sigset_t before;
  ::pthread_sigmask(SIG_BLOCK, &watched, &before);
  return before;
}

// It can end well: what it writes is complete.
ChildProcess::ChildProcess(const std::function<int()>& work, const sigset_t& signals)
    : id_(forkWith(work, signals, SIGTERM)) {}

ChildProcess::ChildProcess(std::vector<std::string> words, const sigset_t& signals)
    : id_(forkWith([&words] { return become(words); }, signals, SIGKILL)) {}

ChildProcess::~ChildProcess() {
  if (hasEnded()) return;
  ::kill(id_, SIGKILL);
  int status = 0;
  ::waitpid(id_, &status, 0);
}

void ChildProcess::signal(int number) const {
  if (!ended_) ::kill(id_, number);
}

bool ChildProcess::hasEnded() {
  int status = 0;
  if (ended_ || ::waitpid(id_, &status, WNOHANG) != id_) return ended_;
  ended_ = true;
  exit_code_ = WIFSIGNALED(status) ? kBySignal + WTERMSIG(status) : WEXITSTATUS(status);
  return true;
}

}  // namespace nao::app
