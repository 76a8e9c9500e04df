#pragma once

#include <stdexcept>

namespace nao::rpc {

/// A call that the client got wrong. Becomes an error reply; nothing else leaves a service.
struct CallError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace nao::rpc
