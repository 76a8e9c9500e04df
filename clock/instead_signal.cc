// Waiting for signals.
#include <signal.h>
#include <unistd.h>

#include <cerrno>

#include "clock/real.h"
#include "clock/turn.h"

using namespace nao::clock;

namespace {

/// Signals that have been sent and not been taken, asked without waiting.
class Sent final : public Waiting {
 public:
  explicit Sent(const sigset_t* set) : set_(set) {}
  bool isThere() override { return ask(0); }
  bool block(std::int64_t real) override { return ask(real); }
  const siginfo_t& info() const { return info_; }
  int number() const { return number_; }

 private:
  bool ask(std::int64_t real) {
    const timespec time = toTimespec(real);
    number_ = NAO_REAL(sigtimedwait)(set_, &info_, &time);
    return number_ > 0;
  }
  const sigset_t* set_;
  siginfo_t info_{};
  int number_ = 0;
};

int take(const sigset_t* set, siginfo_t* info, std::int64_t deadline) {
  Sent sent(set);
  const Woken woken = waitFor(sent, deadline);
  if (woken == Woken::Ready) {
    if (info) *info = sent.info();
    return sent.number();
  }
  errno = woken == Woken::Late ? EAGAIN : EINTR;
  return -1;
}

// With the thread's present mask, until a signal's handler has run, or may have.
int awaitHandler() {
  enterQueue(reinterpret_cast<const void*>(kSignals));
  waitInQueue(kNever);
  errno = EINTR;
  return -1;
}

bool anyPending(const sigset_t* mask) {
  sigset_t pending;
  ::sigpending(&pending);
  for (int signal = 1; signal < NSIG; ++signal)
    if (sigismember(&pending, signal) == 1 && sigismember(mask, signal) == 0) return true;
  return false;
}

}  // namespace

NAO_INSTEAD int pause() {
  if (!page() || !taker()) return NAO_REAL(pause)();
  return awaitHandler();
}

NAO_INSTEAD int sigsuspend(const sigset_t* mask) {
  if (!page() || !taker()) return NAO_REAL(sigsuspend)(mask);
  const bool at_once = anyPending(mask);
  sigset_t before;
  ::pthread_sigmask(SIG_SETMASK, mask, &before);
  if (!at_once) awaitHandler();
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = EINTR;
  return -1;
}

NAO_INSTEAD int sigtimedwait(const sigset_t* set, siginfo_t* info, const timespec* timeout) {
  if (!page()) return NAO_REAL(sigtimedwait)(set, info, timeout);
  return take(set, info, timeout ? pageNow() + fromTimespec(*timeout) : kNever);
}

NAO_INSTEAD int sigwaitinfo(const sigset_t* set, siginfo_t* info) {
  if (!page()) return NAO_REAL(sigwaitinfo)(set, info);
  return take(set, info, kNever);
}

NAO_INSTEAD int sigwait(const sigset_t* set, int* signal) {
  if (!page()) return NAO_REAL(sigwait)(set, signal);
  int number = -1;
  while (number < 0) number = take(set, nullptr, kNever);
  *signal = number;
  return 0;
}
