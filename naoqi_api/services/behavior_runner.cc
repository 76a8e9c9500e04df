#include "naoqi_api/services/behavior_runner.h"

#include <utility>

#include "core/check.h"
#include "motion/timeline/motion_file.h"

namespace nao::services {

BehaviorRunner::BehaviorRunner(RobotLink& link, std::shared_ptr<BehaviorLibrary> library,
                               Hooks hooks)
    : link_(link), library_(std::move(library)), hooks_(std::move(hooks)) {}

std::string BehaviorRunner::fullName(const std::string& name) const {
  std::string full_name = library_->resolve(name);
  if (!full_name.empty()) return full_name;
  throw rpc::CallError("no behavior \"" + name.substr(0, 200) +
                       "\" is installed; getInstalledBehaviors lists those there are");
}

Performance& BehaviorRunner::load(const std::string& name) {
  const std::string full_name = fullName(name);
  const auto known = performances_.find(full_name);
  if (known != performances_.end()) return *known->second;
  try {
    return *performances_.emplace(full_name, open(library_->at(full_name).file)).first->second;
  } catch (const InputError& error) {
    throw rpc::CallError(error.what());
  }
}

std::shared_ptr<Performance> BehaviorRunner::open(const std::filesystem::path& file) {
  const auto changed = [this] { tellRunning(); };
  if (hooks_.run_code) {
    if (const auto code = motion::findCode(file)) {
      return std::make_shared<ScriptPerformance>(*code, hooks_.run_code, changed);
    }
  }
  motion::Timeline timeline = motion::loadMotion(file, link_.model());
  if (hooks_.warn) {
    for (const std::string& sentence : timeline.broken) hooks_.warn(sentence);
    for (const std::string& sentence : timeline.warnings) hooks_.warn(sentence);
    for (const motion::KeyFault& fault : timeline.key_faults) hooks_.warn(fault.sentence);
  }
  return std::make_shared<Playback>(link_, std::move(timeline), changed);
}

bool BehaviorRunner::remove(const std::string& name) {
  const std::string full_name = library_->resolve(name);
  if (full_name.empty()) return false;
  const auto playback = performances_.find(full_name);
  if (playback != performances_.end()) {
    const auto kept = playback->second;  // until it has told that it ended
    performances_.erase(playback);
    kept->drop();
  }
  library_->remove(full_name);
  return true;
}

bool BehaviorRunner::isLoaded(const std::string& name) const {
  return performances_.count(library_->resolve(name)) > 0;
}

bool BehaviorRunner::isRunning(const std::string& name) const {
  const auto found = performances_.find(library_->resolve(name));
  return found != performances_.end() && found->second->isRunning();
}

std::vector<std::string> BehaviorRunner::loaded() const {
  std::vector<std::string> names;
  for (const auto& [name, playback] : performances_) names.push_back(name);
  return names;
}

std::vector<std::string> BehaviorRunner::running() const {
  std::vector<std::string> names;
  for (const auto& [name, playback] : performances_) {
    if (playback->isRunning()) names.push_back(name);
  }
  return names;
}

void BehaviorRunner::tellRunning() const {
  if (hooks_.running_changed) hooks_.running_changed(running());
}

}  // namespace nao::services
