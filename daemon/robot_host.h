#pragma once

#include <boost/asio/io_context.hpp>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "camera/image_feed.h"
#include "camera/render_queue.h"
#include "daemon/lola_cameras.h"
#include "daemon/lola_server.h"
#include "daemon/options.h"
#include "daemon/robot_endpoints.h"
#include "daemon/robot_loop.h"
#include "daemon/script_process.h"
#include "daemon/usar_sim.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service_hub.h"
#include "naoqi_api/services/robot_services.h"

namespace nao::daemon {

/// What all robots of one daemon share.
struct HostContext {
  boost::asio::io_context& io;
  RobotLoop& loop;
  runtime::Simulation& simulation;
  const Options& options;
  std::shared_ptr<const rpc::Credentials> credentials;  // null: every client is let in
  std::shared_ptr<rpc::TaskIds> task_ids;
  std::string script_token;     // that the code in boxes names; empty: none is asked for
  std::string lola;             // path of the robot's LoLA socket; empty: it has none
  std::size_t lola_before = 0;  // how many robots before it have one
  TurnGate* gate = nullptr;     // before the sockets of clients that take turns with the world
};

/// One robot as its clients see it: its services, their directory and the port it listens on.
/// I/O thread; made and destroyed while the simulation thread stands.
class RobotHost {
 public:
  /// @throws InputError when the port can not be listened on.
  RobotHost(const HostContext& context, std::size_t robot);

  const RobotEndpoints& endpoints() const { return *endpoints_; }
  const std::shared_ptr<camera::RenderQueue>& pictures() const { return pictures_; }

  /// What its ALVideoDevice answers to getImageRemote, or getDirectRawImageRemote.
  rpc::Pending<rpc::Value> picture(const std::string& window, bool raw) {
    return services_.video().picture(window, raw);
  }

  memory::RobotMemory& memory() { return services_.memory(); }

  /// The robot's wire, or null unless it can be disturbed.
  WireDelay* wire() { return wire_.get(); }

  /// The robot's LoLA socket; null: it has none.
  const LolaServer* lola() const { return lola_.get(); }
  LolaServer* lola() { return lola_.get(); }
  /// The ports of its cameras for LoLA programs, top first; empty: there are none.
  std::vector<std::uint16_t> lolaCameraPorts() const {
    return lola_cameras_ ? lola_cameras_->ports() : std::vector<std::uint16_t>();
  }

  /// Hands on what the simulation and the camera have published since.
  void deliver(const std::vector<LoopOutcome>& outcomes);

  /// No more clients; calls and scripts under way end.
  void close() {
    endpoints_->close();
    if (lola_) lola_->close();
    if (lola_cameras_) lola_cameras_->close();
    scripts_.clear();
  }

 private:
  void offerLola(const HostContext& context, std::size_t robot);
  rpc::HubOptions hubOptions(const HostContext& context);
  rpc::Personality personality(const HostContext& context) const;
  services::RobotServicesSetup servicesSetup(const HostContext& context, std::size_t robot);
  services::ScriptLauncher scriptLauncher(const HostContext& context);

  services::RobotLink link_;
  std::shared_ptr<camera::ImageFeed> images_;
  std::shared_ptr<camera::RenderQueue> pictures_;
  UsarSim usar_sim_;
  services::RobotServices services_;
  rpc::ServiceHub hub_;
  std::unique_ptr<WireDelay> wire_;
  std::unique_ptr<RobotEndpoints> endpoints_;
  std::unique_ptr<LolaServer> lola_;
  std::unique_ptr<LolaCameras> lola_cameras_;
  std::set<std::shared_ptr<ScriptProcess>> scripts_;  // that run
};

}  // namespace nao::daemon
