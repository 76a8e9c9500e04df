#pragma once

#include <string>
#include <vector>

#include <boost/shared_ptr.hpp>

#include <alcore/alptr.h>
#include <alerror/alerror.h>
#include <alvalue/alvalue.h>
#include <usarnaoqi_sdk/cast.h>
#include <usarnaoqi_sdk/export.h>

namespace AL {

class ALBroker;
class ALModuleCore;

/// A service of a robot, or a module of another program. Thread-safe; copies are the same proxy.
/// An address may be redirected by the environment: NAOQI_ADDRESS=host[:port], or NAO_IP=host.
class USARNAOQI_SDK_API ALProxy {
 public:
  enum { kDefaultPort = 9559 };

  /// @throws ALError if nobody answers there or there is no such service.
  ALProxy(const std::string& name, const std::string& ip, int port = kDefaultPort);
  ALProxy(boost::shared_ptr<ALBroker> broker, const std::string& name);
  /// Through the first broker that ALBrokerManager keeps.
  explicit ALProxy(const std::string& name);
  ALProxy(boost::shared_ptr<ALBroker> broker, const std::string& name, const std::string& ip,
          int port);
  explicit ALProxy(boost::shared_ptr<ALProxy> other);
  virtual ~ALProxy();

  /// Calls and waits. @throws ALError with the robot's words.
  template <class R, class... P>
  R call(const std::string& method, const P&... arguments) const {
    return detail::Cast<R>::of(callWith(method, {ALValue(arguments)...}));
  }
  template <class... P>
  void callVoid(const std::string& method, const P&... arguments) const {
    callWith(method, {ALValue(arguments)...});
  }
  /// Calls and does not wait; the id is for wait(), isRunning() and stop().
  template <class... P>
  int pCall(const std::string& method, const P&... arguments) const {
    return postWith(method, {ALValue(arguments)...});
  }
  /// The same with the arguments in an array.
  void genericCall(const std::string& method, const ALValue& arguments, ALValue& result) const;
  int methodMissing(const std::string& method, const ALValue& arguments) const;

  ALValue callWith(const std::string& method, const std::vector<ALValue>& arguments) const;
  int postWith(const std::string& method, const std::vector<ALValue>& arguments) const;

  /// True if the time-out [ms] came first; 0: none.
  bool wait(int id, int timeout) const { return call<bool>("wait", id, timeout); }
  bool isRunning(int id) const { return call<bool>("isRunning", id); }
  void stop(int id) const { callVoid("stop", id); }

  void exit() const { callVoid("exit"); }
  bool ping() const { return call<bool>("ping"); }
  std::string version() const { return call<std::string>("version"); }
  std::string getBrokerName() const { return call<std::string>("getBrokerName"); }
  std::vector<std::string> getMethodList() const {
    return call<std::vector<std::string> >("getMethodList");
  }
  ALValue getMethodHelp(const std::string& method) const {
    return call<ALValue>("getMethodHelp", method);
  }
  ALValue getModuleHelp() const { return call<ALValue>("getModuleHelp"); }
  std::string getUsage(const std::string& method) const {
    return call<std::string>("getUsage", method);
  }

  const std::string& getModuleName() const;
  /// Whether the service lives in this process.
  bool isLocal() const;
  boost::shared_ptr<ALProxy> getGenericProxy() const;
  /// What only a local module may use: the DCM's loop.
  boost::shared_ptr<ALModuleCore> getModule() const;

 protected:
  struct Link;
  boost::shared_ptr<Link> link_;
};

}  // namespace AL
