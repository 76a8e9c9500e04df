#include "validation/process.h"

#include <malloc.h>
#include <unistd.h>

#include <ctime>
#include <fstream>

namespace nao::validation {

double threadCpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::size_t residentMemory() {
  malloc_trim(0);  // back to the system, or what comes next hides in it
  std::size_t total = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace nao::validation
