#pragma once

#include <cstddef>
#include <string>

#include "naoqi_api/call_error.h"

namespace nao::services {

inline constexpr std::size_t kMostNames = 256;  // that clients may add to one list; free choice

/// Refuses, with a CallError, a name that is new in `kept`, a set or map of what clients asked to
/// keep, once it is full.
template <class Kept>
void requireRoom(const Kept& kept, const std::string& name) {
  if (kept.size() < kMostNames || kept.count(name) > 0) return;
  throw rpc::CallError("there is no room for " + name + ": " + std::to_string(kMostNames) +
                       " names are kept already");
}

}  // namespace nao::services
