#include "naoqi_api/wire/msgpack_connection.h"

#include <algorithm>
#include <utility>

#include "naoqi_api/call_error.h"
#include "naoqi_api/wire/frame.h"

namespace nao::wire {
namespace {

using rpc::CallError;
using rpc::Pending;

constexpr int kRequest = 0;
constexpr int kResponse = 1;
constexpr int kNotification = 2;

/// "ALMotion.setAngles" cut at its last dot.
struct Member {
  std::string target;
  std::string name;
};

Member memberOf(const std::string& text) {
  const std::size_t dot = text.rfind('.');
  if (dot == std::string::npos) throw CallError("expected Service.member, got " + text);
  return {text.substr(0, dot), text.substr(dot + 1)};
}

void expectCount(const std::string& method, const std::vector<Value>& arguments,
                 std::size_t count) {
  if (arguments.size() == count) return;
  throw CallError(method + " takes " + std::to_string(count) + " arguments, got " +
                  std::to_string(arguments.size()));
}

std::string textOf(const Value& value) {
  const std::string* text = value.findText();
  if (!text) throw CallError("expected a text, got " + value.print());
  return *text;
}

}  // namespace

MsgpackConnection::MsgpackConnection(rpc::ServiceHub& hub, const std::string& endpoint, Send send)
    : hub_(hub),
      send_(std::move(send)),
      calls_(hub, endpoint),
      name_of_([this](const ObjectRef& object) {
        const std::int64_t number = calls_.give(object);
        return number < 0 ? std::string() : "#" + std::to_string(number);
      }),
      may_call_(!hub.options().credentials),
      alive_(std::make_shared<MsgpackConnection*>(this)) {
  if (!may_call_) reader_.setMaxBytes(kMaxPayloadBefore);
}

MsgpackConnection::~MsgpackConnection() {
  alive_.reset();
  send_ = {};
}

void MsgpackConnection::receive(const std::uint8_t* bytes, std::size_t count) {
  if (wants_close_) return;
  reader_.push(bytes, count);
  takeAll();
}

void MsgpackConnection::resume() {
  if (!std::exchange(held_, false) || wants_close_) return;
  while (!held_ && !late_.empty()) {
    const auto [id, outcome] = std::move(late_.front());
    late_.pop_front();
    answer(id, outcome);
  }
  takeAll();
}

void MsgpackConnection::takeAll() {
  while (!held_) {
    const auto message = reader_.next();
    if (!message) break;
    ++messages_taken_;
    if (!take(*message)) wants_close_ = true;
    if (wants_close_) return;
  }
  if (reader_.isBroken()) wants_close_ = true;
}

// False if it is no message of MessagePack-RPC.
bool MsgpackConnection::take(const Value& message) {
  const auto* items = message.findItems();
  const auto* kind = items && !items->empty() ? items->front().find<std::int32_t>() : nullptr;
  if (!kind) return false;
  if (*kind == kRequest && items->size() == 4) {
    const std::string* method = (*items)[2].findText();
    const auto* arguments = (*items)[3].findItems();
    if (!method || !arguments || !(*items)[1].isNumber()) return false;
    request((*items)[1], *method, *arguments);
    return true;
  }
  if (*kind == kNotification && items->size() == 3) {
    const std::string* method = (*items)[1].findText();
    const auto* arguments = (*items)[2].findItems();
    if (!method || !arguments) return false;
    run(*method, *arguments);
    return true;
  }
  return *kind == kResponse;  // to nothing that was asked
}

void MsgpackConnection::request(const Value& id, const std::string& method,
                                const Arguments& arguments) {
  const auto result = run(method, arguments);
  if (result.isDone()) return answer(id, *result.outcome());
  result.whenDone([weak = std::weak_ptr(alive_), id](const rpc::Outcome<Value>& outcome) {
    const auto self = weak.lock();
    if (!self) return;
    if ((*self)->held_) {
      (*self)->late_.emplace_back(id, outcome);
    } else {
      (*self)->answer(id, outcome);
    }
  });
}

MsgpackConnection::Result MsgpackConnection::run(const std::string& method,
                                                 const Arguments& arguments) {
  try {
    if (method == "authenticate") return authenticate(arguments);
    if (!may_call_) throw CallError("expected authenticate(user, token) first");
    is_open_ = true;
    if (method.find('.') == std::string::npos) return runOwn(method, arguments);
    const Member member = memberOf(method);
    return calls_.call(member.target, member.name, arguments);
  } catch (const CallError& error) {
    return Result::failed(error.what());
  }
}

MsgpackConnection::Result MsgpackConnection::runOwn(const std::string& method,
                                                    const Arguments& arguments) {
  if (method == "services") {
    expectCount(method, arguments, 0);
    return Result::done(rpc::toValue(calls_.serviceNames()));
  }
  if (method == "setProperty") {
    expectCount(method, arguments, 2);
    const Member member = memberOf(textOf(arguments[0]));
    return calls_.setProperty(member.target, member.name, arguments[1]);
  }
  expectCount(method, arguments, 1);
  if (method == "methods") return methods(textOf(arguments[0]));
  if (method == "subscribe") return subscribe(textOf(arguments[0]));
  if (method == "unsubscribe") {
    const bool known = calls_.unsubscribe(arguments[0].to<std::uint64_t>());
    return known ? Result::done() : Result::failed("no such subscription");
  }
  if (method == "release") {
    const std::string name = textOf(arguments[0]);
    const bool known = !name.empty() && calls_.release(std::atoll(name.c_str() + 1));
    return known ? Result::done() : Result::failed("no such object");
  }
  if (method != "property") throw CallError("expected Service.method, got " + method);
  const Member member = memberOf(textOf(arguments[0]));
  return calls_.property(member.target, member.name);
}

MsgpackConnection::Result MsgpackConnection::authenticate(const Arguments& arguments) {
  expectCount("authenticate", arguments, 2);
  const auto& credentials = hub_.options().credentials;
  if (may_call_ || credentials->accept(textOf(arguments[0]), textOf(arguments[1]))) {
    may_call_ = true;
    is_open_ = true;
    reader_.setMaxBytes(MsgpackReader::kMaxBytes);
    return Result::done(true);
  }
  if (++failures_ >= rpc::Credentials::kMostFailures) wants_close_ = true;
  return Result::failed("Authentication failed: expected a valid user and token.");
}

MsgpackConnection::Result MsgpackConnection::methods(const std::string& target) {
  Result result;
  calls_.find(target).whenDone([result](const auto& found) {
    if (!found.value) return result.fail(found.error.value_or("canceled"));
    std::vector<std::string> names;
    for (const auto& [uid, method] : (*found.value)->methods()) {
      if (std::find(names.begin(), names.end(), method.name) == names.end()) {
        names.push_back(method.name);
      }
    }
    result.resolve(rpc::toValue(names));
  });
  return result;
}

MsgpackConnection::Result MsgpackConnection::subscribe(const std::string& text) {
  const Member member = memberOf(text);
  const auto listener = [weak = std::weak_ptr(alive_), text](std::uint64_t /*link*/,
                                                             const Arguments& arguments) {
    const auto self = weak.lock();
    if (self) (*self)->notify(text, arguments);
  };
  return calls_.subscribe(member.target, member.name, listener);
}

// Events are never dropped silently.
void MsgpackConnection::notify(const std::string& signal, const Arguments& arguments) {
  try {
    sendNow(Value::list({kNotification, signal, Value::list(arguments)}));
  } catch (const CallError&) {  // the client has been given too many objects
    wants_close_ = true;
    if (broken_) broken_();
  }
}

void MsgpackConnection::answer(const Value& id, const rpc::Outcome<Value>& outcome) {
  const Value error = outcome.value ? Value() : Value(outcome.error.value_or("canceled"));
  try {
    sendNow(Value::list({kResponse, id, error, outcome.value.value_or(Value())}));
  } catch (const CallError& failure) {  // the client has been given too many objects
    sendNow(Value::list({kResponse, id, failure.what(), Value()}));
  }
}

void MsgpackConnection::sendNow(const Value& message) {
  if (!send_) return;
  Bytes bytes;
  packValue(bytes, message, name_of_);
  send_(std::move(bytes));
}

}  // namespace nao::wire
