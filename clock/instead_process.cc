// Processes and their alarms.
#include <signal.h>
#include <spawn.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "clock/real.h"
#include "clock/turn.h"

using namespace nao::clock;

namespace {

/// A wait for children, asked without waiting.
template <class Call>
class Children final : public Waiting {
 public:
  explicit Children(Call call) : call_(call) {}
  bool isThere() override { return call_() != 0; }
  bool block(std::int64_t real) override {
    const timespec moment = toTimespec(real < kMillisecond ? real : kMillisecond);
    NAO_REAL(nanosleep)(&moment, nullptr);
    return isThere();
  }

 private:
  Call call_;
};

pid_t awaitChild(pid_t child, int* status, int options, struct rusage* usage) {
  pid_t found = 0;
  int error = 0;
  auto once = [&] {
    found = NAO_REAL(wait4)(child, status, options | WNOHANG, usage);
    error = errno;
    return found;
  };
  if (options & WNOHANG) {
    look();
    return once();
  }
  Children<decltype(once)> children(once);
  if (waitFor(children, kNever) == Woken::Interrupted) {
    errno = EINTR;
    return -1;
  }
  errno = error;
  return found;
}

timeval toTimeval(std::int64_t ns) { return {ns / kSecond, ns % kSecond / kMicrosecond}; }
std::int64_t fromTimeval(const timeval& time) {
  return time.tv_sec * kSecond + time.tv_usec * kMicrosecond;
}

itimerval alarmOf(const Slot& slot) {
  const std::int64_t left = slot.alarm == kNever ? 0 : slot.alarm - pageNow();
  return {toTimeval(slot.alarm_interval), toTimeval(left > 0 ? left : 0)};
}

/// A child that is made without a copy of us takes the turns from its first moment.
template <class Call>
int spawn(pid_t* made, Call call) {
  Slot* slot = page() && taker() ? makeSlot() : nullptr;
  std::int32_t unborn = -::getpid();  // by this its parent's child knows its slot
  if (slot) slot->process = unborn;
  pid_t child = 0;
  const int error = call(&child);
  if (slot && error == 0) slot->process.compare_exchange_strong(unborn, child);
  if (slot && error != 0) dropSlot(*slot);
  if (made) *made = child;
  return error;
}

}  // namespace

NAO_INSTEAD pid_t vfork() noexcept {  // as fork(), which is allowed: the child would hold us up
  return ::fork();
}

NAO_INSTEAD int posix_spawn(pid_t* child, const char* path,
                            const posix_spawn_file_actions_t* actions,
                            const posix_spawnattr_t* attributes, char* const words[],
                            char* const variables[]) noexcept {
  return spawn(child, [&](pid_t* made) {
    return NAO_REAL_VERSION(posix_spawn, "GLIBC_2.15")(made, path, actions, attributes, words,
                                                       variables);
  });
}

NAO_INSTEAD int posix_spawnp(pid_t* child, const char* file,
                             const posix_spawn_file_actions_t* actions,
                             const posix_spawnattr_t* attributes, char* const words[],
                             char* const variables[]) noexcept {
  return spawn(child, [&](pid_t* made) {
    return NAO_REAL_VERSION(posix_spawnp, "GLIBC_2.15")(made, file, actions, attributes, words,
                                                        variables);
  });
}

// By calls that take turns; the C library's own would wait unseen.
NAO_INSTEAD int system(const char* command) {
  if (!page() || !command) return NAO_REAL(system)(command);
  sigset_t child_ended;
  sigset_t before;
  ::sigemptyset(&child_ended);
  ::sigaddset(&child_ended, SIGCHLD);
  ::pthread_sigmask(SIG_BLOCK, &child_ended, &before);
  const auto interrupt = ::signal(SIGINT, SIG_IGN);
  const auto quit = ::signal(SIGQUIT, SIG_IGN);
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGINT, interrupt);
    ::signal(SIGQUIT, quit);
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    ::execl("/bin/sh", "sh", "-c", command, nullptr);
    ::_exit(127);
  }
  int status = -1;
  while (child > 0 && ::wait4(child, &status, 0, nullptr) < 0 && errno == EINTR) {
  }
  ::signal(SIGINT, interrupt);
  ::signal(SIGQUIT, quit);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return status;
}

NAO_INSTEAD pid_t wait4(pid_t child, int* status, int options, struct rusage* usage) noexcept {
  if (!page()) return NAO_REAL(wait4)(child, status, options, usage);
  return awaitChild(child, status, options, usage);
}

NAO_INSTEAD pid_t waitpid(pid_t child, int* status, int options) {
  return wait4(child, status, options, nullptr);
}

NAO_INSTEAD pid_t wait(int* status) { return wait4(-1, status, 0, nullptr); }

NAO_INSTEAD pid_t wait3(int* status, int options, struct rusage* usage) noexcept {
  return wait4(-1, status, options, usage);
}

NAO_INSTEAD int waitid(idtype_t type, id_t id, siginfo_t* info, int options) {
  if (!page() || (options & WNOHANG)) return NAO_REAL(waitid)(type, id, info, options);
  int error = 0;
  auto once = [&] {
    if (info) info->si_pid = 0;
    const int result = NAO_REAL(waitid)(type, id, info, options | WNOHANG);
    error = result != 0 ? errno : 0;
    return result != 0 || (info && info->si_pid != 0) ? 1 : 0;
  };
  Children<decltype(once)> children(once);
  if (waitFor(children, kNever) == Woken::Interrupted) error = EINTR;
  errno = error;
  return error == 0 ? 0 : -1;
}

NAO_INSTEAD int setitimer(__itimer_which_t which, const itimerval* value,
                          itimerval* before) noexcept {
  Slot* slot = which == ITIMER_REAL && page() ? taker() : nullptr;
  if (!slot) return NAO_REAL(setitimer)(which, value, before);
  if (before) *before = alarmOf(*slot);
  const std::int64_t first = value ? fromTimeval(value->it_value) : 0;
  slot->alarm = first > 0 ? pageNow() + first : kNever;
  slot->alarm_interval = value ? fromTimeval(value->it_interval) : 0;
  return 0;
}

NAO_INSTEAD int getitimer(__itimer_which_t which, itimerval* value) noexcept {
  Slot* slot = which == ITIMER_REAL && page() ? taker() : nullptr;
  if (!slot) return NAO_REAL(getitimer)(which, value);
  *value = alarmOf(*slot);
  return 0;
}

NAO_INSTEAD unsigned alarm(unsigned seconds) noexcept {
  if (!page() || !taker()) return NAO_REAL(alarm)(seconds);
  const itimerval value{{0, 0}, {static_cast<time_t>(seconds), 0}};
  itimerval before{};
  ::setitimer(ITIMER_REAL, &value, &before);
  return static_cast<unsigned>(before.it_value.tv_sec + (before.it_value.tv_usec > 0 ? 1 : 0));
}

NAO_INSTEAD void _exit(int code) {
  leaveProcess();
  NAO_REAL(_exit)(code);
  __builtin_unreachable();
}

NAO_INSTEAD void _Exit(int code) noexcept { ::_exit(code); }
