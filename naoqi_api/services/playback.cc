#include "naoqi_api/services/playback.h"

#include <utility>

namespace nao::services {

Playback::Playback(RobotLink& link, motion::Timeline timeline, std::function<void()> changed)
    : link_(link), timeline_(std::move(timeline)), changed_(std::move(changed)) {}

void Playback::start() {
  if (isRunning()) return;
  motion::Interpolate request;
  request.curves = timeline_.curves;
  request.smooth = false;
  const motion::RequestId posted = link_.post(std::move(request));
  request_ = posted;
  started_ = true;
  link_.outcomeOf(posted).whenDone([weak = weak_from_this(), posted](const auto& outcome) {
    const auto self = weak.lock();
    if (!self) return;
    // Killed is an end like any other; only what failed has a reason for those who wait.
    const bool failed = outcome.value && outcome.value->kind == motion::MotionOutcome::Kind::Failed;
    self->ended(posted, failed ? outcome.value->reason : std::string());
  });
  if (changed_) changed_();
}

void Playback::ended(motion::RequestId request, const std::string& failure) {
  if (request_ != request) return;
  request_ = 0;
  if (changed_) changed_();
  for (const auto& call : std::exchange(waiting_, {})) {
    failure.empty() ? call.resolve() : call.fail(failure);
  }
}

rpc::Pending<void> Playback::untilEnd() {
  rpc::Pending<void> done;
  if (!isRunning()) {
    done.resolve();
    return done;
  }
  done.onCancel([weak = weak_from_this(), request = request_] {
    if (const auto self = weak.lock()) self->link_.kill(request);
  });
  waiting_.push_back(done);
  return done;
}

rpc::Pending<void> Playback::stop() {
  rpc::Pending<void> stopped;
  untilEnd().whenDone([stopped](const auto& /*outcome*/) { stopped.resolve(); });
  if (isRunning()) link_.post(motion::Kill{request_});
  return stopped;
}

void Playback::drop() {
  if (!isRunning()) return;
  link_.kill(request_);
  ended(request_, {});
}

}  // namespace nao::services
