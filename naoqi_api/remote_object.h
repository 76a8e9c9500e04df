#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "naoqi_api/pending.h"
#include "naoqi_api/value.h"

namespace nao::rpc {

/// An object that a client hosts: a callback it passed as an argument, or a service it registered.
/// The client may be gone at any time; calls then fail. I/O thread only.
class RemoteObject {
 public:
  virtual ~RemoteObject() = default;

  /// Calls by name; an overload is chosen by the number of its arguments.
  virtual Pending<Value> call(std::string_view name, const std::vector<Value>& arguments) = 0;

  /// What it offers, as a service of ours whose methods, signals and properties are the client's.
  virtual Pending<std::shared_ptr<Service>> offer() = 0;

  /// False once its client has gone.
  virtual bool isReachable() const = 0;
};

}  // namespace nao::rpc
