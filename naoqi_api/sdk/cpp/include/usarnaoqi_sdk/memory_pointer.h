#pragma once

#include <alcommon/alproxy.h>
#include <usarnaoqi_sdk/export.h>

#include <string>

namespace AL {
namespace detail {

/// The 32 bits of a key's int or float, in a local module: read anew at the beginning of each
/// cycle, before what is connected to the DCM's loop. What the module writes there is in ALMemory
/// from the next cycle on. Not for two threads at once. It stays as long as the process; a key has
/// one.
/// @throws ALError in any other process, or for a key that is not there or holds no such number.
USARNAOQI_SDK_API void* memoryPointer(const ALProxy& memory, const std::string& key);

}  // namespace detail
}  // namespace AL
