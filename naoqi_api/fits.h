#pragma once

#include "naoqi_api/signature.h"
#include "naoqi_api/value.h"

namespace nao::rpc {

/// Whether `value` is of exactly that type already, through and through, so that nothing has to be
/// converted. Allocates nothing.
bool fits(const Value& value, const Signature& signature);

}  // namespace nao::rpc
