#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>
#include <vector>

#include "daemon/options.h"
#include "daemon/server.h"
#include "daemon/turn_gate.h"
#include "daemon/web_server.h"
#include "daemon/wire_delay.h"
#include "naoqi_api/service_hub.h"

namespace nao::daemon {

/// Every way to reach one robot's services: qi, and as the options say qi over TLS, msgpack-RPC and
/// the web. I/O thread. The hub outlives it.
class RobotEndpoints {
 public:
  /// With a gate, clients of qi and msgpack-RPC are heard when it opens; with a wire, all that they
  /// say and hear goes over it.
  /// @throws InputError when a port can not be listened on, or the options leave it open to all.
  RobotEndpoints(boost::asio::io_context& io, const Options& options, std::size_t robot,
                 rpc::ServiceHub& hub, TurnGate* gate = nullptr, WireDelay* wire = nullptr);

  std::uint16_t qiPort() const { return qi_->port(); }
  /// Where its clients come through the gate, if there is one.
  std::vector<std::uint16_t> gatedPorts() const;

  /// Those beside qi on the first host, as URLs.
  std::vector<std::string> otherAddresses() const;

  void close();

 private:
  std::vector<std::string> hosts_;
  std::unique_ptr<Server> qi_;
  std::unique_ptr<Server> tls_;
  std::unique_ptr<Server> msgpack_;
  std::unique_ptr<WebServer> web_;
};

}  // namespace nao::daemon
