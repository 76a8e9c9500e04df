#include "naoqi_api/sdk/cpp/src/hosted_object.h"

#include <alerror/alerror.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/sdk/cpp/src/value_bridge.h"
#include "naoqi_api/sdk/cpp/src/workers.h"
#include "naoqi_api/wire/codec.h"
#include "naoqi_api/wire/meta_signatures.h"

namespace nao::client {
namespace {

using rpc::CallError;
using rpc::Signature;
using rpc::Value;

struct Common {
  std::uint32_t uid;
  const char* name;
  const char* parameters;
  const char* returns;
};
// Every object's, and every module's from 100 on.
constexpr Common kCommon[] = {
    {0, "registerEvent", "(IIL)", "L"},
    {1, "unregisterEvent", "(IIL)", "v"},
    {2, "metaObject", "(I)", wire::meta::kMetaObject},
    {3, "terminate", "(I)", "v"},
    {5, "property", "(m)", "m"},
    {6, "setProperty", "(mm)", "v"},
    {7, "properties", "()", "[s]"},
    {8, "registerEventWithSignature", "(IILs)", "L"},
    {100, "exit", "()", "v"},
    {101, "__pCall", "(I[m])", "i"},
    {102, "pCall", "(m)", "m"},
    {103, "version", "()", "s"},
    {104, "ping", "()", "b"},
    {105, "getMethodList", "()", "[s]"},
    {106, "getMethodHelp", "(s)", "m"},
    {107, "getModuleHelp", "()", "m"},
    {108, "wait", "(ii)", "b"},
    {109, "isRunning", "(i)", "b"},
    {110, "stop", "(i)", "v"},
    {111, "getBrokerName", "()", "s"},
    {112, "getUsage", "(s)", "s"},
};

const Common& commonAt(std::uint32_t uid) {
  for (const Common& one : kCommon) {
    if (one.uid == uid) return one;
  }
  throw CallError("no method has the id " + std::to_string(uid));
}

Value entry(std::uint32_t uid, const HostedObject::Method& method) {
  std::vector<Value> parameters;
  for (const auto& [name, meaning] : method.arguments) {
    parameters.push_back(Value::tuple(wire::meta::kParameter, {name, meaning}));
  }
  return Value::tuple(
      wire::meta::kMethod,
      {uid, method.returns, method.name, method.parameters, method.meaning,
       Value::listOf(wire::meta::kParameter, std::move(parameters)), method.return_meaning});
}

Value argumentsOf(const wire::Message& call, const std::string& parameters) {
  const bool dynamic = (call.flags & wire::kFlagDynamic) != 0;
  const Value read = wire::Decoder(call.payload).read(dynamic ? "m" : parameters);
  auto fitting = rpc::convert(read, Signature::of(parameters), rpc::Bend::Loose);
  if (!fitting) throw CallError("expected " + parameters + ", got " + read.print());
  return *std::move(fitting);
}

Value answerAs(const Value& value, const std::string& returns) {
  if (returns == "v") return {};
  auto fitting = rpc::convert(value, Signature::of(returns), rpc::Bend::Loose);
  if (!fitting) throw CallError("the result is not " + returns + ": " + value.print());
  return *std::move(fitting);
}

}  // namespace

HostedObject::~HostedObject() {
  for (auto& [id, task] : std::exchange(tasks_, {})) {
    task.get_id() == std::this_thread::get_id() ? task.detach() : task.join();
  }
}

void HostedObject::describe(const std::string& meaning) {
  const std::lock_guard lock(mutex_);
  meaning_ = meaning;
}

void HostedObject::add(Method method) {
  const std::lock_guard lock(mutex_);
  methods_.push_back(std::move(method));
}

void HostedObject::open() {
  const std::lock_guard lock(mutex_);
  open_ = true;
  changed_.notify_all();
}

wire::Message HostedObject::answer(const wire::Message& call) {
  waitUntilOpen();
  wire::Message answer;
  answer.id = call.id;
  answer.address = call.address;
  answer.type = wire::MessageType::Reply;
  try {
    std::string returns;
    const Value result = resultOf(call, returns);
    wire::encode(answer.payload, answerAs(result, returns), Signature::of(returns));
  } catch (const std::exception& error) {
    answer.type = wire::MessageType::Error;
    answer.payload.clear();
    wire::encodeDynamic(answer.payload, Value(error.what()));
  }
  return answer;
}

void HostedObject::waitUntilOpen() {
  std::unique_lock lock(mutex_);
  if (open_) return;
  lock.unlock();
  const Workers::Waiting waiting;
  lock.lock();
  changed_.wait(lock, [this] { return open_; });
}

Value HostedObject::resultOf(const wire::Message& call, std::string& returns) {
  const std::uint32_t uid = call.address.action;
  if (uid < kFirstOfModule) return callBase(call, returns);
  if (uid < kFirstOwn) return callModule(call, returns);
  const Method method = methodAt(uid);
  returns = method.returns;
  return callOwn(method, argumentsOf(call, method.parameters));
}

Value HostedObject::metaObject() const {
  Value::Map methods{"I", wire::meta::kMethod, {}};
  for (const Common& one : kCommon) {
    methods.entries.emplace_back(
        Value(one.uid),
        entry(one.uid, Method{one.name, one.parameters, one.returns, "", "", {}, {}}));
  }
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < methods_.size(); ++i) {
    const auto uid = static_cast<std::uint32_t>(kFirstOwn + i);
    methods.entries.emplace_back(Value(uid), entry(uid, methods_[i]));
  }
  return Value::tuple(wire::meta::kMetaObject,
                      {std::move(methods), Value::Map{"I", wire::meta::kSignal, {}},
                       Value::Map{"I", wire::meta::kProperty, {}}, meaning_});
}

// Modules have no signals or properties of their own.
Value HostedObject::callBase(const wire::Message& call, std::string& returns) {
  const Common& method = commonAt(call.address.action);
  returns = method.returns;
  const Value arguments = argumentsOf(call, method.parameters);
  switch (method.uid) {
    case 2:
      return metaObject();
    case 7:
      return Value::listOf("s", {});
    case 1:
    case 3:
      return {};
    default:
      throw CallError(name_ + " has no signals and no properties");
  }
}

Value HostedObject::callModule(const wire::Message& call, std::string& returns) {
  const Common& method = commonAt(call.address.action);
  returns = method.returns;
  const Value tuple = argumentsOf(call, method.parameters);
  const std::vector<Value>& arguments = *tuple.findItems();
  const std::string name = method.name;
  if (name == "exit") throw CallError("a client can not end a module");
  if (name == "__pCall") return post(arguments[0].to<std::uint32_t>(), *arguments[1].findItems());
  if (name == "pCall") return pCall(arguments);
  if (name == "version") return "usarnaoqi";
  if (name == "ping") return true;
  if (name == "wait") return wait(arguments[0].to<int>(), arguments[1].to<int>());
  if (name == "isRunning") return isRunning(arguments[0].to<int>());
  if (name == "stop") throw CallError(name_ + ": a method that runs can not be stopped");
  if (name == "getBrokerName") return name_;
  if (name == "getMethodHelp") {
    const Method found = methodNamed(arguments[0].to<std::string>());
    return Value::list({found.name, found.meaning});
  }
  if (name == "getUsage") return methodNamed(arguments[0].to<std::string>()).meaning;
  const std::lock_guard lock(mutex_);
  if (name == "getModuleHelp") return Value::list({name_, meaning_});
  std::vector<Value> names;
  for (const Method& one : methods_) names.emplace_back(one.name);
  return Value::listOf("s", std::move(names));
}

Value HostedObject::callOwn(const Method& method, const Value& arguments) const {
  std::vector<AL::ALValue> items;
  for (const Value& item : *arguments.findItems()) items.push_back(fromWire(item));
  return toWire(method.call(items));
}

Value HostedObject::pCall(const std::vector<Value>& arguments) {
  const auto* items = arguments[0].findItems();
  if (!items || items->empty()) throw CallError("expected [method, arguments...]");
  const Method method = methodNamed(items->front().to<std::string>());
  const Value tuple = Value::tuple(std::vector<Value>(items->begin() + 1, items->end()));
  const auto fitting = rpc::convert(tuple, Signature::of(method.parameters), rpc::Bend::Loose);
  if (!fitting) throw CallError("expected " + method.parameters + ", got " + tuple.print());
  return callOwn(method, *fitting);
}

int HostedObject::post(std::uint32_t uid, const std::vector<Value>& arguments) {
  const Method method = methodAt(uid);
  const Value tuple = Value::tuple(arguments);
  const auto fitting = rpc::convert(tuple, Signature::of(method.parameters), rpc::Bend::Loose);
  if (!fitting) throw CallError("expected " + method.parameters + ", got " + tuple.print());
  const std::lock_guard lock(mutex_);
  const int id = ++last_task_;
  tasks_[id] = std::thread([this, id, method, arguments_there = *fitting] {
    try {
      callOwn(method, arguments_there);
    } catch (const std::exception&) {
      // Who posts a call does not ask how it ended.
    }
    const std::lock_guard end(mutex_);
    const auto found = tasks_.find(id);
    if (found == tasks_.end()) return;
    found->second.detach();
    tasks_.erase(found);
    changed_.notify_all();
  });
  return id;
}

bool HostedObject::wait(int id, int timeout_ms) {
  const Workers::Waiting waiting;
  std::unique_lock lock(mutex_);
  const auto over = [this, id] { return tasks_.count(id) == 0; };
  if (timeout_ms <= 0) return changed_.wait(lock, over), false;
  return !changed_.wait_for(lock, std::chrono::milliseconds(timeout_ms), over);
}

bool HostedObject::isRunning(int id) {
  const std::lock_guard lock(mutex_);
  return tasks_.count(id) > 0;
}

HostedObject::Method HostedObject::methodAt(std::uint32_t uid) const {
  const std::lock_guard lock(mutex_);
  if (uid < kFirstOwn || uid - kFirstOwn >= methods_.size()) {
    throw CallError(name_ + ": no method has the id " + std::to_string(uid));
  }
  return methods_[uid - kFirstOwn];
}

HostedObject::Method HostedObject::methodNamed(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(methods_.begin(), methods_.end(),
                                  [&](const Method& method) { return method.name == name; });
  if (found == methods_.end()) throw CallError(name_ + " has no method " + name);
  return *found;
}

}  // namespace nao::client
