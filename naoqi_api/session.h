#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace nao::rpc {

class RemoteObject;

/// One client connection as services see it. I/O thread only.
class Session {
 public:
  Session(std::uint64_t id, std::string endpoint) : id_(id), endpoint_(std::move(endpoint)) {}
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  /// Unique within the process, never reused: a key for what belongs to one client.
  std::uint64_t id() const { return id_; }

  /// The address the client dialled, as tcp://host:port.
  const std::string& endpoint() const { return endpoint_; }

  /// `ended` is called once when the client has gone. Returns the number to forget it with.
  std::uint64_t onEnd(std::function<void()> ended);
  void forgetEnd(std::uint64_t link) { ended_.erase(link); }

  /// The service of that number that this client hosts, as object 1 on its own connection; null
  /// where the wire can not call back.
  std::shared_ptr<RemoteObject> reach(std::uint32_t service) const {
    return reach_ ? reach_(service) : nullptr;
  }
  using Reach = std::function<std::shared_ptr<RemoteObject>(std::uint32_t service)>;
  void setReach(Reach reach) { reach_ = std::move(reach); }

  /// The client has gone: calls what was left with onEnd(). For the connection only.
  void end();

  /// Whether the client said it understands services reached as qi:<name>.
  bool takesRelativeEndpoints() const { return takes_relative_endpoints_; }
  void setTakesRelativeEndpoints(bool takes) { takes_relative_endpoints_ = takes; }

 private:
  std::uint64_t id_;
  std::string endpoint_;
  bool takes_relative_endpoints_ = false;
  Reach reach_;
  std::uint64_t next_link_ = 1;
  std::map<std::uint64_t, std::function<void()>> ended_;
};

}  // namespace nao::rpc
