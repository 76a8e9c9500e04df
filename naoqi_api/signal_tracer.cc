#include "naoqi_api/signal_tracer.h"

namespace nao::rpc {

void SignalTracer::watch(const std::shared_ptr<Service>& service, Trace trace) {
  const std::shared_ptr<SignalTracer> tracer(new SignalTracer(service, std::move(trace)));
  service->monitor().traceObject().onListeners(
      [tracer](std::size_t listeners) { tracer->follow(listeners > 0); });
}

void SignalTracer::follow(bool wanted) {
  if (wanted == !followed_.empty()) return;
  for (const auto& [emitter, link] : std::exchange(followed_, {})) emitter.disconnect(link);
  const auto service = service_.lock();
  if (!wanted || !service) return;
  for (const auto& [uid, signal] : service->signals()) follow(uid, signal.emitter);
  for (const auto& [uid, property] : service->properties()) follow(uid, property.emitter);
}

void SignalTracer::follow(std::uint32_t uid, const Emitter& emitter) {
  const auto link =
      emitter.connect([weak = weak_from_this(), uid](const std::vector<Value>& arguments) {
        const auto self = weak.lock();
        const auto service = self ? self->service_.lock() : nullptr;
        if (service) self->trace_(*service, uid, arguments);
      });
  followed_.emplace_back(emitter, link);
}

}  // namespace nao::rpc
