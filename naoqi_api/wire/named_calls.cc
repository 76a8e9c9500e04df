#include "naoqi_api/wire/named_calls.h"

#include <charconv>
#include <utility>

#include "naoqi_api/call_error.h"

namespace nao::wire {

using rpc::CallError;
using rpc::Pending;
using rpc::Service;

NamedCalls::NamedCalls(rpc::ServiceHub& hub, std::string endpoint)
    : hub_(hub),
      session_(std::make_shared<rpc::Session>(hub.takeSessionId(), std::move(endpoint))) {}

NamedCalls::~NamedCalls() {
  alive_.reset();
  for (const auto& [number, call] : std::exchange(unfinished_, {})) call.abandon();
  for (const auto& [link, known] : std::exchange(subscriptions_, {})) {
    known.emitter.disconnect(known.link);
  }
  session_->end();
}

NamedCalls::Target NamedCalls::find(const std::string& target) {
  if (!target.empty() && target.front() == '#') {
    std::int64_t number = -1;
    std::from_chars(target.data() + 1, target.data() + target.size(), number);
    const auto found = objects_.find(number);
    if (found != objects_.end()) return Target::done(found->second);
  } else if (const auto* entry = hub_.find(target)) {
    return hub_.reach(entry->id);
  }
  return Target::failed("Cannot find service '" + target + "' in index");
}

// The service may be a client's, which must be asked what it offers first.
Pending<Value> NamedCalls::whenFound(const std::string& target,
                                     std::function<Pending<Value>(NamedCalls&, Service&)> then) {
  if (unfinished_.size() >= kMostUnfinished) {
    return Pending<Value>::failed("too many unfinished calls");
  }
  Pending<Value> result;
  find(target).whenDone([result, then = std::move(then), weak = std::weak_ptr(alive_)](
                            const rpc::Outcome<std::shared_ptr<Service>>& found) {
    const auto self = weak.lock();
    if (!self || !found.value) return result.fail(found.error.value_or("canceled"));
    Pending<Value> called;
    try {
      called = then(**self, **found.value);
    } catch (const CallError& error) {
      called.fail(error.what());
    }
    called.whenDone([result, service = *found.value](const rpc::Outcome<Value>& outcome) {
      if (outcome.value) return result.resolve(*outcome.value);
      result.fail(outcome.error.value_or("Call has been canceled."));
    });
    result.cancelsWith(called);
  });
  keep(result);
  return result;
}

void NamedCalls::keep(const Pending<Value>& result) {
  if (result.isDone()) return;
  const std::uint64_t number = next_call_++;
  unfinished_.emplace(number, result);
  result.whenDone([weak = std::weak_ptr(alive_), number](const auto& /*outcome*/) {
    if (const auto self = weak.lock()) (*self)->unfinished_.erase(number);
  });
}

Pending<Value> NamedCalls::call(const std::string& target, const std::string& method,
                                const std::vector<Value>& arguments) {
  return whenFound(target, [method, arguments](NamedCalls& self, Service& service) {
    return service.call(method, arguments, {self.session_, &service, &self.hub_.tasks()});
  });
}

namespace {

const rpc::PropertyMember& propertyOf(const Service& service, const std::string& name) {
  const auto* property = service.findProperty(name);
  if (!property) throw CallError("property \"" + name + "\" was not found");
  return *property;
}

}  // namespace

Pending<Value> NamedCalls::property(const std::string& target, const std::string& name) {
  return whenFound(target, [name](NamedCalls& /*self*/, Service& service) {
    return propertyOf(service, name).get();
  });
}

Pending<Value> NamedCalls::setProperty(const std::string& target, const std::string& name,
                                       const Value& value) {
  return whenFound(target, [name, value](NamedCalls& /*self*/, Service& service) {
    const auto& property = propertyOf(service, name);
    const auto fitting =
        rpc::convert(value, rpc::Signature::of(property.signature), rpc::Bend::Declared);
    if (!fitting) throw CallError(value.print() + " can not be property " + name);
    Pending<Value> result;
    property.set(*fitting).whenDone([result](const auto& outcome) {
      if (outcome.value) return result.resolve();
      result.fail(outcome.error.value_or("canceled"));
    });
    return result;
  });
}

Pending<Value> NamedCalls::subscribe(const std::string& target, const std::string& signal,
                                     Listener listener) {
  return whenFound(target, [signal, listener](NamedCalls& self, Service& service) {
    return self.listen(service, signal, listener);
  });
}

namespace {

constexpr std::size_t kMostEarly = 64;  // events; then the answer waits for the host no longer

/// What comes of a subscription before its answer has told the client the link: kept until then.
struct EarlyEvents {
  bool is_answered = false;
  std::vector<std::vector<Value>> events;
};

}  // namespace

Pending<Value> NamedCalls::listen(Service& service, const std::string& signal,
                                  const Listener& listener) {
  const rpc::Emitter* emitter = service.findSignal(signal);
  if (!emitter) throw CallError("No such signal");
  if (subscriptions_.size() >= kMostSubscriptions) {
    throw CallError("too many subscriptions on one connection");
  }
  const std::uint64_t link = next_link_++;
  const auto early = std::make_shared<EarlyEvents>();
  const Pending<Value> subscribed;
  const auto answer = [=] {
    subscribed.resolve(link);
    early->is_answered = true;
    for (const auto& event : std::exchange(early->events, {})) listener(link, event);
  };
  const auto added = subscriptions_.emplace(link, Subscription{*emitter, 0}).first;
  added->second.link = emitter->connect([=](const std::vector<Value>& arguments) {
    if (early->is_answered) return listener(link, arguments);
    early->events.push_back(arguments);
    if (early->events.size() >= kMostEarly) answer();
  });
  emitter->heard().whenDone([=, weak = std::weak_ptr(alive_)](const auto& heard) {
    if (heard.value) return answer();
    if (const auto self = weak.lock()) (*self)->unsubscribe(link);
    subscribed.fail(heard.error.value_or("canceled"));
  });
  return subscribed;
}

bool NamedCalls::unsubscribe(std::uint64_t link) {
  const auto found = subscriptions_.find(link);
  if (found == subscriptions_.end()) return false;
  const Subscription known = found->second;
  subscriptions_.erase(found);
  known.emitter.disconnect(known.link);
  return true;
}

std::int64_t NamedCalls::give(const ObjectRef& object) {
  auto service = object.local;
  if (object.remote) {
    const auto offer = object.remote->offer().outcome();
    if (offer && offer->value) service = *offer->value;
  }
  if (!service) return -1;
  const auto known = numbers_.find(service.get());
  if (known != numbers_.end()) return known->second;
  if (objects_.size() >= kMostObjects) throw CallError("too many objects handed out");
  objects_[next_object_] = service;
  numbers_[service.get()] = next_object_;
  return next_object_++;
}

bool NamedCalls::release(std::int64_t object) {
  const auto node = objects_.extract(object);  // destroyed when already out
  if (!node.empty()) numbers_.erase(node.mapped().get());
  return !node.empty();
}

std::vector<std::string> NamedCalls::serviceNames() const {
  std::vector<std::string> names;
  for (const auto& [id, entry] : hub_.entries()) {
    if (entry.ready) names.push_back(entry.name);
  }
  return names;
}

}  // namespace nao::wire
