// Conditions, locks and semaphores.
#include <pthread.h>
#include <semaphore.h>

#include <cerrno>

#include "clock/real.h"
#include "clock/turn.h"

using namespace nao::clock;

namespace {

constexpr char kConditions[] = "GLIBC_2.3.2";  // of today's pthread_cond_t

const timespec kLongAgo{0, 0};

template <class Try>
class Trying final : public Waiting {
 public:
  explicit Trying(Try attempt) : attempt_(attempt) {}
  bool isThere() override { return attempt_(); }
  bool block(std::int64_t) override {
    const timespec moment{0, 200000};
    NAO_REAL(nanosleep)(&moment, nullptr);
    return attempt_();
  }

 private:
  Try attempt_;
};

/// Tries to get it until the deadline; `attempt` returns 0, an errno, or EBUSY for not yet.
template <class Attempt>
int getBy(std::int64_t deadline, Attempt attempt) {
  int error = EBUSY;
  auto once = [&] {
    error = attempt();
    return error != EBUSY;
  };
  Trying<decltype(once)> trying(once);
  while (waitFor(trying, deadline) == Woken::Interrupted) {
  }
  return error == EBUSY ? ETIMEDOUT : error;
}

// A lock that is not free at once may be one that its owner asks for again, which is an error.
int tryMutex(pthread_mutex_t* mutex) {
  const int error = NAO_REAL(pthread_mutex_trylock)(mutex);
  if (error != EBUSY) return error;
  const int why = NAO_REAL(pthread_mutex_timedlock)(mutex, &kLongAgo);
  return why == ETIMEDOUT ? EBUSY : why;
}

int lock(pthread_mutex_t* mutex, std::int64_t deadline) {
  return getBy(deadline, [mutex] { return tryMutex(mutex); });
}

int wait(pthread_cond_t* condition, pthread_mutex_t* mutex, std::int64_t deadline) {
  enterQueue(condition);
  const int error = ::pthread_mutex_unlock(mutex);
  if (error != 0) return error;
  const Woken woken = waitInQueue(deadline);
  const int locked = lock(mutex, kNever);
  if (locked != 0) return locked;
  return woken == Woken::Late ? ETIMEDOUT : 0;
}

// Waits really, a little at a time: who waits looks again in any case.
int waitFollowing(pthread_cond_t* condition, pthread_mutex_t* mutex, std::int64_t deadline) {
  const std::int64_t now = pageNow();
  if (now >= deadline) return ETIMEDOUT;
  timespec until{};
  NAO_REAL(clock_gettime)(CLOCK_MONOTONIC, &until);
  const std::int64_t chunk = realSpan(deadline - now);
  until = toTimespec(fromTimespec(until) + chunk);
  const int error = NAO_REAL_VERSION(pthread_cond_clockwait, "GLIBC_2.30")(condition, mutex,
                                                                           CLOCK_MONOTONIC, &until);
  return error == ETIMEDOUT && pageNow() < deadline ? 0 : error;
}

// As long as was asked for, of the wall's time.
int waitReally(pthread_cond_t* condition, pthread_mutex_t* mutex, std::int64_t span) {
  timespec until{};
  NAO_REAL(clock_gettime)(CLOCK_MONOTONIC, &until);
  until = toTimespec(fromTimespec(until) + (span > 0 ? span : 0));
  return NAO_REAL_VERSION(pthread_cond_clockwait, "GLIBC_2.30")(condition, mutex, CLOCK_MONOTONIC,
                                                                &until);
}

// Who has the interpreter's lock lets go of it when it next waits, and needs its turn for that.
// Whoever wants it looks again in any case.
int waitForInterpreter(pthread_cond_t* condition, pthread_mutex_t* mutex, std::int64_t deadline) {
  if (!taker()) return waitReally(condition, mutex, deadline - pageNow());
  if (anyBeside()) return waitReally(condition, mutex, 5 * kMillisecond);  // it may have the lock
  NAO_REAL(pthread_mutex_unlock)(mutex);
  letOthers();
  return NAO_REAL(pthread_mutex_lock)(mutex);
}

int timedWait(pthread_cond_t* condition, pthread_mutex_t* mutex, std::int64_t deadline,
              const void* caller) {
  if (isInterpreter(caller)) return waitForInterpreter(condition, mutex, deadline);
  if (taker()) return wait(condition, mutex, deadline);
  return waitFollowing(condition, mutex, deadline);
}

// The clock that a condition's deadlines are on, as the C library keeps it.
clockid_t clockOf(const pthread_cond_t* condition) {
  return (condition->__data.__wrefs & 2U) != 0 ? CLOCK_MONOTONIC : CLOCK_REALTIME;
}

int trySemaphore(sem_t* semaphore) {
  if (NAO_REAL(sem_trywait)(semaphore) == 0) return 0;
  return errno == EAGAIN ? EBUSY : errno;
}

int takeSemaphore(sem_t* semaphore, std::int64_t deadline) {
  int error = EBUSY;
  auto once = [&] {
    error = trySemaphore(semaphore);
    return error != EBUSY;
  };
  Trying<decltype(once)> trying(once);
  const Woken woken = waitFor(trying, deadline);
  if (woken == Woken::Ready && error == 0) return 0;
  errno = woken == Woken::Ready ? error : woken == Woken::Late ? ETIMEDOUT : EINTR;
  return -1;
}

}  // namespace

NAO_INSTEAD int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  const int error = NAO_REAL(pthread_mutex_trylock)(mutex);
  if (error != EBUSY) return error;
  if (!page() || isInterpreter(__builtin_return_address(0)) || !taker())
    return NAO_REAL(pthread_mutex_lock)(mutex);
  return lock(mutex, kNever);
}

NAO_INSTEAD int pthread_mutex_timedlock(pthread_mutex_t* mutex, const timespec* time) noexcept {
  if (!page()) return NAO_REAL(pthread_mutex_timedlock)(mutex, time);
  return lock(mutex, fromClock(CLOCK_REALTIME, *time));
}

NAO_INSTEAD int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock,
                                        const timespec* time) noexcept {
  if (!page()) return NAO_REAL(pthread_mutex_clocklock)(mutex, clock, time);
  return lock(mutex, fromClock(clock, *time));
}

NAO_INSTEAD int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  if (!page() || !taker()) return NAO_REAL(pthread_rwlock_rdlock)(lock);
  return getBy(kNever, [lock] { return NAO_REAL(pthread_rwlock_tryrdlock)(lock); });
}

NAO_INSTEAD int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  if (!page() || !taker()) return NAO_REAL(pthread_rwlock_wrlock)(lock);
  return getBy(kNever, [lock] { return NAO_REAL(pthread_rwlock_trywrlock)(lock); });
}

NAO_INSTEAD int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  if (!page() || isInterpreter(__builtin_return_address(0)) || !taker())
    return NAO_REAL_VERSION(pthread_cond_wait, kConditions)(condition, mutex);
  return wait(condition, mutex, kNever);
}

NAO_INSTEAD int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                       const timespec* time) {
  if (!page()) return NAO_REAL_VERSION(pthread_cond_timedwait, kConditions)(condition, mutex, time);
  return timedWait(condition, mutex, fromClock(clockOf(condition), *time),
                   __builtin_return_address(0));
}

NAO_INSTEAD int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                       clockid_t clock, const timespec* time) {
  if (!page())
    return NAO_REAL_VERSION(pthread_cond_clockwait, "GLIBC_2.30")(condition, mutex, clock, time);
  return timedWait(condition, mutex, fromClock(clock, *time), __builtin_return_address(0));
}

NAO_INSTEAD int pthread_cond_signal(pthread_cond_t* condition) noexcept {
  if (page() && taker() && signalQueue(condition, false) > 0) return 0;
  return NAO_REAL_VERSION(pthread_cond_signal, kConditions)(condition);
}

NAO_INSTEAD int pthread_cond_broadcast(pthread_cond_t* condition) noexcept {
  if (page() && taker()) signalQueue(condition, true);
  return NAO_REAL_VERSION(pthread_cond_broadcast, kConditions)(condition);
}

NAO_INSTEAD int sem_wait(sem_t* semaphore) {
  if (!page() || !taker()) return NAO_REAL(sem_wait)(semaphore);
  return takeSemaphore(semaphore, kNever);
}

NAO_INSTEAD int sem_timedwait(sem_t* __restrict semaphore, const timespec* __restrict time) {
  if (!page()) return NAO_REAL(sem_timedwait)(semaphore, time);
  return takeSemaphore(semaphore, fromClock(CLOCK_REALTIME, *time));
}

NAO_INSTEAD int sem_clockwait(sem_t* __restrict semaphore, clockid_t clock,
                              const timespec* __restrict time) {
  if (!page()) return NAO_REAL(sem_clockwait)(semaphore, clock, time);
  return takeSemaphore(semaphore, fromClock(clock, *time));
}

NAO_INSTEAD int sem_trywait(sem_t* semaphore) noexcept {
  const int result = NAO_REAL(sem_trywait)(semaphore);
  if (result == 0 || !page()) return result;
  look();
  errno = EAGAIN;
  return result;
}
