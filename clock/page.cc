#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

#include "clock/futex.h"
#include "clock/real.h"
#include "clock/turn.h"

namespace nao::clock {
namespace {

ClockPage* mapped = nullptr;
bool looked_for = false;

ClockPage* map() {
  const char* path = std::getenv(kPageVariable);
  if (!path || !*path) return nullptr;
  const int file = NAO_REAL(open)(path, O_RDWR | O_CLOEXEC);
  if (file < 0) return nullptr;
  void* at = ::mmap(nullptr, sizeof(ClockPage), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  NAO_REAL(close)(file);
  if (at == MAP_FAILED) return nullptr;
  auto* page = static_cast<ClockPage*>(at);
  return page->magic == kMagic ? page : nullptr;
}

std::int64_t realMonotonic() {
  timespec time{};
  rawCall(SYS_clock_gettime, CLOCK_MONOTONIC, reinterpret_cast<long>(&time), 0, 0);
  return fromTimespec(time);
}

struct Range {
  std::uintptr_t from = 0, to = 0;
};

// The extent of the loaded file that `data` points into.
int findRange(dl_phdr_info* info, std::size_t, void* data) {
  auto& range = *static_cast<Range*>(data);
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const auto& part = info->dlpi_phdr[i];
    const std::uintptr_t start = info->dlpi_addr + part.p_vaddr;
    if (part.p_type != PT_LOAD || !(part.p_flags & PF_X)) continue;
    if (range.from < start || range.from >= start + part.p_memsz) continue;
    range = {start, start + part.p_memsz};
    return 1;
  }
  return 0;
}

}  // namespace

ClockPage* page() {
  if (!looked_for) {
    looked_for = true;
    mapped = map();
  }
  return mapped;
}

std::int64_t pageNow() {
  const std::int64_t stopped = mapped->stopped.load();
  return mapped->now.load() + (stopped ? realMonotonic() - stopped : 0);
}

std::int64_t realSpan(std::int64_t span) {
  const double speed = mapped->speed.load();
  if (std::isinf(speed) || speed <= 0) return kMillisecond;
  const double real = static_cast<double>(span) / speed;
  return real > 5e6 ? 5 * kMillisecond : static_cast<std::int64_t>(real) + 1;
}

bool isSimulated(clockid_t clock) {
  switch (clock) {
    case CLOCK_REALTIME:
    case CLOCK_REALTIME_COARSE:
    case CLOCK_TAI:
    case CLOCK_MONOTONIC:
    case CLOCK_MONOTONIC_RAW:
    case CLOCK_MONOTONIC_COARSE:
    case CLOCK_BOOTTIME:
    case CLOCK_PROCESS_CPUTIME_ID:
    case CLOCK_THREAD_CPUTIME_ID:
      return true;
    default:
      return false;
  }
}

timespec toTimespec(std::int64_t ns) { return {ns / kSecond, ns % kSecond}; }

std::int64_t fromTimespec(const timespec& time) {
  constexpr std::int64_t kMost = kNever / kSecond - 1;
  if (time.tv_sec >= kMost) return kNever;
  return time.tv_sec * kSecond + time.tv_nsec;
}

std::int64_t onClock(clockid_t clock, std::int64_t now) {
  switch (clock) {
    case CLOCK_REALTIME:
    case CLOCK_REALTIME_COARSE:
    case CLOCK_TAI:
      return mapped->epoch + now;
    case CLOCK_PROCESS_CPUTIME_ID:
    case CLOCK_THREAD_CPUTIME_ID:
      return now;
    default:
      return kMonotonicStart + now;
  }
}

std::int64_t fromClock(clockid_t clock, const timespec& time) {
  const std::int64_t at = fromTimespec(time);
  return at == kNever ? kNever : at - onClock(clock, 0);
}

bool isInterpreter(const void* address) {
  static Range range;
  static bool known = false;
  if (!known) {
    void* const begin = ::dlsym(RTLD_DEFAULT, "Py_BytesMain");
    known = true;
    range.from = reinterpret_cast<std::uintptr_t>(begin);
    if (!begin || !::dl_iterate_phdr(findRange, &range)) range = {};
  }
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  return at >= range.from && at < range.to;
}

}  // namespace nao::clock
