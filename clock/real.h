#pragma once

#include <dlfcn.h>

namespace nao::clock {

/// The C library's own function behind one that we stand before.
inline void* findReal(const char* name, const char* version) {
  void* found = version ? ::dlvsym(RTLD_NEXT, name, version) : nullptr;
  return found ? found : ::dlsym(RTLD_NEXT, name);
}

}  // namespace nao::clock

// NOLINTBEGIN(cppcoreguidelines-macro-usage): names of functions become text
#define NAO_REAL_VERSION(name, version)                                                        \
  ([] {                                                                                        \
    static decltype(&::name) real_##name;                                                      \
    if (!real_##name)                                                                          \
      real_##name = reinterpret_cast<decltype(&::name)>(nao::clock::findReal(#name, version)); \
    return real_##name;                                                                        \
  }())
#define NAO_REAL(name) NAO_REAL_VERSION(name, nullptr)
// A function that takes the place of the C library's.
#define NAO_INSTEAD extern "C" __attribute__((visibility("default")))
// NOLINTEND(cppcoreguidelines-macro-usage)
