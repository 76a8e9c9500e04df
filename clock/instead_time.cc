// Clocks and sleeps.
#include <sched.h>
#include <sys/time.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

#include "clock/real.h"
#include "clock/turn.h"

using namespace nao::clock;

namespace {

// What a program reads from a clock. [ns]
std::int64_t read(clockid_t clock) {
  look();
  return onClock(clock, pageNow());
}

// @return 0 or an errno
int sleepFor(std::int64_t span, timespec* rest) {
  if (span <= 0) {
    yieldTurn();
    return 0;
  }
  const std::int64_t deadline = pageNow() + span;
  if (sleepUntil(deadline) != Woken::Interrupted) return 0;
  const std::int64_t left = deadline - pageNow();
  if (rest) *rest = toTimespec(left > 0 ? left : 0);
  return EINTR;
}

bool isSpan(const timespec* time) {
  return time && time->tv_sec >= 0 && time->tv_nsec >= 0 && time->tv_nsec < kSecond;
}

}  // namespace

NAO_INSTEAD int clock_gettime(clockid_t clock, timespec* time) noexcept {
  if (!page() || !isSimulated(clock)) return NAO_REAL(clock_gettime)(clock, time);
  *time = toTimespec(read(clock));
  return 0;
}

NAO_INSTEAD int gettimeofday(timeval* __restrict time, void* __restrict zone) noexcept {
  if (!page()) return NAO_REAL(gettimeofday)(time, zone);
  const std::int64_t now = read(CLOCK_REALTIME);
  *time = {now / kSecond, now % kSecond / kMicrosecond};
  return 0;
}

NAO_INSTEAD time_t time(time_t* result) noexcept {
  if (!page()) return NAO_REAL(time)(result);
  const time_t now = read(CLOCK_REALTIME) / kSecond;
  if (result) *result = now;
  return now;
}

NAO_INSTEAD int timespec_get(timespec* time, int base) noexcept {
  if (!page() || base != TIME_UTC) return NAO_REAL(timespec_get)(time, base);
  *time = toTimespec(read(CLOCK_REALTIME));
  return base;
}

NAO_INSTEAD clock_t clock() noexcept {
  if (!page()) return NAO_REAL(clock)();
  return read(CLOCK_PROCESS_CPUTIME_ID) / (kSecond / CLOCKS_PER_SEC);
}

NAO_INSTEAD int nanosleep(const timespec* span, timespec* rest) {
  if (!page() || !isSpan(span)) return NAO_REAL(nanosleep)(span, rest);
  const int error = sleepFor(fromTimespec(*span), rest);
  if (error == 0) return 0;
  errno = error;
  return -1;
}

NAO_INSTEAD int clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec* rest) {
  if (!page() || !isSimulated(clock) || !isSpan(time))
    return NAO_REAL_VERSION(clock_nanosleep, "GLIBC_2.17")(clock, flags, time, rest);
  if (!(flags & TIMER_ABSTIME)) return sleepFor(fromTimespec(*time), rest);
  const std::int64_t deadline = fromClock(clock, *time);
  if (deadline <= pageNow()) return sleepFor(0, nullptr);
  return sleepUntil(deadline) == Woken::Interrupted ? EINTR : 0;
}

NAO_INSTEAD int usleep(useconds_t microseconds) {
  if (!page()) return NAO_REAL(usleep)(microseconds);
  const int error = sleepFor(microseconds * kMicrosecond, nullptr);
  if (error == 0) return 0;
  errno = error;
  return -1;
}

NAO_INSTEAD unsigned sleep(unsigned seconds) {
  if (!page()) return NAO_REAL(sleep)(seconds);
  timespec rest{};
  if (sleepFor(seconds * kSecond, &rest) == 0) return 0;
  return static_cast<unsigned>(rest.tv_sec + (rest.tv_nsec > 0 ? 1 : 0));
}

NAO_INSTEAD int sched_yield() noexcept {
  if (page()) yieldTurn();
  return NAO_REAL(sched_yield)();
}

NAO_INSTEAD int timerfd_create(int clock, int flags) noexcept {
  if (!page()) return NAO_REAL(timerfd_create)(clock, flags);
  errno = EINVAL;  // Boost.Asio, for one, then uses the timeouts of epoll_wait
  return -1;
}
