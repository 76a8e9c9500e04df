#pragma once

#include <memory>
#include <string>

#include <boost/enable_shared_from_this.hpp>
#include <boost/shared_ptr.hpp>

#include <alcommon/albroker.h>
#include <alcommon/almodulecore.h>
#include <alcommon/alproxy.h>
#include <alvalue/alvalue.h>
#include <usarnaoqi_sdk/export.h>
#include <usarnaoqi_sdk/functor.h>

namespace AL {

/// A module of this program: once made, the robot and its other clients call the methods that its
/// constructor binds, under its name. Calls come on threads of its own, one after the other; while
/// one waits for an answer the next may begin.
class USARNAOQI_SDK_API ALModule : public ALModuleCore,
                                   public boost::enable_shared_from_this<ALModule> {
 public:
  /// Enters the module. @throws ALError if its name is taken or the robot is gone.
  ALModule(boost::shared_ptr<ALBroker> broker, const std::string& name);
  virtual ~ALModule();

  /// Called once it has been made, by createModule().
  virtual void init() {}
  virtual void exit();

  /// Makes a T and keeps it until its broker is shut down. Calls wait until it is whole.
  template <class T>
  static boost::shared_ptr<T> createModule(boost::shared_ptr<ALBroker> broker,
                                           const std::string& name) {
    const Making making;
    return making.finish(broker, boost::shared_ptr<T>(new T(broker, name)));
  }
  template <class T, class P>
  static boost::shared_ptr<T> createModule(boost::shared_ptr<ALBroker> broker,
                                           const std::string& name, const P& argument) {
    const Making making;
    return making.finish(broker, boost::shared_ptr<T>(new T(broker, name, argument)));
  }

  boost::shared_ptr<ALBroker> getParentBroker() const;
  std::string getBrokerName() const;
  bool isRemoteModule() const { return true; }
  std::string version() const { return std::string(); }
  std::string httpGet() const { return std::string(); }

  void setModuleDescription(const std::string& meaning);

  /// Names the method that the next BIND_METHOD binds.
  void functionName(const std::string& name, const std::string& module, const std::string& meaning,
                    int flags = 0);
  void addParam(const std::string& name, const std::string& meaning);
  void setReturn(const std::string& name, const std::string& meaning);
  void addMethodExample(const std::string& /*language*/, const std::string& /*code*/) {}
  void addModuleExample(const std::string& /*language*/, const std::string& /*code*/) {}
  void setExamplePath(const std::string& /*path*/) {}

  /// BIND_METHOD's work.
  void bindFunctor(const detail::Functor& functor);

 private:
  class USARNAOQI_SDK_API Making {
   public:
    Making();
    ~Making();
    Making(const Making&) = delete;
    Making& operator=(const Making&) = delete;
    template <class T>
    boost::shared_ptr<T> finish(const boost::shared_ptr<ALBroker>& broker,
                                const boost::shared_ptr<T>& module) const {
      begin(broker, module);
      return module;
    }

   private:
    static void begin(const boost::shared_ptr<ALBroker>& broker,
                      const boost::shared_ptr<ALModule>& module);
  };

  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace AL

/// Binds Class::method, which functionName() has named, in the constructor of Class. Parameters and
/// result: bool, int, float, double, std::string, ALValue, vectors of these, or const references.
#define BIND_METHOD(method) this->bindFunctor(::AL::detail::makeFunctor(this, &method));
