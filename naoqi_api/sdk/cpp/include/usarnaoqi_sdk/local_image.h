#pragma once

#include <alcommon/alproxy.h>
#include <usarnaoqi_sdk/export.h>

#include <string>

namespace AL {
namespace detail {

/// The newest picture of a window, or its camera's raw one, as an ALImage*; null if there is no
/// such window. In a local module its pixels are the daemon's own, elsewhere a copy. It stays until
/// it is released, or the next one of this window is asked for.
USARNAOQI_SDK_API void* localImage(const ALProxy& video, const std::string& window, bool raw);

/// Ends what localImage() returned.
USARNAOQI_SDK_API void releaseLocalImage(const std::string& window, bool raw);

}  // namespace detail
}  // namespace AL
