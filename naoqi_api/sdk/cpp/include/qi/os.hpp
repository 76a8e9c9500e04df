#pragma once

#include <string>

#include <usarnaoqi_sdk/export.h>

namespace qi {
namespace os {

struct timeval {
  long long tv_sec;
  long long tv_usec;
};

/// Waits, on this machine's clock: a robot that is simulated faster lives through more.
USARNAOQI_SDK_API void sleep(unsigned int seconds);
USARNAOQI_SDK_API void msleep(unsigned int milliseconds);

/// Since 1970, by this machine's clock. 0.
USARNAOQI_SDK_API int gettimeofday(timeval* time);
/// Microseconds since some moment.
USARNAOQI_SDK_API long long ustime();

/// Empty if it is not set.
USARNAOQI_SDK_API std::string getenv(const char* name);
USARNAOQI_SDK_API int setenv(const char* name, const char* value);
USARNAOQI_SDK_API std::string gethostname();
USARNAOQI_SDK_API std::string home();
USARNAOQI_SDK_API std::string tmp();
USARNAOQI_SDK_API int getpid();

}  // namespace os
}  // namespace qi
