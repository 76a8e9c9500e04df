#pragma once

#include <alvalue/alvalue.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "naoqi_api/value.h"
#include "naoqi_api/wire/frame.h"

namespace nao::client {

/// A module of this program as others see it on the wire: its methods, and those that all modules
/// have. Thread-safe.
class HostedObject {
 public:
  struct Method {
    std::string name;
    std::string parameters;  // signature, a tuple
    std::string returns;
    std::string meaning;
    std::string return_meaning;
    std::vector<std::pair<std::string, std::string>> arguments;  // name, meaning
    std::function<AL::ALValue(const std::vector<AL::ALValue>&)> call;
  };

  explicit HostedObject(std::string name) : name_(std::move(name)) {}
  ~HostedObject();

  void describe(const std::string& meaning);
  void add(Method method);

  /// Until then calls wait: a module may be entered before all its methods are known.
  void open();

  /// The answer to a call or a post of one of its actions. Waits for open() and for the method.
  wire::Message answer(const wire::Message& call);

 private:
  static constexpr std::uint32_t kFirstOfModule = 100;  // below: what every object has
  static constexpr std::uint32_t kFirstOwn = 113;       // below: what every module has

  void waitUntilOpen();
  rpc::Value resultOf(const wire::Message& call, std::string& returns);
  rpc::Value metaObject() const;
  rpc::Value callBase(const wire::Message& call, std::string& returns);
  rpc::Value callModule(const wire::Message& call, std::string& returns);
  rpc::Value callOwn(const Method& method, const rpc::Value& arguments) const;
  rpc::Value pCall(const std::vector<rpc::Value>& arguments);
  int post(std::uint32_t uid, const std::vector<rpc::Value>& arguments);
  bool wait(int id, int timeout_ms);
  bool isRunning(int id);
  Method methodAt(std::uint32_t uid) const;
  Method methodNamed(const std::string& name) const;

  const std::string name_;
  mutable std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::string meaning_;
  std::vector<Method> methods_;  // number i has the id kFirstOwn + i
  bool open_ = false;
  int last_task_ = 0;
  std::map<int, std::thread> tasks_;  // by id, those that run
};

}  // namespace nao::client
