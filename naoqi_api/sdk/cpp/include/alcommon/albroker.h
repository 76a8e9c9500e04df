#pragma once

#include <memory>
#include <string>
#include <vector>

#include <boost/enable_shared_from_this.hpp>
#include <boost/shared_ptr.hpp>
#include <boost/weak_ptr.hpp>

#include <alcommon/alproxy.h>
#include <alerror/alerror.h>
#include <alvalue/alvalue.h>
#include <usarnaoqi_sdk/export.h>

namespace AL {

class ALBrokerManager;
class ALMemoryProxy;
class ALModule;
class ALMotionProxy;
class DCMProxy;

/// This program's link to a robot's NaoQi, and the modules it offers there.
class USARNAOQI_SDK_API ALBroker : public boost::enable_shared_from_this<ALBroker> {
 public:
  /// Connects to the robot at parent_ip:parent_port. Modules are reached through that connection:
  /// nobody has to listen on ip:port, and both are only remembered.
  /// @throws ALError if nobody answers there.
  static boost::shared_ptr<ALBroker> createBroker(const std::string& name, const std::string& ip,
                                                  int port, const std::string& parent_ip,
                                                  int parent_port, int flags = 0,
                                                  const std::string& path = std::string(),
                                                  bool load_autoload = false);
  virtual ~ALBroker();

  const std::string& getName() const { return name_; }
  const std::string& getIP() const { return ip_; }
  int getPort() const { return port_; }
  const std::string& getParentIP() const { return parent_ip_; }
  int getParentPort() const { return parent_port_; }

  /// @throws ALError if there is no such service.
  boost::shared_ptr<ALProxy> getProxy(const std::string& name);
  template <class T>
  boost::shared_ptr<T> getSpecialisedProxy(const std::string& /*name*/) {
    return boost::shared_ptr<T>(new T(shared_from_this()));
  }
  // The proxy's own header is needed only where one of these is used.
  template <class T = ALMemoryProxy>
  boost::shared_ptr<T> getMemoryProxy() {
    return boost::shared_ptr<T>(new T(shared_from_this()));
  }
  template <class T = ALMotionProxy>
  boost::shared_ptr<T> getMotionProxy() {
    return boost::shared_ptr<T>(new T(shared_from_this()));
  }
  template <class T = DCMProxy>
  boost::shared_ptr<T> getDcmProxy() {
    return boost::shared_ptr<T>(new T(shared_from_this()));
  }

  bool isModulePresent(const std::string& name);
  std::vector<std::string> getGlobalModuleList();
  std::vector<std::string> getModuleList() const;
  boost::shared_ptr<ALModule> getModuleByName(const std::string& name) const;

  /// Ends its modules, then the connection. Also when the last one lets go of the broker.
  void shutdown();
  /// Whether the robot is still there.
  bool isConnected() const;

  /// Keeps a module until shutdown(); createModule() does it.
  void addModule(const boost::shared_ptr<ALModule>& module);

  boost::weak_ptr<ALBrokerManager> fBrokerManager;

  struct Inside;
  /// For the library itself.
  Inside& inside() const { return *inside_; }

 private:
  ALBroker(const std::string& name, const std::string& ip, int port, const std::string& parent_ip,
           int parent_port);

  std::string name_;
  std::string ip_;
  int port_;
  std::string parent_ip_;
  int parent_port_;
  std::unique_ptr<Inside> inside_;
};

}  // namespace AL
