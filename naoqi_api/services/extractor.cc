#include "naoqi_api/services/extractor.h"

#include <algorithm>
#include <utility>

#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

Argument subscriber() { return {"name", "The subscriber's name, of its own choice."}; }
Argument period() { return {"period", "[ms]"}; }
Argument precision() { return {"precision", "0 to 1."}; }

}  // namespace

Extractor::Extractor(memory::MemoryStore& store, std::string name, Outputs outputs)
    : name_(std::move(name)), outputs_(std::move(outputs)) {
  for (const std::string& event : outputs_.events) store.declareEvent(event, name_);
}

void Extractor::tell(bool was_working) const {
  if (changed_ && isWorking() != was_working) changed_(isWorking());
}

void Extractor::subscribe(const std::string& name, const Subscriber& subscriber) {
  if (subscribers_.size() >= kMostSubscribers && subscribers_.count(name) == 0) {
    throw CallError("too many have subscribed");
  }
  const bool was_working = isWorking();
  subscribers_[name] = subscriber;
  tell(was_working);
}

void Extractor::unsubscribe(const std::string& name) {
  at(name);
  const bool was_working = isWorking();
  subscribers_.erase(name);
  tell(was_working);
}

Extractor::Subscriber& Extractor::at(const std::string& name) {
  const auto found = subscribers_.find(name);
  if (found == subscribers_.end()) throw CallError(name + " has not subscribed to " + name_);
  return found->second;
}

void Extractor::pause(bool on) {
  const bool was_working = isWorking();
  paused_ = on;
  tell(was_working);
}

void Extractor::declare(rpc::Service& service) {
  declareSubscribing(service);
  declareAsking(service);
}

void Extractor::declareSubscribing(rpc::Service& service) {
  addFunction(
      service, "subscribe", [this](const std::string& name) { subscribe(name, {}); },
      "Makes it work until unsubscribe().", subscriber());
  addFunction(
      service, "subscribe",
      [this](const std::string& name, std::int32_t period_ms, float precise) {
        subscribe(name, {period_ms, precise});
      },
      "Makes it work until unsubscribe().", subscriber(), period(), precision());
  addFunction(
      service, "unsubscribe", [this](const std::string& name) { unsubscribe(name); },
      "Ends a subscription.", subscriber());
  addFunction(
      service, "updatePeriod",
      [this](const std::string& name, std::int32_t period_ms) { at(name).period = period_ms; },
      "Changes a subscription.", subscriber(), period());
  addFunction(
      service, "updatePrecision",
      [this](const std::string& name, float precise) { at(name).precision = precise; },
      "Changes a subscription.", subscriber(), precision());
  addFunction(
      service, "pause", [this](bool on) { pause(on); }, "Stops it for a while, or goes on.",
      Argument{"paused", "True: stop, false: go on."});
  addFunction(
      service, "isPaused", [this] { return paused_; }, "Whether pause() has stopped it.");
  addFunction(
      service, "isProcessing", [this] { return isWorking(); },
      "Whether somebody has subscribed and it is not paused.");
}

void Extractor::declareAsking(rpc::Service& service) {
  addFunction(
      service, "getMyPeriod", [this](const std::string& name) { return at(name).period; },
      "What a subscriber asked for [ms].", subscriber());
  addFunction(
      service, "getMyPrecision", [this](const std::string& name) { return at(name).precision; },
      "What a subscriber asked for.", subscriber());
  addFunction(
      service, "getCurrentPeriod",
      [this] {
        std::int32_t least = Subscriber().period;
        bool first = true;
        for (const auto& [name, subscriber] : subscribers_) {
          least = first ? subscriber.period : std::min(least, subscriber.period);
          first = false;
        }
        return least;
      },
      "The shortest period that a subscriber asked for [ms].");
  addFunction(
      service, "getCurrentPrecision",
      [this] {
        float most = 0;
        for (const auto& [name, subscriber] : subscribers_) {
          most = std::max(most, subscriber.precision);
        }
        return subscribers_.empty() ? 1.0F : most;
      },
      "The highest precision that a subscriber asked for.");
  addFunction(
      service, "getSubscribersInfo",
      [this] {
        std::vector<Value> list;
        for (const auto& [name, subscriber] : subscribers_) {
          list.push_back(Value::list({name, subscriber.period, subscriber.precision}));
        }
        return Value::list(std::move(list));
      },
      "[[subscriber, period, precision], ...]");
  addFunction(
      service, "getOutputNames", [this] { return outputs_.events; },
      "The events and keys it writes.");
  addFunction(
      service, "getEventList", [this] { return outputs_.events; }, "The events it raises.");
  addFunction(
      service, "getMemoryKeyList", [this] { return outputs_.keys; },
      "The keys it writes that are no events.");
}

}  // namespace nao::services
