#include "naoqi_api/wire/dispatcher.h"

#include <chrono>

#include "naoqi_api/fits.h"
#include "naoqi_api/wire/base_actions.h"
#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/client_object.h"
#include "naoqi_api/wire/event_values.h"
#include "naoqi_api/wire/metaobject.h"

namespace nao::wire {
namespace {

using rpc::CallError;
using rpc::Monitor;

constexpr std::size_t kMaxWished = 4096;         // letters of a signature
constexpr std::size_t kMaxEmitted = 64U << 10U;  // bytes of a signal that a client emits

Message headerOf(const Message& message) {
  Message header;
  header.id = message.id;
  header.type = message.type;
  header.flags = message.flags;
  header.address = message.address;
  return header;
}

[[noreturn]] void failNoSuchMethod(const Message& message) {
  const Address& address = message.address;
  throw CallError("No such method {" + std::to_string(address.service) + "." +
                  std::to_string(address.object) + "." + std::to_string(address.action) +
                  ", id:" + std::to_string(message.id) + "}");
}

}  // namespace

Dispatcher::Dispatcher(rpc::ServiceHub& hub, std::shared_ptr<Channel> channel,
                       std::shared_ptr<rpc::Session> session)
    : hub_(hub),
      channel_(std::move(channel)),
      session_(std::move(session)),
      client_calls_(std::make_shared<ClientCalls>(channel_, hub_.options().alarm)),
      objects_(hub_, channel_, client_calls_),
      subscriptions_(channel_, objects_) {
  client_calls_->setObjects(&objects_);
  session_->setReach([calls = client_calls_](std::uint32_t service) {
    return std::make_shared<ClientObject>(Address{service, ObjectHost::kMain, 0}, calls);
  });
}

void Dispatcher::end() {
  late_.clear();
  for (const auto& [number, call] : std::exchange(unfinished_, {})) call.result.abandon();
  subscriptions_.clear();
  session_->setReach({});
  client_calls_->setObjects(nullptr);
  client_calls_->failAll();
}

void Dispatcher::dispatch(const Message& message) {
  switch (message.type) {
    case MessageType::Call:
    case MessageType::Post:
      return call(message);
    case MessageType::Cancel:
      return cancel(message);
    case MessageType::Reply:
    case MessageType::Error:
    case MessageType::Canceled:
      return client_calls_->take(message);
    case MessageType::Event:
      return client_calls_->takeEvent(message);
    case MessageType::Capability:
      return;
  }
}

void Dispatcher::call(const Message& message) {
  std::string error;
  try {
    const auto service = objects_.find(message.address.service, message.address.object);
    if (!service && isHostedByClient(message.address)) return callLater(message);
    if (!service) throw CallError("The call request could not be handled.");
    const bool is_base = message.address.action < rpc::Service::kFirstUid;
    return is_base ? callBase(message, service) : callMethod(message, service);
  } catch (const CallError& failure) {
    error = failure.what();
  } catch (const CodecError& failure) {
    error = failure.what();
  }
  if (message.type == MessageType::Call) channel_->error(message, error);
}

bool Dispatcher::isHostedByClient(const Address& address) const {
  const auto* entry = hub_.find(address.service);
  return entry && entry->ready && entry->owner && address.object == ObjectHost::kMain;
}

// A service that another client hosts: what it offers must be known before its calls can be read.
void Dispatcher::callLater(const Message& message) {
  if (waiting_ >= kMostWaiting) throw CallError("too many unfinished calls");
  ++waiting_;
  hub_.reach(message.address.service)
      .whenDone([weak = weak_from_this(), message](const auto& found) {
        const auto self = weak.lock();
        if (!self) return;
        --self->waiting_;
        if (found.value) return self->call(message);
        if (message.type == MessageType::Call) {
          self->channel_->error(message, found.error.value_or("canceled"));
        }
      });
}

Dispatcher::Request Dispatcher::readRequest(const Message& message, const Signature& parameters) {
  Decoder decoder(message.payload, &objects_);
  const bool dynamic = (message.flags & kFlagDynamic) != 0;
  Value arguments = dynamic ? decoder.read("m") : decoder.read(parameters);
  if (!arguments.isList()) {
    throw CallError("The arguments of a call are a tuple, not " + arguments.signature());
  }
  Request request{*std::move(arguments).takeItems(), {}};
  if ((message.flags & kFlagReturnType) != 0) request.wished = decoder.text();
  if (request.wished.size() > kMaxWished) throw CallError("the return signature is too long");
  return request;
}

void Dispatcher::callBase(const Message& message, const std::shared_ptr<rpc::Service>& service) {
  const BaseMethod* base = findBaseMethod(message.address.action);
  if (!base) failNoSuchMethod(message);
  const BaseTypes& types = typesOf(*base);
  const Request request = readRequest(message, types.parameters);
  const auto arguments =
      rpc::convert(Value::tuple(request.arguments), types.parameters, rpc::Bend::Declared);
  if (!arguments) throw CallError(std::string(base->name) + " takes " + base->parameters);
  const BaseContext context{message.address, *service, objects_, subscriptions_,
                            hub_.options().personality.documents_members};
  await({headerOf(message), service, &types.returns, request.wished},
        runBaseAction(context, *arguments->findItems()));
}

void Dispatcher::callMethod(const Message& message, const std::shared_ptr<rpc::Service>& service) {
  const rpc::Method* method = service->findMethod(message.address.action);
  if (!method) {
    const rpc::Emitter* emitter = service->findSignal(message.address.action);
    if (emitter && message.type == MessageType::Post) return emit(message, *emitter);
    failNoSuchMethod(message);
  }
  Request request = readRequest(message, method->parameters);
  if (unfinished_.size() + late_.size() >= kMostUnfinished)
    throw CallError("too many unfinished calls");
  Call call{headerOf(message), service, &method->returns, std::move(request.wished)};
  const auto result = run(call, *method, request.arguments);
  await(call, result);
}

void Dispatcher::await(const Call& call, const rpc::Pending<Value>& result) {
  if (result.isDone()) return finish(call, *result.outcome());
  const std::uint64_t number = next_unfinished_++;
  unfinished_[number] = {call.header.id, result};
  result.whenDone([weak = weak_from_this(), number, call](const rpc::Outcome<Value>& outcome) {
    const auto self = weak.lock();
    if (self && self->unfinished_.erase(number) > 0) self->finishLate(call, outcome);
  });
}

rpc::Pending<Value> Dispatcher::run(Call& call, const rpc::Method& method,
                                    const std::vector<Value>& arguments) {
  const rpc::Caller caller{session_, call.service.get(), &hub_.tasks()};
  const Monitor& monitor = call.service->monitor();
  // Listening to the traces is enough to have them.
  if (monitor.trace_enabled || monitor.traceObject().listenerCount() > 0) {
    call.trace = hub_.takeTraceId();
    call.action = method.uid;
    trace(call, Monitor::Event::Call, Value::list(arguments));
  }
  if (!monitor.stats_enabled) return method.invoke(caller, arguments);
  const auto start = std::chrono::steady_clock::now();
  const auto result = method.invoke(caller, arguments);
  result.whenDone([start, service = call.service, uid = method.uid](const auto& /*outcome*/) {
    const std::chrono::duration<float> took = std::chrono::steady_clock::now() - start;
    service->monitor().record(uid, took.count());
  });
  return result;
}

void Dispatcher::trace(const Call& call, Monitor::Event event, const Value& content) const {
  const auto now_us = std::chrono::duration_cast<std::chrono::microseconds>(hub_.options().clock());
  call.service->monitor().trace(call.trace, event, call.action, content, now_us.count());
}

void Dispatcher::emit(const Message& message, const rpc::Emitter& emitter) {
  if (message.payload.size() > kMaxEmitted) return;
  const Signature type = Signature::of(emitter.signature());
  Decoder decoder(message.payload, &objects_);
  const bool dynamic = (message.flags & kFlagDynamic) != 0;
  const auto arguments = argumentsOf(dynamic ? decoder.read("m") : decoder.read(type), type);
  if (arguments) emitter.emit(*arguments);
}

void Dispatcher::finish(const Call& call, const rpc::Outcome<Value>& outcome) {
  if (call.header.type != MessageType::Post) answer(call, outcome);
  if (call.trace == 0) return;
  trace(call, outcome.value ? Monitor::Event::Result : Monitor::Event::Error,
        outcome.value ? *outcome.value : Value(outcome.error.value_or("canceled")));
}

void Dispatcher::answer(const Call& call, const rpc::Outcome<Value>& outcome) {
  if (outcome.isCanceled()) return answerCanceled(call);
  if (outcome.error) return channel_->error(call.header, *outcome.error);
  answer(call, *outcome.value);
}

void Dispatcher::finishLate(const Call& call, const rpc::Outcome<Value>& outcome) {
  if (held_) {
    late_.emplace_back(call, outcome);
  } else {
    finish(call, outcome);
  }
}

void Dispatcher::resume() {
  held_ = false;
  while (!held_ && !late_.empty()) {
    const auto [call, outcome] = std::move(late_.front());
    late_.pop_front();
    finish(call, outcome);
  }
}

void Dispatcher::answer(const Call& call, const Value& result) {
  objects_.setGiver(call.header.address.service);
  try {
    Bytes payload;
    if (!call.wished.empty() && channel_->shares("MessageFlags")) {
      const auto type = Signature::parse(call.wished);
      const auto wished = type ? rpc::convert(result, *type, rpc::Bend::Declared) : std::nullopt;
      if (wished) {
        encodeDynamic(payload, *wished, &objects_);
        return channel_->reply(call.header, std::move(payload), kFlagDynamic);
      }
    }
    const Signature& returns = *call.returns;
    constexpr std::size_t kMostAnswers = 256;  // [bytes] are no longer
    payload.reserve(kMostAnswers);
    if (rpc::fits(result, returns)) {
      encode(payload, result, returns, &objects_);
      return channel_->reply(call.header, std::move(payload));
    }
    const auto declared = rpc::convert(result, returns, rpc::Bend::Declared);
    if (!declared) throw CodecError("the result " + result.print() + " is not " + returns.words());
    encode(payload, *declared, returns, &objects_);
    channel_->reply(call.header, std::move(payload));
  } catch (const CodecError& error) {
    channel_->error(call.header, error.what());
  }
}

// Peers from before 2015 know no Canceled.
void Dispatcher::answerCanceled(const Call& call) {
  const bool always = hub_.options().personality.needs_authentication;
  if (always || channel_->shares("RemoteCancelableCalls")) return channel_->canceled(call.header);
  channel_->error(call.header, "Call has been canceled.");
}

// The number of the call is the payload (libqi), or the message's own with no payload (qiloop).
void Dispatcher::cancel(const Message& message) {
  std::uint32_t id = message.id;
  if (message.payload.size() >= sizeof(id)) id = readNumber<std::uint32_t>(message.payload.data());
  for (auto it = unfinished_.rbegin(); it != unfinished_.rend(); ++it) {
    if (it->second.id != id) continue;
    const rpc::Pending<Value> result = it->second.result;
    return result.cancel();
  }
}

}  // namespace nao::wire
