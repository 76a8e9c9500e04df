#include "naoqi_api/services/script_performance.h"

#include <utility>

namespace nao::services {

ScriptPerformance::ScriptPerformance(std::filesystem::path file, ScriptLauncher launch,
                                     std::function<void()> changed)
    : file_(std::move(file)), launch_(std::move(launch)), changed_(std::move(changed)) {}

void ScriptPerformance::start() {
  if (isRunning()) return;
  const int run = ++run_;
  end_ = launch_(file_, [weak = weak_from_this(), run](const std::string& failure) {
    if (const auto self = weak.lock()) self->ended(run, failure);
  });
  if (changed_) changed_();
}

void ScriptPerformance::ended(int run, const std::string& failure) {
  if (run != run_ || !isRunning()) return;
  end_ = nullptr;
  if (changed_) changed_();
  for (const auto& call : std::exchange(waiting_, {})) {
    failure.empty() ? call.resolve() : call.fail(failure);
  }
}

rpc::Pending<void> ScriptPerformance::untilEnd() {
  rpc::Pending<void> done;
  if (!isRunning()) {
    done.resolve();
    return done;
  }
  done.onCancel([weak = weak_from_this()] {
    if (const auto self = weak.lock()) self->stop();
  });
  waiting_.push_back(done);
  return done;
}

rpc::Pending<void> ScriptPerformance::stop() {
  if (isRunning()) end_();
  return rpc::Pending<void>::done();
}

void ScriptPerformance::drop() {
  stop();
  ended(run_, {});
}

}  // namespace nao::services
