#pragma once

#include <cstddef>

namespace nao::validation {

/// Processor time [s] that this thread has used: what a computation costs, however loaded the
/// machine is. For measuring costs alone; nothing simulated may depend on it.
double threadCpuSeconds();

/// Memory [bytes] of this process that is in RAM now, but what it has freed.
std::size_t residentMemory();

}  // namespace nao::validation
