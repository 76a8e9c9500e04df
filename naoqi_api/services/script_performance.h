#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "naoqi_api/services/playback.h"

namespace nao::services {

/// Runs the code in a behavior's boxes elsewhere. `ended` is told once, with its failure or
/// nothing, never before the launcher has returned. @returns how to ask it to end.
/// @throws CallError if it can not begin.
using ScriptLauncher = std::function<std::function<void()>(
    const std::filesystem::path& file, std::function<void(const std::string& failure)> ended)>;

/// A behavior with code in its boxes. Lives in a shared_ptr. I/O thread.
class ScriptPerformance final : public Performance,
                                public std::enable_shared_from_this<ScriptPerformance> {
 public:
  /// `changed`, if any, is called whenever it has started or ended.
  ScriptPerformance(std::filesystem::path file, ScriptLauncher launch,
                    std::function<void()> changed = {});

  bool isRunning() const override { return end_ != nullptr; }
  void start() override;
  rpc::Pending<void> untilEnd() override;
  rpc::Pending<void> stop() override;
  void drop() override;

 private:
  void ended(int run, const std::string& failure);

  std::filesystem::path file_;
  ScriptLauncher launch_;
  std::function<void()> changed_;
  std::function<void()> end_;  // while it runs
  int run_ = 0;                // how often it was started
  std::vector<rpc::Pending<void>> waiting_;
};

}  // namespace nao::services
