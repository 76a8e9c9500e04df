#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "naoqi_api/services/behavior_library.h"
#include "naoqi_api/services/playback.h"
#include "naoqi_api/services/script_performance.h"

namespace nao::services {

/// What installed behaviors of one robot are loaded and run, for the services that offer them. I/O
/// thread.
class BehaviorRunner {
 public:
  struct Hooks {
    std::function<void(const std::string&)> warn;  // what of a behavior is left out, a sentence
    std::function<void(const std::vector<std::string>&)> running_changed;
    ScriptLauncher run_code;  // none: code in boxes is told, not run
  };

  /// `link` must outlive it.
  BehaviorRunner(RobotLink& link, std::shared_ptr<BehaviorLibrary> library, Hooks hooks = {});

  const BehaviorLibrary& library() const { return *library_; }

  /// The full name of a behavior. @throws CallError if there is none of that name.
  std::string fullName(const std::string& name) const;

  /// Reads its file, unless it is loaded already. @throws CallError if it can not be played: the
  /// sentence names file and line.
  Performance& load(const std::string& name);

  /// Ends a behavior and forgets it; false if there is none of that name.
  bool remove(const std::string& name);

  bool isLoaded(const std::string& name) const;
  bool isRunning(const std::string& name) const;
  std::vector<std::string> loaded() const;
  std::vector<std::string> running() const;

 private:
  std::shared_ptr<Performance> open(const std::filesystem::path& file);
  void tellRunning() const;

  RobotLink& link_;
  std::shared_ptr<BehaviorLibrary> library_;
  Hooks hooks_;
  std::map<std::string, std::shared_ptr<Performance>> performances_;  // by full name
};

}  // namespace nao::services
