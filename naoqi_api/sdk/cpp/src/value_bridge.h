#pragma once

#include <alvalue/alvalue.h>

#include "naoqi_api/value.h"

namespace nao::client {

/// A program's value as one of the wire, each item with its own type; nothing becomes void.
rpc::Value toWire(const AL::ALValue& value);

/// A value of the wire as NaoQi's: tuples are arrays, maps arrays of [key, value]; bytes are
/// shared, not copied; objects become nothing.
AL::ALValue fromWire(const rpc::Value& value);

}  // namespace nao::client
