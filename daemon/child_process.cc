#include "daemon/child_process.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "core/check.h"

namespace nao::daemon {
namespace {

pid_t startProgram(const ChildProcess::Program& program, const sigset_t& signals) {
  const Words words(program.command);
  const auto work = [&] {
    for (const auto& [name, value] : program.environment) ::setenv(name.c_str(), value.c_str(), 1);
    if (::chdir(program.folder.c_str()) == 0) return words.become();
    std::perror(program.folder.c_str());
    return kNotFound;
  };
  return startChild(work, signals, SIGKILL);
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

Words::Words(std::vector<std::string> words) : words_(std::move(words)) {
  for (std::string& word : words_) pointers_.push_back(word.data());
  pointers_.push_back(nullptr);
}

int Words::become() const {
  ::execvp(pointers_[0], pointers_.data());
  std::perror(pointers_[0]);
  return kNotFound;
}

pid_t startChild(const std::function<int()>& work, const sigset_t& signals, int at_parents_end) {
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

int exitCodeOf(int status) {
  return WIFSIGNALED(status) ? kBySignal + WTERMSIG(status) : WEXITSTATUS(status);
}

ChildProcess::ChildProcess(const std::function<int()>& work, const sigset_t& signals)
    : id_(startChild(work, signals, SIGTERM)) {}

ChildProcess::ChildProcess(const Program& program, const sigset_t& signals)
    : id_(startProgram(program, signals)) {}

ChildProcess::~ChildProcess() {
  ::kill(id_, SIGKILL);
  ::waitpid(id_, nullptr, 0);
}

void ChildProcess::signal(int number) const { ::kill(id_, number); }

// It stays one to be waited for, so that its number stays its own.
std::optional<int> ChildProcess::findEnd() const {
  siginfo_t info{};
  const int options = WEXITED | WNOWAIT | WNOHANG;
  if (::waitid(P_PID, static_cast<id_t>(id_), &info, options) != 0) return std::nullopt;
  if (info.si_pid == 0) return std::nullopt;
  return info.si_code == CLD_EXITED ? info.si_status : kBySignal + info.si_status;
}

}  // namespace nao::daemon
