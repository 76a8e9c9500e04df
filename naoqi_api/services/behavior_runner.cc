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

Playback& BehaviorRunner::load(const std::string& name) {
  const std::string full_name = fullName(name);
  const auto known = playbacks_.find(full_name);
  if (known != playbacks_.end()) return *known->second;
  motion::Timeline timeline;
  try {
    timeline = motion::loadMotion(library_->at(full_name).file, link_.model());
  } catch (const InputError& error) {
    throw rpc::CallError(error.what());
  }
  if (hooks_.warn) {
    for (const std::string& sentence : timeline.broken) hooks_.warn(sentence);
    for (const std::string& sentence : timeline.warnings) hooks_.warn(sentence);
    for (const motion::KeyFault& fault : timeline.key_faults) hooks_.warn(fault.sentence);
  }
  auto playback = std::make_shared<Playback>(link_, std::move(timeline), [this] { tellRunning(); });
  return *playbacks_.emplace(full_name, std::move(playback)).first->second;
}

bool BehaviorRunner::remove(const std::string& name) {
  const std::string full_name = library_->resolve(name);
  if (full_name.empty()) return false;
  const auto playback = playbacks_.find(full_name);
  if (playback != playbacks_.end()) {
    const auto kept = playback->second;  // until it has told that it ended
    playbacks_.erase(playback);
    kept->drop();
  }
  library_->remove(full_name);
  return true;
}

bool BehaviorRunner::isLoaded(const std::string& name) const {
  return playbacks_.count(library_->resolve(name)) > 0;
}

bool BehaviorRunner::isRunning(const std::string& name) const {
  const auto found = playbacks_.find(library_->resolve(name));
  return found != playbacks_.end() && found->second->isRunning();
}

std::vector<std::string> BehaviorRunner::loaded() const {
  std::vector<std::string> names;
  for (const auto& [name, playback] : playbacks_) names.push_back(name);
  return names;
}

std::vector<std::string> BehaviorRunner::running() const {
  std::vector<std::string> names;
  for (const auto& [name, playback] : playbacks_) {
    if (playback->isRunning()) names.push_back(name);
  }
  return names;
}

void BehaviorRunner::tellRunning() const {
  if (hooks_.running_changed) hooks_.running_changed(running());
}

}  // namespace nao::services
