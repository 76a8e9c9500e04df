#include "daemon/descriptor_limit.h"

#include <sys/resource.h>

#include <algorithm>

namespace nao::daemon {

void raiseDescriptorLimit() {
  constexpr rlim_t kEnough = 65536;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= kEnough) return;
  limit.rlim_cur = std::min(kEnough, limit.rlim_max);
  setrlimit(RLIMIT_NOFILE, &limit);  // if refused, fewer clients at once; accept() says so
}

}  // namespace nao::daemon
