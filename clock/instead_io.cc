// Reading, writing and connecting.
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>

#include "clock/links.h"
#include "clock/real.h"
#include "clock/turn.h"

using namespace nao::clock;

namespace {

class Descriptor final : public Waiting {
 public:
  Descriptor(int descriptor, short events) : asked_{descriptor, events, 0} {}
  bool isThere() override { return ask(0); }
  bool block(std::int64_t real) override { return ask(static_cast<int>(real / kMillisecond) + 1); }

 private:
  bool ask(int milliseconds) { return NAO_REAL(poll)(&asked_, 1, milliseconds) > 0; }
  pollfd asked_;
};

bool blocks(int descriptor, int flags) {
  if (flags & MSG_DONTWAIT) return false;
  const int status = NAO_REAL(fcntl)(descriptor, F_GETFL);
  return status >= 0 && !(status & O_NONBLOCK);
}

// A socket's own patience. [ns]
std::int64_t patience(int descriptor, int which) {
  timeval time{};
  socklen_t size = sizeof time;
  if (::getsockopt(descriptor, SOL_SOCKET, which, &time, &size) != 0) return kNever;
  const std::int64_t span = time.tv_sec * kSecond + time.tv_usec * kMicrosecond;
  return span > 0 ? pageNow() + span : kNever;
}

/// Before a call that may block on a descriptor. @return 0 or an errno
int await(int descriptor, short events, int flags) {
  const int error = errno;
  if (!page()) return 0;
  if (!blocks(descriptor, flags)) {
    if (taker()) settleLinks();
    return 0;
  }
  Descriptor waiting(descriptor, events);
  if (waiting.isThere() && !taker()) return 0;
  const int which = events == POLLIN ? SO_RCVTIMEO : SO_SNDTIMEO;
  const Woken woken = waitFor(waiting, patience(descriptor, which));
  errno = error;
  return woken == Woken::Ready ? 0 : woken == Woken::Late ? EAGAIN : EINTR;
}

template <class Call>
ssize_t take(int descriptor, int flags, Call call) {
  if (const int error = await(descriptor, POLLIN, flags)) {
    errno = error;
    return -1;
  }
  const ssize_t bytes = call();
  if (bytes < 0 && errno == EAGAIN) {
    look();
    errno = EAGAIN;
  }
  if (!(flags & MSG_PEEK)) countTaken(descriptor, bytes);
  return bytes;
}

template <class Call>
ssize_t put(int descriptor, int flags, Call call) {
  if (const int error = await(descriptor, POLLOUT, flags)) {
    errno = error;
    return -1;
  }
  const ssize_t bytes = call();
  countSent(descriptor, bytes);
  return bytes;
}

}  // namespace

NAO_INSTEAD ssize_t read(int descriptor, void* data, std::size_t size) {
  return take(descriptor, 0, [&] { return NAO_REAL(read)(descriptor, data, size); });
}

NAO_INSTEAD ssize_t __read_chk(int descriptor, void* data, std::size_t size, std::size_t) {
  return read(descriptor, data, size);
}

NAO_INSTEAD ssize_t readv(int descriptor, const iovec* parts, int count) {
  return take(descriptor, 0, [&] { return NAO_REAL(readv)(descriptor, parts, count); });
}

NAO_INSTEAD ssize_t recv(int descriptor, void* data, std::size_t size, int flags) {
  return take(descriptor, flags, [&] { return NAO_REAL(recv)(descriptor, data, size, flags); });
}

NAO_INSTEAD ssize_t __recv_chk(int descriptor, void* data, std::size_t size, std::size_t,
                               int flags) {
  return recv(descriptor, data, size, flags);
}

NAO_INSTEAD ssize_t recvfrom(int descriptor, void* __restrict data, std::size_t size, int flags,
                             sockaddr* __restrict from, socklen_t* __restrict length) {
  return take(descriptor, flags,
              [&] { return NAO_REAL(recvfrom)(descriptor, data, size, flags, from, length); });
}

NAO_INSTEAD ssize_t __recvfrom_chk(int descriptor, void* __restrict data, std::size_t size,
                                   std::size_t, int flags, sockaddr* __restrict from,
                                   socklen_t* __restrict length) {
  return recvfrom(descriptor, data, size, flags, from, length);
}

NAO_INSTEAD ssize_t recvmsg(int descriptor, msghdr* message, int flags) {
  return take(descriptor, flags, [&] { return NAO_REAL(recvmsg)(descriptor, message, flags); });
}

NAO_INSTEAD ssize_t write(int descriptor, const void* data, std::size_t size) {
  return put(descriptor, 0, [&] { return NAO_REAL(write)(descriptor, data, size); });
}

NAO_INSTEAD ssize_t writev(int descriptor, const iovec* parts, int count) {
  return put(descriptor, 0, [&] { return NAO_REAL(writev)(descriptor, parts, count); });
}

NAO_INSTEAD ssize_t send(int descriptor, const void* data, std::size_t size, int flags) {
  return put(descriptor, flags, [&] { return NAO_REAL(send)(descriptor, data, size, flags); });
}

NAO_INSTEAD ssize_t sendto(int descriptor, const void* data, std::size_t size, int flags,
                           const sockaddr* to, socklen_t length) {
  return put(descriptor, flags,
             [&] { return NAO_REAL(sendto)(descriptor, data, size, flags, to, length); });
}

NAO_INSTEAD ssize_t sendmsg(int descriptor, const msghdr* message, int flags) {
  return put(descriptor, flags, [&] { return NAO_REAL(sendmsg)(descriptor, message, flags); });
}

NAO_INSTEAD int accept(int descriptor, sockaddr* __restrict from, socklen_t* __restrict length) {
  return static_cast<int>(
      take(descriptor, 0, [&] { return NAO_REAL(accept)(descriptor, from, length); }));
}

NAO_INSTEAD int accept4(int descriptor, sockaddr* __restrict from, socklen_t* __restrict length,
                        int flags) {
  return static_cast<int>(
      take(descriptor, 0, [&] { return NAO_REAL(accept4)(descriptor, from, length, flags); }));
}

NAO_INSTEAD int connect(int descriptor, const sockaddr* to, socklen_t length) {
  const int result = NAO_REAL(connect)(descriptor, to, length);
  if (!page()) return result;
  const int error = errno;
  if (result != 0 && error != EINPROGRESS) return result;
  if (result != 0) {  // on this machine it is there at once, or was refused at once
    pollfd asked{descriptor, POLLOUT, 0};
    NAO_REAL(poll)(&asked, 1, 1000);
  }
  openLink(descriptor);
  errno = error;
  return result;
}

NAO_INSTEAD int close(int descriptor) {
  if (page()) closeLink(descriptor);
  return NAO_REAL(close)(descriptor);
}

NAO_INSTEAD int dup(int descriptor) noexcept {
  const int copy = NAO_REAL(dup)(descriptor);
  if (page() && copy >= 0) copyLink(descriptor, copy);
  return copy;
}

NAO_INSTEAD int dup2(int descriptor, int copy) noexcept {
  const int result = NAO_REAL(dup2)(descriptor, copy);
  if (page() && result >= 0 && descriptor != copy) copyLink(descriptor, copy);
  return result;
}

NAO_INSTEAD int dup3(int descriptor, int copy, int flags) noexcept {
  const int result = NAO_REAL(dup3)(descriptor, copy, flags);
  if (page() && result >= 0) copyLink(descriptor, copy);
  return result;
}
