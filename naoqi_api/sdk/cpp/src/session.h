#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "naoqi_api/sdk/cpp/src/connection.h"
#include "naoqi_api/sdk/cpp/src/hosted_object.h"
#include "naoqi_api/sdk/cpp/src/workers.h"
#include "naoqi_api/signature.h"

namespace nao::client {

/// A program's link to one robot: finds services, calls their methods, and offers modules of its
/// own that the robot and its other clients call. Thread-safe.
class Session {
 public:
  /// @throws std::runtime_error if nobody answers there.
  explicit Session(const Endpoint& endpoint);
  ~Session();

  /// The one to that robot that this program has already, or a new one.
  static std::shared_ptr<Session> shared(const Endpoint& endpoint);

  const Endpoint& endpoint() const { return endpoint_; }
  bool isOpen() const { return connection_->isOpen(); }

  /// Looks it up anew: a module may have come back. @throws rpc::CallError if there is none.
  void find(const std::string& service);

  /// The overload for exactly these types is taken, else the first that they can be bent to.
  /// @throws rpc::CallError
  rpc::Value call(const std::string& service, const std::string& method,
                  const std::vector<rpc::Value>& arguments);

  /// Starts a call; the id is for wait(), isRunning() and stop() of that service.
  int post(const std::string& service, const std::string& method,
           const std::vector<rpc::Value>& arguments);

  /// Enters a module under its name; it is called from now on, on threads of this session.
  /// @throws rpc::CallError if the name is taken.
  std::uint32_t offer(const std::string& name, std::shared_ptr<HostedObject> object);
  void withdraw(std::uint32_t id);

  /// Ends all calls, ours and those under way here.
  void close();

 private:
  struct Method {
    std::uint32_t uid = 0;
    std::string name;
    std::string parameters;
    std::string returns;
  };
  struct Service {
    std::uint32_t id = 0;
    std::vector<Method> methods;
  };
  struct Chosen {
    std::uint32_t service = 0;
    Method method;
    rpc::Value arguments;  // fitting
  };

  std::shared_ptr<const Service> findService(const std::string& name);
  std::shared_ptr<const Service> fetch(const std::string& name);
  Chosen choose(const std::string& service, const std::string& method,
                const std::vector<rpc::Value>& arguments);
  void take(const wire::Message& call);

  Endpoint endpoint_;
  Workers workers_;
  std::mutex mutex_;  // of what follows
  std::map<std::string, std::shared_ptr<const Service>> services_;
  std::map<std::uint32_t, std::shared_ptr<HostedObject>> hosted_;
  std::unique_ptr<Connection> connection_;
};

}  // namespace nao::client
