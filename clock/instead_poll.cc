// Waiting for descriptors: poll, select and epoll.
#include <poll.h>
#include <sys/epoll.h>
#include <sys/select.h>

#include <cerrno>
#include <csignal>

#include "clock/futex.h"
#include "clock/real.h"
#include "clock/turn.h"

using namespace nao::clock;

namespace {

// [ns] page time
std::int64_t deadlineIn(std::int64_t span) {
  return span < 0 || span == kNever ? kNever : pageNow() + span;
}

/// A call that can be asked with a timeout in milliseconds: what it returns, and its errno.
template <class Call>
class Asking final : public Waiting {
 public:
  explicit Asking(Call call) : call_(call) {}
  bool isThere() override { return ask(0); }
  bool block(std::int64_t real) override {
    return ask(static_cast<int>((real + kMillisecond - 1) / kMillisecond));
  }
  int result() const {
    errno = error_;
    return result_;
  }

 private:
  bool ask(int milliseconds) {
    result_ = call_(milliseconds);
    error_ = errno;
    return result_ > 0 || (result_ < 0 && error_ != EINTR);
  }
  Call call_;
  int result_ = 0;
  int error_ = 0;
};

/// `span` [ns]; negative: for ever.
template <class Call>
int askFor(Call call, std::int64_t span) {
  Asking<Call> asking(call);
  if (span == 0) look();
  const Woken woken = waitFor(asking, deadlineIn(span));
  if (woken == Woken::Ready) return asking.result();
  if (woken == Woken::Late) return 0;
  errno = EINTR;
  return -1;
}

std::int64_t fromMilliseconds(int timeout) { return timeout < 0 ? -1 : timeout * kMillisecond; }

/// Signals that are let in while a call waits.
class Letting {
 public:
  explicit Letting(const sigset_t* mask) : set_(mask != nullptr) {
    if (set_) ::pthread_sigmask(SIG_SETMASK, mask, &before_);
  }
  ~Letting() {
    const int error = errno;
    if (set_) ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = error;
  }
  Letting(const Letting&) = delete;
  Letting& operator=(const Letting&) = delete;

 private:
  bool set_;
  sigset_t before_{};
};

struct Sets {
  fd_set* given[3];
  fd_set wanted[3];

  Sets(fd_set* read, fd_set* write, fd_set* except) : given{read, write, except}, wanted{} {
    for (int i = 0; i < 3; ++i)
      if (given[i]) wanted[i] = *given[i];
  }
  void restore() {
    for (int i = 0; i < 3; ++i)
      if (given[i]) *given[i] = wanted[i];
  }
  void clear() {
    for (fd_set* set : given)
      if (set) FD_ZERO(set);
  }
};

int selectFor(int count, Sets& sets, std::int64_t span) {
  const int result = askFor(
      [&](int milliseconds) {
        sets.restore();
        timeval time{milliseconds / 1000, milliseconds % 1000 * 1000};
        return NAO_REAL(select)(count, sets.given[0], sets.given[1], sets.given[2], &time);
      },
      span);
  if (result == 0) sets.clear();
  return result;
}

}  // namespace

NAO_INSTEAD int poll(pollfd* descriptors, nfds_t count, int timeout) {
  if (!page()) return NAO_REAL(poll)(descriptors, count, timeout);
  return askFor([&](int ms) { return NAO_REAL(poll)(descriptors, count, ms); },
                fromMilliseconds(timeout));
}

NAO_INSTEAD int __poll_chk(pollfd* descriptors, nfds_t count, int timeout, std::size_t) {
  return poll(descriptors, count, timeout);
}

NAO_INSTEAD int ppoll(pollfd* descriptors, nfds_t count, const timespec* timeout,
                      const sigset_t* mask) {
  if (!page()) return NAO_REAL(ppoll)(descriptors, count, timeout, mask);
  const Letting letting(mask);
  return askFor([&](int ms) { return NAO_REAL(poll)(descriptors, count, ms); },
                timeout ? fromTimespec(*timeout) : -1);
}

NAO_INSTEAD int __ppoll_chk(pollfd* descriptors, nfds_t count, const timespec* timeout,
                            const sigset_t* mask, std::size_t) {
  return ppoll(descriptors, count, timeout, mask);
}

NAO_INSTEAD int select(int count, fd_set* read, fd_set* write, fd_set* except, timeval* timeout) {
  if (!page()) return NAO_REAL(select)(count, read, write, except, timeout);
  Sets sets(read, write, except);
  const std::int64_t span =
      timeout ? timeout->tv_sec * kSecond + timeout->tv_usec * kMicrosecond : -1;
  return selectFor(count, sets, span);
}

NAO_INSTEAD int pselect(int count, fd_set* read, fd_set* write, fd_set* except,
                        const timespec* timeout, const sigset_t* mask) {
  if (!page()) return NAO_REAL(pselect)(count, read, write, except, timeout, mask);
  const Letting letting(mask);
  Sets sets(read, write, except);
  return selectFor(count, sets, timeout ? fromTimespec(*timeout) : -1);
}

NAO_INSTEAD int epoll_wait(int epoll, epoll_event* events, int most, int timeout) {
  if (!page()) return NAO_REAL(epoll_wait)(epoll, events, most, timeout);
  return askFor([&](int ms) { return NAO_REAL(epoll_wait)(epoll, events, most, ms); },
                fromMilliseconds(timeout));
}

NAO_INSTEAD int epoll_pwait(int epoll, epoll_event* events, int most, int timeout,
                            const sigset_t* mask) {
  if (!page()) return NAO_REAL(epoll_pwait)(epoll, events, most, timeout, mask);
  const Letting letting(mask);
  return epoll_wait(epoll, events, most, timeout);
}

NAO_INSTEAD int epoll_pwait2(int epoll, epoll_event* events, int most, const timespec* timeout,
                             const sigset_t* mask) {
  if (!page()) return NAO_REAL(epoll_pwait2)(epoll, events, most, timeout, mask);
  const Letting letting(mask);
  return askFor([&](int ms) { return NAO_REAL(epoll_wait)(epoll, events, most, ms); },
                timeout ? fromTimespec(*timeout) : -1);
}
