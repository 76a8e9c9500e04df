#pragma once

#include <cstddef>

#include "naoqi_api/value.h"

namespace nao::memory {

/// About how many bytes of this program's memory a value takes, everything in it included. Bytes
/// that values share (images) count in each.
std::size_t sizeOf(const rpc::Value& value);

/// True if the value holds an object anywhere: those belong to a connection and can not be kept.
bool holdsObject(const rpc::Value& value);

}  // namespace nao::memory
