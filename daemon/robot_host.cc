#include "daemon/robot_host.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <filesystem>

#include "daemon/machine_id.h"
#include "naoqi_api/services/al_animation_player.h"
#include "naoqi_api/services/al_behavior_manager.h"
#include "naoqi_api/services/al_frame_manager.h"
#include "naoqi_api/services/al_motion.h"
#include "naoqi_api/services/al_robot_posture.h"
#include "naoqi_api/wire/qi_connection.h"

namespace nao::daemon {
namespace {

// NaoQi's clock at the start of every world, so that runs repeat: 13 March 2011.
constexpr std::chrono::seconds kEpoch{1300000000};

}  // namespace

RobotHost::RobotHost(const HostContext& context, std::size_t robot)
    : link_(context.simulation.robot(robot).sharedModel(), context.simulation.robot(robot).ports()),
      images_(std::make_shared<camera::ImageFeed>()),
      pictures_(std::make_shared<camera::RenderQueue>(images_)),
      usar_sim_(context.loop, context.simulation.truth(), robot,
                {context.options.seed, context.simulation.world().draw()}),
      video_(link_.sharedModel(), images_, kEpoch),
      memory_(link_.model(), context.simulation.robot(robot).ports(),
              context.simulation.robotName(robot), [this] { return naoqiTime(); }),
      al_memory_(memory_, [this](const std::string& name) { return hub_.findRemote(name); }),
      motion_events_(link_, memory_),
      speech_(memory_.store(), callLater(),
              [](const std::string& text) { spdlog::info("says: {}", text); }),
      system_(memory_.store(), context.simulation.robotName(robot)),
      behaviors_(std::make_shared<services::BehaviorRunner>(link_, installedBehaviors(context),
                                                            behaviorHooks(context))),
      hub_(hubOptions(context)) {
  addServices();
  const Address address{context.options.listen, portOf(context.options, robot), "--port"};
  server_ = std::make_unique<Server>(
      context.io, address, [this](const std::string& endpoint, wire::Connection::Send send) {
        return std::make_unique<wire::QiConnection>(hub_, endpoint, std::move(send));
      });
}

rpc::HubOptions RobotHost::hubOptions(const HostContext& context) {
  rpc::HubOptions options;
  options.personality =
      context.options.strict ? rpc::Personality::libqi4() : rpc::Personality::naoqi();
  options.machine_id = machineId();
  options.process_id = static_cast<std::uint32_t>(::getpid());
  options.call_later = callLater();
  options.clock = [this] { return naoqiTime(); };
  return options;
}

rpc::CallLater RobotHost::callLater() {
  return
      [this](Duration delay, std::function<void()> then) { link_.after(delay, std::move(then)); };
}

Duration RobotHost::naoqiTime() const { return kEpoch + link_.now().time_since_epoch(); }

std::shared_ptr<services::BehaviorLibrary> RobotHost::installedBehaviors(
    const HostContext& context) const {
  namespace fs = std::filesystem;
  auto library = std::make_shared<services::BehaviorLibrary>();
  const fs::path own = fs::path(context.options.robots_dir) / link_.model().name / "motions";
  if (fs::is_directory(own)) library->addFolder(own);
  for (const std::string& folder : context.options.behaviors) library->addFolder(folder);
  return library;
}

services::ScriptLauncher RobotHost::scriptLauncher(const HostContext& context) {
  const Options& options = context.options;
  if (options.scripts.empty()) return {};
  const bool everywhere = options.listen == "0.0.0.0" || options.listen == "::";
  const std::string host = everywhere ? "127.0.0.1" : options.listen;
  return [this, &io = context.io, modules = options.scripts, host](const auto& file, auto ended) {
    const auto place = std::make_shared<std::weak_ptr<ScriptProcess>>();
    const auto process =
        ScriptProcess::start(io, {file, modules, host + ":" + std::to_string(port())},
                             [this, place, ended](const std::string& failure) {
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

services::BehaviorRunner::Hooks RobotHost::behaviorHooks(const HostContext& context) {
  return {[](const std::string& text) { spdlog::warn("{}", text); },
          [this](const std::vector<std::string>& running) {
            memory_.store().raiseEvent("BehaviorsRun", rpc::toValue(running));
          },
          scriptLauncher(context)};
}

void RobotHost::addServices() {
  const auto warn = [](const std::string& text) { spdlog::warn("{}", text); };
  hub_.add(al_memory_.describe());
  hub_.add(system_.describe());
  hub_.add(speech_.describe());
  hub_.add(services::makeAlMotion(link_));
  hub_.add(services::makeAlRobotPosture(link_));
  hub_.add(services::makeAlFrameManager(
      link_, warn, std::make_shared<services::BehaviorLibrary>(behaviors_->library())));
  hub_.add(services::makeAlBehaviorManager(behaviors_));
  hub_.add(services::makeAlAnimationPlayer(behaviors_));
  hub_.add(video_.describe());
  hub_.add(usar_sim_.describe());
}

void RobotHost::deliver(const std::vector<LoopOutcome>& outcomes) {
  link_.deliver();
  motion_events_.deliver();
  video_.deliverImages();
  usar_sim_.deliver(outcomes);
}

}  // namespace nao::daemon
