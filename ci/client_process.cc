#include "ci/client_process.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "core/check.h"

namespace nao::ci {
namespace {

constexpr int kNotFound = 127;  // as a shell says it
constexpr int kBySignal = 128;

[[noreturn]] void become(const ClientProcess::Start& start, const std::vector<char*>& words,
                         pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kNotFound);  // we were too late to be told
  sigset_t none;
  ::sigemptyset(&none);
  ::pthread_sigmask(SIG_SETMASK, &none, nullptr);
  for (const auto& [name, value] : start.environment) ::setenv(name.c_str(), value.c_str(), 1);
  if (::chdir(start.folder.c_str()) == 0) ::execvp(words[0], words.data());
  std::perror(words[0]);
  ::_exit(kNotFound);
}

}  // namespace

ClientProcess::ClientProcess(const Start& start) {
  std::vector<std::string> copies = start.command;
  std::vector<char*> words;
  for (std::string& word : copies) words.push_back(word.data());
  words.push_back(nullptr);
  const pid_t parent = ::getpid();
  process_ = ::fork();
  NAO_CHECK(process_ >= 0);
  if (process_ == 0) become(start, words, parent);
}

ClientProcess::~ClientProcess() {
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

std::optional<int> ClientProcess::findEnd() const {
  siginfo_t info{};  // it stays one to be waited for, so that its number stays its own
  const int options = WEXITED | WNOWAIT | WNOHANG;
  if (::waitid(P_PID, static_cast<id_t>(process_), &info, options) != 0) return std::nullopt;
  if (info.si_pid == 0) return std::nullopt;
  return info.si_code == CLD_EXITED ? info.si_status : kBySignal + info.si_status;
}

}  // namespace nao::ci
