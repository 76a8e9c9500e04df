#pragma once

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <ctime>

namespace nao::clock {

// By the kernel's own door: the C library's `syscall` is one of those we stand before.
inline long rawCall(long number, long a, long b, long c, long d) {
  long result = 0;
  register long r10 __asm__("r10") = d;
  __asm__ volatile("syscall"
                   : "=a"(result)
                   : "a"(number), "D"(a), "S"(b), "d"(c), "r"(r10)
                   : "rcx", "r11", "memory");
  return result;
}

/// Waits while the word is `seen`, `nanoseconds` at most. @return 0, or -EINTR, -ETIMEDOUT, -EAGAIN
inline long waitWhile(const std::atomic<std::uint32_t>& word, std::uint32_t seen,
                      std::int64_t nanoseconds) {
  const timespec time{nanoseconds / 1000000000, nanoseconds % 1000000000};
  return rawCall(SYS_futex, reinterpret_cast<long>(&word), FUTEX_WAIT, seen,
                 reinterpret_cast<long>(&time));
}

inline void ring(std::atomic<std::uint32_t>& word) {
  word.fetch_add(1);
  rawCall(SYS_futex, reinterpret_cast<long>(&word), FUTEX_WAKE, INT_MAX, 0);
}

}  // namespace nao::clock
