// Threads: who is made, who ends, who waits for whom; and futexes, which some use by themselves.
#include <dlfcn.h>
#include <linux/futex.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdlib>

#include "clock/real.h"
#include "clock/turn.h"

using namespace nao::clock;

namespace {

struct Beginning {
  void* (*what)(void*);
  void* with;
  Slot* slot;
};

pthread_key_t at_end;
pthread_once_t at_end_made = PTHREAD_ONCE_INIT;

void makeKey() {
  ::pthread_key_create(&at_end, [](void*) { nao::clock::end(); });
}

void* startThread(void* data) {
  const Beginning beginning = *static_cast<Beginning*>(data);
  std::free(data);
  ::pthread_setspecific(at_end, beginning.slot);  // end() comes however the thread ends
  begin(*beginning.slot);
  return beginning.what(beginning.with);
}

// A Python program's threads change places where they wait, and only there.
void calmInterpreter() {
  using Set = void (*)(unsigned long microseconds);
  static auto set = reinterpret_cast<Set>(::dlsym(RTLD_DEFAULT, "_PyEval_SetSwitchInterval"));
  if (set) set(10'000'000);
}

bool isDetached(const pthread_attr_t* attributes) {
  int state = PTHREAD_CREATE_JOINABLE;
  if (attributes) ::pthread_attr_getdetachstate(attributes, &state);
  return state == PTHREAD_CREATE_DETACHED;
}

class Ending final : public Waiting {
 public:
  explicit Ending(Slot& slot) : slot_(slot) {}
  bool isThere() override {
    const SlotState state = slot_.state.load();
    return state == SlotState::Ended || state == SlotState::Free;
  }
  bool block(std::int64_t) override { return isThere(); }

 private:
  Slot& slot_;
};

/// Until the thread has ended as far as turns go. @return 0 or ETIMEDOUT
int awaitEnd(pthread_t thread, std::int64_t deadline) {
  Slot* slot = taker() ? findThread(static_cast<std::uint64_t>(thread)) : nullptr;
  if (!slot) return 0;
  Ending ending(*slot);
  Woken woken = Woken::Interrupted;
  while (woken == Woken::Interrupted) woken = waitFor(ending, deadline);
  if (woken == Woken::Late) return ETIMEDOUT;
  dropSlot(*slot);
  return 0;
}

long waitFutex(const int* word, int seen, std::int64_t deadline) {
  if (__atomic_load_n(word, __ATOMIC_SEQ_CST) != seen) {
    errno = EAGAIN;
    return -1;
  }
  enterQueue(word);
  const Woken woken = waitInQueue(deadline);
  if (woken == Woken::Ready) return 0;
  errno = woken == Woken::Late ? ETIMEDOUT : EINTR;
  return -1;
}

std::int64_t futexDeadline(int operation, const timespec* time) {
  if (!time) return kNever;
  if ((operation & FUTEX_CMD_MASK) == FUTEX_WAIT) return pageNow() + fromTimespec(*time);
  const bool real = (operation & FUTEX_CLOCK_REALTIME) != 0;
  return fromClock(real ? CLOCK_REALTIME : CLOCK_MONOTONIC, *time);
}

}  // namespace

NAO_INSTEAD int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                               void* (*what)(void*), void* with) noexcept {
  const auto create = NAO_REAL_VERSION(pthread_create, "GLIBC_2.34");
  if (!page() || !taker()) return create(thread, attributes, what, with);
  if (isInterpreter(__builtin_return_address(0))) calmInterpreter();
  ::pthread_once(&at_end_made, makeKey);
  Slot* slot = makeSlot();
  if (!slot) return create(thread, attributes, what, with);
  slot->detached = isDetached(attributes) ? 1 : 0;
  auto* beginning = static_cast<Beginning*>(std::malloc(sizeof(Beginning)));
  *beginning = {what, with, slot};
  pthread_t made{};
  const int error = create(&made, attributes, startThread, beginning);
  if (error == 0) {
    slot->handle = static_cast<std::uint64_t>(made);
    *thread = made;
    return 0;
  }
  std::free(beginning);
  dropSlot(*slot);
  return error;
}

NAO_INSTEAD int pthread_join(pthread_t thread, void** result) {
  if (page()) awaitEnd(thread, kNever);
  return NAO_REAL_VERSION(pthread_join, "GLIBC_2.34")(thread, result);
}

NAO_INSTEAD int pthread_timedjoin_np(pthread_t thread, void** result, const timespec* time) {
  if (!page()) return NAO_REAL(pthread_timedjoin_np)(thread, result, time);
  if (awaitEnd(thread, fromClock(CLOCK_REALTIME, *time)) != 0) return ETIMEDOUT;
  return NAO_REAL(pthread_join)(thread, result);
}

NAO_INSTEAD int pthread_detach(pthread_t thread) noexcept {
  Slot* slot = page() && taker() ? findThread(static_cast<std::uint64_t>(thread)) : nullptr;
  if (slot && slot->state.load() == SlotState::Ended) dropSlot(*slot);
  if (slot) slot->detached = 1;
  return NAO_REAL(pthread_detach)(thread);
}

NAO_INSTEAD long syscall(long number, ...) noexcept {
  va_list list;
  va_start(list, number);
  long a[6];
  for (long& argument : a) argument = va_arg(list, long);
  va_end(list);
  const auto real = reinterpret_cast<long (*)(long, ...)>(findReal("syscall", nullptr));
  if (number != SYS_futex || !page() || !taker())
    return real(number, a[0], a[1], a[2], a[3], a[4], a[5]);
  const int operation = static_cast<int>(a[1]);
  const int kind = operation & FUTEX_CMD_MASK;
  auto* word = reinterpret_cast<int*>(a[0]);
  if (kind == FUTEX_WAIT || kind == FUTEX_WAIT_BITSET) {
    return waitFutex(word, static_cast<int>(a[2]),
                     futexDeadline(operation, reinterpret_cast<const timespec*>(a[3])));
  }
  if (kind != FUTEX_WAKE && kind != FUTEX_WAKE_BITSET)
    return real(number, a[0], a[1], a[2], a[3], a[4], a[5]);
  int woken = 0;
  while (woken < static_cast<int>(a[2]) && signalQueue(word, false) > 0) ++woken;
  const long others = real(number, a[0], a[1], a[2], a[3], a[4], a[5]);
  return woken + (others > 0 ? others : 0);
}
