#include "daemon/daemon.h"

#include <algorithm>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <csignal>

#include "core/check.h"
#include "core/suspend.h"
#include "daemon/local_pictures.h"
#include "daemon/random_name.h"

namespace nao::daemon {
namespace {

std::vector<RobotOption> robotsOf(const Options& options, const WorldModel& world) {
  if (!options.robots.empty()) return options.robots;
  std::vector<RobotOption> robots;
  for (const RobotPlace& place : world.robots)
    robots.push_back({place.name, place.model, place.start, place.team});
  const char* one = options.lola.empty() ? "nao_h21_v33" : "nao_h25_v60";
  if (robots.empty()) robots.push_back({"nao", one, {}});
  return robots;
}

// Robots without a place of their own stand side by side.
Pose2 placeOf(const RobotOption& robot, std::size_t i) {
  constexpr double kBeside = 0.8;  // [m] out of arm's reach
  if (robot.start.x != 0 || robot.start.y != 0 || robot.start.theta != 0) return robot.start;
  return {0, -kBeside * static_cast<double>(i), 0};
}

std::shared_ptr<const RobotModel> modelOf(const Options& options, const RobotOption& robot) {
  auto model = loadRobotModel(options.robots_dir, robot.model);
  if (robot.effects.empty() && !options.hung_up) return model;
  auto changed = std::make_shared<RobotModel>(options.hung_up ? suspend(*model) : *model);
  changed->effects.insert(changed->effects.end(), robot.effects.begin(), robot.effects.end());
  return changed;
}

// LoLA has a cycle of its own, whatever the robot's is.
void setLolaCycle(std::vector<sim::RobotSetup>& robots, const std::vector<LolaOption>& lola) {
  std::vector<std::string> names;
  for (const sim::RobotSetup& robot : robots) names.push_back(robot.name);
  const auto paths = lolaPaths(lola, names);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (paths[i].empty() || robots[i].model->cycle == LolaSender::kCycle) continue;
    auto model = std::make_shared<RobotModel>(*robots[i].model);
    model->cycle = LolaSender::kCycle;
    robots[i].model = model;
  }
}

runtime::RunStart startOf(const Options& options) {
  runtime::RunStart start;
  start.world = options.made_world ? options.made_world : loadWorldModel(options.world);
  std::vector<sim::RobotSetup>& setups = start.robots;
  for (const RobotOption& robot : robotsOf(options, *start.world)) {
    for (const sim::RobotSetup& other : setups) {
      if (other.name == robot.name) {
        throw InputError("--robot: the name '" + robot.name +
                         "' is used twice, expected NAME=MODEL with different names");
      }
    }
    setups.push_back(
        {robot.name, modelOf(options, robot), placeOf(robot, setups.size()), robot.team});
  }
  setLolaCycle(setups, options.lola);
  start.step = fromSeconds(options.step);
  start.mode = options.mode;
  start.seed = options.seed;
  return start;
}

}  // namespace

Daemon::Daemon(const Options& options) : Daemon(options, startOf(options)) {}

Daemon::Daemon(const Options& options, const runtime::RunStart& start)
    : options_(options),
      simulation_(start.makeSimulation()),
      loop_(simulation_, options.speed,
            [this] {
              cameras_.wake();
              scheduleDelivery();
            }),
      cameras_([this] {
        loop_.wake();
        scheduleDelivery();
      }) {
  if (options.paused) loop_.beginPaused();
  startClock();
  simulation_.watch(run_hash_);
  if (!options.record.empty()) simulation_.watch(recorder_.emplace(options.record, start));
  makeHosts();
  startLola();
  loop_.holdWhile([this] { return cameras_.pendingJobs() > 0; });
  if (!options.modules.empty()) inviteModules();
}

void Daemon::startClock() {
  clock::ClockPage* page = options_.clock;
  if (!page) return;
  loop_.showTimeOn(*page);
  if (page->mode == clock::Mode::Lockstep) turns_ = std::make_unique<WorldTurns>(*page, io_);
}

void Daemon::makeHosts() {
  std::shared_ptr<rpc::Credentials> credentials;
  std::string script_token;
  if (!options_.auth.empty()) {
    credentials = std::make_shared<rpc::Credentials>(rpc::Credentials::load(options_.auth));
    script_token = makeRandomName();
    if (!options_.scripts.empty()) credentials->add(ScriptProcess::kUser, script_token);
    module_token_ = makeRandomName();
    if (!options_.modules.empty()) credentials->add(LocalModules::kUser, module_token_);
  }
  const auto task_ids = std::make_shared<rpc::TaskIds>();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < simulation_.robotCount(); ++i) names.push_back(robotName(i));
  const auto sockets = lolaPaths(options_.lola, names);
  std::size_t with_lola = 0;
  for (std::size_t i = 0; i < simulation_.robotCount(); ++i) {
    const HostContext context{
        io_,      loop_,        simulation_, options_,  credentials,
        task_ids, script_token, sockets[i],  with_lola, turns_ ? &turns_->gate() : nullptr};
    if (!sockets[i].empty()) ++with_lola;
    hosts_.push_back(std::make_unique<RobotHost>(context, i));
    cameras_.add(hosts_.back()->pictures());
    simulation_.showTo(hosts_.back()->pictures(), i);
  }
}

void Daemon::startLola() {
  std::optional<LolaSender::Seconds> patience;
  if (options_.lola_lockstep) patience = LolaSender::Seconds(*options_.lola_lockstep);
  for (std::size_t i = 0; i < hosts_.size(); ++i) {
    if (!lola(i)) continue;
    lola_.push_back(std::make_unique<LolaSender>(
        wire::LolaSensors(robotModel(i), wire::lolaIdentity(i), options_.lola_battery),
        lola(i)->meeting(), patience));
    simulation_.tellCycles(i, [&sender = *lola_.back()](const auto& frame, const auto& command) {
      sender.send(frame, command);
    });
  }
  if (lola_.empty()) return;
  loop_.keepBeat(LolaSender::kCycle);
  loop_.lockTo([this](SimTime now) { return lolaHolds(now); });
}

// One client that is waited for is enough; those who have gone only if nobody else is there.
bool Daemon::lolaHolds(SimTime now) {
  bool all_rest = true;
  for (const auto& sender : lola_) {
    const LolaSender::Wish wish = sender->wish(now);
    if (wish == LolaSender::Wish::Wait) return true;
    all_rest &= wish == LolaSender::Wish::Rest;
  }
  return all_rest && options_.lola_to_the_end;
}

void Daemon::inviteModules() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < simulation_.robotCount(); ++i) names.push_back(robotName(i));
  const ModuleChoice choice = chooseModules(options_.modules, names);
  modules_robot_ = choice.robot;
  lent_pictures_ =
      std::make_unique<LocalPictures>(io_, [this](const std::string& window, bool raw) {
        return hosts_[modules_robot_]->picture(window, raw);
      });
  modules_ = std::make_unique<LocalModules>(choice.files);
  loop_.invite(
      {[this] { return modules_->beginCycle(); }, [this] { return modules_->holdsTime(); }});
}

// They are clients of one robot.
void Daemon::startModules() {
  const std::string& first = options_.listen.front();
  const bool everywhere = first == "0.0.0.0" || first == "::";
  modules_->start({everywhere ? "127.0.0.1" : first, port(modules_robot_), module_token_,
                   &lent_pictures_->functions()},
                  [this] { loop_.wake(); });
}

std::int64_t Daemon::droppedPictures() const {
  std::int64_t dropped = 0;
  for (const auto& host : hosts_) dropped += host->pictures()->droppedImages();
  return dropped;
}

Daemon::~Daemon() {
  cameras_.stop();
  loop_.stop();
  if (modules_ && !modules_->isOver()) modules_.release();  // NOLINT: a thread of it hangs
}

void Daemon::run(const std::function<void()>& ready) {
  const auto work = boost::asio::make_work_guard(io_);
  cameras_.start();
  if (!turns_) loop_.start();
  if (modules_) startModules();
  if (ready) boost::asio::post(io_, ready);
  if (turns_) {
    loop_.alternateWith(*turns_, [this] { return io_.stopped(); });
  } else {
    io_.run();
  }
  loop_.stop();
  if (recorder_) recorder_->finish(simulation_);
  cameras_.stop();
  for (auto& host : hosts_) host->close();
}

// What LoLA programs have ordered is still done, up to where the world would wait for them.
void Daemon::finishLola() {
  for (const auto& host : hosts_) {
    if (host->lola()) host->lola()->finish();
  }
  loop_.finish([this] { io_.stop(); });
}

// Modules that end still call their robot; one that hangs is left.
void Daemon::stop() {
  if (options_.lola_lockstep && options_.lola_to_the_end)
    return boost::asio::post(io_, [this] { finishLola(); });
  if (!modules_) return io_.stop();
  constexpr std::chrono::seconds kLongest{5};
  modules_->end([this] { io_.stop(); });
  boost::asio::post(io_, [this, kLongest] {
    patience_.expires_after(kLongest);
    patience_.async_wait([this](const auto& error) {
      if (!error) io_.stop();
    });
  });
}

void Daemon::stopOnSignals() {
  signals_.add(SIGINT);
  signals_.add(SIGTERM);
  signals_.async_wait([this](const auto& error, int) {
    if (!error) stop();
  });
}

// Any thread. Ticks come faster than clients are served: one delivery at a time is on its way.
void Daemon::scheduleDelivery() {
  if (delivery_due_.exchange(true)) return;
  boost::asio::post(io_, [this] { deliver(); });
}

void Daemon::deliver() {
  delivery_due_ = false;
  const auto outcomes = loop_.outcomes().drain();
  for (auto& host : hosts_) host->deliver(outcomes);
  if (director_ && director_->look(*loop_.state().get())) loop_.wake();
}

void Daemon::follow(Director& director) {
  director_ = &director;
  loop_.lockTo([&director](SimTime now) { return director.waits(now); });
  loop_.beforeBeat([this, &director] { director.direct(simulation_); });
}

}  // namespace nao::daemon
