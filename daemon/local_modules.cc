#include "daemon/local_modules.h"

#include <dlfcn.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/check.h"
#include "naoqi_api/sdk/cpp/include/usarnaoqi_sdk/local_host.h"

namespace nao::daemon {
namespace {

void tell(const char* text) { spdlog::error("module: {}", text); }

template <class F>
F find(void* handle, const char* name) {
  return reinterpret_cast<F>(dlsym(handle, name));
}

}  // namespace

ModuleChoice chooseModules(const std::vector<std::string>& options,
                           const std::vector<std::string>& robots) {
  ModuleChoice choice;
  for (const std::string& option : options) {
    const std::size_t equals = option.find('=');
    const bool is_named = equals != std::string::npos && option.find('/') > equals;
    const std::string name = is_named ? option.substr(0, equals) : robots.front();
    const auto robot = std::find(robots.begin(), robots.end(), name);
    if (robot == robots.end()) throw InputError("--module: there is no robot '" + name + "'");
    const auto index = static_cast<std::size_t>(robot - robots.begin());
    if (!choice.files.empty() && index != choice.robot) {
      throw InputError("--module: expected modules of one robot, found '" + name + "' beside '" +
                       robots[choice.robot] + "'");
    }
    choice.robot = index;
    choice.files.push_back(is_named ? option.substr(equals + 1) : option);
  }
  return choice;
}

LocalModules::LocalModules(const std::vector<std::string>& files) {
  for (const std::string& file : files) libraries_.push_back(load(file));
}

LocalModules::~LocalModules() {
  end({});
  if (thread_.joinable()) thread_.join();
}

bool LocalModules::isOver() {
  const std::lock_guard lock(mutex_);
  return state_ == State::Over;
}

LocalModules::Library LocalModules::load(const std::string& file) {
  const std::string path = std::filesystem::absolute(file).string();
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle)
    throw InputError("--module: expected a library of modules: " + std::string(dlerror()));
  void* create = dlsym(handle, "_createModule");
  if (!create) {
    throw InputError("--module: expected " + file + " to have a function _createModule");
  }
  if (!dlsym(handle, "usarnaoqi_sdk_start")) {
    throw InputError("--module: expected " + file + " to be linked with usarnaoqi_sdk");
  }
  return {std::filesystem::path(file).stem().string(), handle, create};
}

void LocalModules::start(const Robot& robot, std::function<void()> done) {
  done_ = std::move(done);
  thread_ = std::thread([this, robot] { run(robot); });
}

void LocalModules::create(const Robot& robot) const {
  const UsarnaoqiRobot own{robot.host.c_str(), robot.port, robot.token.empty() ? "" : kUser,
                           robot.token.c_str(), robot.pictures};
  for (const Library& library : libraries_) {
    const auto start = find<UsarnaoqiStart>(library.handle, "usarnaoqi_sdk_start");
    const bool made = start(&own, library.name.c_str(), library.create, tell);
    made ? spdlog::info("module {} is there", library.name)
         : spdlog::error("module {} could not be made", library.name);
  }
}

// The library is one for all modules: the first knows its functions.
void LocalModules::run(const Robot& robot) {
  bool over_already = false;
  {
    std::unique_lock lock(mutex_);  // before the first cycle a robot senses nothing
    changed_.wait(lock, [this] { return cycle_seen_ || end_asked_; });
    over_already = end_asked_;
  }
  if (!over_already) create(robot);
  void* handle = libraries_.front().handle;
  const auto cycle = find<UsarnaoqiCycle>(handle, "usarnaoqi_sdk_cycle");
  std::unique_lock lock(mutex_);
  state_ = State::Idle;
  for (;;) {
    changed_.wait(lock, [this] { return end_asked_ || state_ == State::InCycle; });
    if (end_asked_) break;
    lock.unlock();
    cycle();
    lock.lock();
    state_ = State::Idle;
    lock.unlock();
    done_();
    lock.lock();
  }
  state_ = State::Ending;
  lock.unlock();
  done_();
  find<UsarnaoqiStop>(handle, "usarnaoqi_sdk_stop")();
  lock.lock();
  state_ = State::Over;
  const auto ended = std::move(ended_);
  lock.unlock();
  if (ended) ended();
}

bool LocalModules::beginCycle() {
  const std::lock_guard lock(mutex_);
  if (!cycle_seen_) changed_.notify_all();
  cycle_seen_ = true;
  if (state_ != State::Idle || end_asked_) return false;
  state_ = State::InCycle;
  given_up_ = false;
  begun_ = std::chrono::steady_clock::now();
  changed_.notify_all();
  return true;
}

bool LocalModules::holdsTime() {
  const std::lock_guard lock(mutex_);
  if (state_ != State::InCycle || given_up_) return false;
  if (std::chrono::steady_clock::now() - begun_ < kPatience) return true;
  given_up_ = true;
  spdlog::warn("a module has not come back from its cycle for {} s: time goes on without it",
               kPatience.count());
  return false;
}

void LocalModules::end(std::function<void()> ended) {
  const std::lock_guard lock(mutex_);
  if (end_asked_) return;
  ended_ = std::move(ended);
  end_asked_ = true;
  changed_.notify_all();
}

}  // namespace nao::daemon
