#include "naoqi_api/monitor.h"

#include <algorithm>

namespace nao::rpc {
namespace {

constexpr char kMinMaxSum[] = "(fff)<MinMaxSum,minValue,maxValue,cumulatedValue>";
constexpr char kTimeval[] = "(ll)<timeval,tv_sec,tv_usec>";

const std::string kMethodStatistics =  // NOLINT: a constant built from the one above
    "(I" + std::string(kMinMaxSum) + kMinMaxSum + kMinMaxSum +
    ")<MethodStatistics,count,wall,user,system>";

Value minMaxSum(float shortest, float longest, float sum) {
  return Value::tuple(kMinMaxSum, {shortest, longest, sum});
}

}  // namespace

const char Monitor::kTraceSignature[] =
    "((IiIm(ll)<timeval,tv_sec,tv_usec>llII)<EventTrace,id,kind,slotId,arguments,timestamp,"
    "userUsTime,systemUsTime,callerContext,calleeContext>)";

const char Monitor::kStatisticsSignature[] =
    "{I(I(fff)<MinMaxSum,minValue,maxValue,cumulatedValue>"
    "(fff)<MinMaxSum,minValue,maxValue,cumulatedValue>"
    "(fff)<MinMaxSum,minValue,maxValue,cumulatedValue>)"
    "<MethodStatistics,count,wall,user,system>}";

void Monitor::record(std::uint32_t uid, float seconds) {
  Statistics& known = statistics_[uid];
  known.shortest = known.count == 0 ? seconds : std::min(known.shortest, seconds);
  known.longest = std::max(known.longest, seconds);
  known.sum += seconds;
  ++known.count;
}

Value Monitor::statistics() const {
  Value::Map all{"I", kMethodStatistics, {}};
  for (const auto& [uid, known] : statistics_) {
    // Processor time per call is not measured: zero.
    all.entries.emplace_back(
        uid, Value::tuple(kMethodStatistics,
                          {known.count, minMaxSum(known.shortest, known.longest, known.sum),
                           minMaxSum(0, 0, 0), minMaxSum(0, 0, 0)}));
  }
  return all;
}

void Monitor::trace(std::uint32_t id, Event event, std::uint32_t uid, const Value& content,
                    std::int64_t time_us) const {
  const Value time = Value::tuple(kTimeval, {time_us / 1'000'000, time_us % 1'000'000});
  const std::string signature = kTraceSignature;  // one argument: "(" EventTrace ")"
  trace_object_.emit(
      {Value::tuple(signature.substr(1, signature.size() - 2),
                    {id, static_cast<std::int32_t>(event), uid, content, time, std::int64_t{0},
                     std::int64_t{0}, std::uint32_t{0}, std::uint32_t{0}})});
}

}  // namespace nao::rpc
