#include "naoqi_api/signal_tracer.h"

namespace nao::rpc {

void SignalTracer::watch(const std::shared_ptr<Service>& service, Trace trace) {
  if (std::exchange(service->monitor().signals_are_traced, true)) return;
  const std::shared_ptr<SignalTracer> tracer(new SignalTracer(service, std::move(trace)));
  service->monitor().traceObject().onListeners(
      [tracer](std::size_t listeners) { tracer->listenIf(listeners > 0); });
}

void SignalTracer::listenIf(bool wanted) {
  if (wanted == !links_.empty()) return;
  for (const auto& [emitter, link] : std::exchange(links_, {})) emitter.disconnect(link);
  const auto service = service_.lock();
  if (!wanted || !service) return;
  for (const auto& [uid, signal] : service->signals()) listenTo(uid, signal.emitter);
  for (const auto& [uid, property] : service->properties()) listenTo(uid, property.emitter);
}

void SignalTracer::listenTo(std::uint32_t uid, const Emitter& emitter) {
  const auto link =
      emitter.connect([weak = weak_from_this(), uid](const std::vector<Value>& arguments) {
        const auto self = weak.lock();
        const auto service = self ? self->service_.lock() : nullptr;
        if (service) self->trace_(*service, uid, arguments);
      });
  links_.emplace_back(emitter, link);
}

}  // namespace nao::rpc
