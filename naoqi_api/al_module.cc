#include "naoqi_api/al_module.h"

#include <algorithm>

#include "naoqi_api/tasks.h"

namespace nao::rpc {
namespace {

using Arguments = std::vector<Value>;

constexpr char kVersion[] = "2.1.4.13";  // the NAOqi whose behaviour is followed

void exitModule() { throw CallError("not simulated: a client can not end a module"); }

std::string version() { return kVersion; }

bool ping() { return true; }

std::string brokerName() { return "MainBroker"; }

Tasks& tasksOf(const Caller& caller) {
  if (!caller.tasks) throw CallError("no tasks here");
  return *caller.tasks;
}

// The result of calling by uid, or by name, as pCall's first argument says.
Pending<Value> callAny(const Caller& caller, const Value& member, const Arguments& arguments) {
  if (const std::string* name = member.findText()) {
    return caller.service->call(*name, arguments, caller);
  }
  const auto uid = member.to<std::uint32_t>();
  const Method* method = caller.service->findMethod(uid);
  if (!method) throw CallError("no method has the id " + std::to_string(uid));
  return method->invoke(caller, arguments);
}

int post(const Caller& caller, std::uint32_t uid, const Arguments& arguments) {
  Tasks& tasks = tasksOf(caller);
  return tasks.start(callAny(caller, Value(uid), arguments), caller.session);
}

Pending<Value> callNow(const Caller& caller, const Value& call) {
  const Arguments* items = call.findItems();
  if (!items || items->empty()) throw CallError("expected [method, arguments...]");
  return callAny(caller, items->front(), Arguments(items->begin() + 1, items->end()));
}

Pending<bool> wait(const Caller& caller, int id, int timeout_ms) {
  return tasksOf(caller).wait(id, timeout_ms);
}

Pending<void> waitForEnd(const Caller& caller, int id) {
  const Pending<bool> ended = tasksOf(caller).wait(id, 0);
  Pending<void> result;
  ended.whenDone([result](const auto& outcome) {
    outcome.isCanceled() ? result.cancelNow() : result.resolve();
  });
  result.cancelsWith(ended);
  return result;
}

bool isRunning(const Caller& caller, int id) { return tasksOf(caller).isRunning(id); }

void stop(const Caller& caller, int id) { tasksOf(caller).stop(id); }

std::vector<std::string> methodList(const Caller& caller) {
  std::vector<std::string> names;
  for (const auto& [uid, method] : caller.service->methods()) {
    if (std::find(names.begin(), names.end(), method.name) == names.end()) {
      names.push_back(method.name);
    }
  }
  return names;
}

const Method& methodNamed(const Caller& caller, const std::string& name) {
  for (const auto& [uid, method] : caller.service->methods()) {
    if (method.name == name) return method;
  }
  throw CallError("no method has the name " + name);
}

// [name, meaning, [[argument, meaning], ...], [return signature, meaning]]
Value methodHelp(const Caller& caller, const std::string& name) {
  const Method& method = methodNamed(caller, name);
  Arguments arguments;
  for (const Argument& argument : method.arguments) {
    arguments.push_back(Value::list({argument.name, argument.meaning}));
  }
  return Value::list({method.name, method.meaning, Value::list(std::move(arguments)),
                      Value::list({method.return_signature, method.return_meaning})});
}

Value moduleHelp(const Caller& caller) {
  return Value::list({caller.service->name(), caller.service->meaning()});
}

std::string usage(const Caller& caller, const std::string& name) {
  const Method& method = methodNamed(caller, name);
  std::string text = name + method.parameters_signature + " -> " + method.return_signature;
  if (!method.meaning.empty()) text += ": " + method.meaning;
  return text;
}

template <class R, class... P>
std::function<R(P...)> function(R (*plain)(P...)) {
  return plain;
}

const Argument kTask{"id", "What .post returned."};

}  // namespace

void addShortWait(Service& service) {
  constexpr std::uint32_t kWait = 108;
  const Method* wait = service.findMethod(kWait);
  if (!wait || wait->name != "wait") return;
  service.method("wait", function(waitForEnd), "Waits for a posted call without a limit.", kTask);
}

Service alModule(std::string name, std::string meaning) {
  return Service(std::move(name), std::move(meaning))
      .method("exit", function(exitModule), "Ends the module; refused here.")
      .method("__pCall", function(post), "Starts a method without waiting for it: .post.",
              Argument{"method", "Its id."}, Argument{"arguments", "Its arguments."})
      .method("pCall", function(callNow), "Calls a method by name or id.",
              Argument{"call", "[method, arguments...]"})
      .method("version", function(version), "The version of NAOqi that is simulated.")
      .method("ping", function(ping), "Always true.")
      .method("getMethodList", function(methodList), "The names of the methods.")
      .method("getMethodHelp", function(methodHelp), "What a method does and takes.",
              Argument{"methodName", "Its name."})
      .method("getModuleHelp", function(moduleHelp), "What the module is for.")
      .method("wait", function(wait), "Waits for a posted call; true if the time-out came first.",
              kTask, Argument{"timeoutPeriod", "[ms] of simulated time; 0: no limit."})
      .method("isRunning", function(isRunning), "Whether a posted call has not ended.", kTask)
      .method("stop", function(stop), "Stops a posted call, if it can be stopped.", kTask)
      .method("getBrokerName", function(brokerName), "The name of the broker.")
      .method("getUsage", function(usage), "One line on a method.", Argument{"name", "Its name."});
}

}  // namespace nao::rpc
