#pragma once

#include <cstdint>
#include <map>

#include "naoqi_api/signal.h"

namespace nao::rpc {

/// What clients may switch on to watch an object at work: counts and durations per method, and a
/// signal for every call.
class Monitor {
 public:
  struct Statistics {
    std::uint32_t count = 0;
    float shortest = 0;  // [s] of wall time
    float longest = 0;   // [s]
    float sum = 0;       // [s]
  };
  enum class Event : std::int32_t { Call = 1, Result = 2, Error = 3, Signal = 4 };

  static const char kTraceSignature[];
  static const char kStatisticsSignature[];

  bool stats_enabled = false;
  bool trace_enabled = false;
  bool signals_are_traced = false;  // by a SignalTracer

  void record(std::uint32_t uid, float seconds);
  void clear() { statistics_.clear(); }
  Value statistics() const;

  /// Tells the listeners of traceObject. `time_us` is NaoQi's clock [us].
  void trace(std::uint32_t id, Event event, std::uint32_t uid, const Value& content,
             std::int64_t time_us) const;
  const Emitter& traceObject() const { return trace_object_; }

 private:
  std::map<std::uint32_t, Statistics> statistics_;
  Emitter trace_object_{kTraceSignature};
};

}  // namespace nao::rpc
