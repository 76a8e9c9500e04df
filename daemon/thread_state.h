#pragma once

#include <cstdint>

namespace nao::daemon {

/// What the system says of other processes and their threads.

/// Whether it runs: not ended, nor only waiting to be asked for its end.
bool isAlive(std::int32_t process);

/// The thread's processor time until now, 0 if there is none. [s]
double processorTime(std::int32_t process, std::int32_t thread);

/// Whether the thread waits for something.
bool isAsleep(std::int32_t process, std::int32_t thread);

}  // namespace nao::daemon
