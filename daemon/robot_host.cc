#include "daemon/robot_host.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <filesystem>

#include "daemon/epoch.h"
#include "daemon/machine_id.h"

namespace nao::daemon {

RobotHost::RobotHost(const HostContext& context, std::size_t robot)
    : link_(context.simulation.robot(robot).sharedModel(), context.simulation.robot(robot).ports()),
      images_(std::make_shared<camera::ImageFeed>()),
      pictures_(std::make_shared<camera::RenderQueue>(images_)),
      usar_sim_(context.loop, context.simulation.truth(), robot,
                {context.options.seed, context.simulation.world().draw()}),
      services_(link_, servicesSetup(context, robot)),
      hub_(hubOptions(context)) {
  services_.addTo(hub_);
  usar_sim_.watch(images_, pictures_);
  hub_.add(usar_sim_.describe());
  if (context.options.wire_faults)
    wire_ = std::make_unique<WireDelay>(context.options.seed + robot);
  endpoints_ = std::make_unique<RobotEndpoints>(context.io, context.options, robot, hub_,
                                                context.gate, wire_.get());
  if (!context.lola.empty()) offerLola(context, robot);
}

void RobotHost::offerLola(const HostContext& context, std::size_t robot) {
  const Options& options = context.options;
  const std::string& name = context.simulation.robotName(robot);
  lola_ = std::make_unique<LolaServer>(
      context.io, context.lola,
      LolaServer::Robot{name, link_.sharedModel(), context.simulation.robot(robot).ports()},
      [&loop = context.loop, locked = options.lola_lockstep.has_value()] {
        if (locked) loop.wake();
      });
  LolaCameras::Setup cameras{link_.sharedModel(), images_, options.lolaCameraHosts(), {}, {}};
  if (const auto first = options.lola_camera_port) {
    // Both of a robot's ports are below the last one.
    portOf(*first, 2 * context.lola_before + 1, "--lola-camera-port");
    cameras.top_port = portOf(*first, 2 * context.lola_before, "--lola-camera-port");
  }
  if (!options.lola_camera_memory.empty()) {
    cameras.memory = options.lola_camera_memory + "." + name;
  }
  if (cameras.top_port || !cameras.memory.empty()) {
    lola_cameras_ = std::make_unique<LolaCameras>(context.io, cameras);
  }
}

rpc::HubOptions RobotHost::hubOptions(const HostContext& context) {
  rpc::HubOptions options;
  options.personality = personality(context);
  options.machine_id = machineId();
  options.process_id = static_cast<std::uint32_t>(::getpid());
  options.credentials = context.credentials;
  options.alarm = services_.alarm();
  options.task_ids = context.task_ids;
  options.clock = [this] { return services_.now(); };
  return options;
}

rpc::Personality RobotHost::personality(const HostContext& context) const {
  if (context.options.strict) return rpc::Personality::libqi4();
  if (!context.options.naoqi.empty()) return rpc::Personality::naoqi(context.options.naoqi);
  return rpc::Personality::naoqiOf(link_.model().version);
}

services::RobotServicesSetup RobotHost::servicesSetup(const HostContext& context,
                                                      std::size_t robot) {
  services::RobotServicesSetup setup;
  setup.ports = context.simulation.robot(robot).ports();
  setup.images = images_;
  setup.robot_name = context.simulation.robotName(robot);
  setup.epoch = kEpoch;
  const auto own =
      std::filesystem::path(context.options.robots_dir) / link_.model().name / "motions";
  if (std::filesystem::is_directory(own)) setup.behaviors.push_back(own);
  for (const std::string& folder : context.options.behaviors) setup.behaviors.push_back(folder);
  setup.scripts = scriptLauncher(context);
  setup.personality = personality(context);
  setup.data_dir = context.options.data_dir;
  setup.log = [](const std::string& text) { spdlog::info("{}", text); };
  setup.warn = [](const std::string& text) { spdlog::warn("{}", text); };
  return setup;
}

services::ScriptLauncher RobotHost::scriptLauncher(const HostContext& context) {
  const Options& options = context.options;
  if (options.scripts.empty()) return {};
  const std::string& first = options.listen.front();
  const bool everywhere = first == "0.0.0.0" || first == "::";
  const ScriptProcess::Job job{
      {}, options.scripts, everywhere ? "127.0.0.1" : first, context.script_token};
  return [this, &io = context.io, job](const auto& file, auto ended) {
    ScriptProcess::Job started = job;
    started.file = file;
    started.address += ":" + std::to_string(endpoints_->qiPort());
    const auto place = std::make_shared<std::weak_ptr<ScriptProcess>>();
    const auto process =
        ScriptProcess::start(io, started, [this, place, ended](const std::string& failure) {
          scripts_.erase(place->lock());
          ended(failure);
        });
    *place = process;
    scripts_.insert(process);
    return [weak = std::weak_ptr<ScriptProcess>(process)] {
      if (const auto running = weak.lock()) running->stop();
    };
  };
}

void RobotHost::deliver(const std::vector<LoopOutcome>& outcomes) {
  link_.deliver();
  services_.deliver();
  usar_sim_.deliver(outcomes);
  if (wire_) wire_->advance(link_.now());
  if (lola_) lola_->deliver();
  if (lola_cameras_) lola_cameras_->deliver();
}

}  // namespace nao::daemon
