#pragma once

#include <cmath>

#include "naoqi_api/call_error.h"

namespace nao::services {

/// @throws CallError unless the number is finite.
inline double finite(double number) {
  if (!std::isfinite(number)) throw rpc::CallError("expected a finite number");
  return number;
}

}  // namespace nao::services
