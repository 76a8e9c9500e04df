#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "naoqi_api/service.h"

namespace nao::rpc {

/// Puts what a service's signals and properties emit into its trace while somebody listens to that.
class SignalTracer : public std::enable_shared_from_this<SignalTracer> {
 public:
  using Trace = std::function<void(Service&, std::uint32_t uid, const std::vector<Value>&)>;

  /// From now on, as long as `service` lives; `trace` is told of every emission. A service that is
  /// watched already stays with the trace it has.
  static void watch(const std::shared_ptr<Service>& service, Trace trace);

 private:
  SignalTracer(std::weak_ptr<Service> service, Trace trace)
      : service_(std::move(service)), trace_(std::move(trace)) {}

  void listenIf(bool wanted);
  void listenTo(std::uint32_t uid, const Emitter& emitter);

  std::weak_ptr<Service> service_;
  Trace trace_;
  std::vector<std::pair<Emitter, std::uint64_t>> links_;  // while somebody wants the trace
};

}  // namespace nao::rpc
