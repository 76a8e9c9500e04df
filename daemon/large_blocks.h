#pragma once

#include <malloc.h>

namespace nao::daemon {

/// Lets this process keep the memory of large blocks that come and go, up to 64 MiB. A picture's
/// answer of 600 KB otherwise is new pages from the system each time, which cost ten times what
/// sending it costs. Call once, at the start.
inline void keepLargeBlocks() {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

}  // namespace nao::daemon
