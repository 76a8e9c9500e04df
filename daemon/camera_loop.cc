#include "daemon/camera_loop.h"

#include <utility>

namespace nao::daemon {

CameraLoop::CameraLoop(std::function<void()> after_picture)
    : after_picture_(std::move(after_picture)) {}

CameraLoop::~CameraLoop() { stop(); }

void CameraLoop::start() {
  thread_ = std::thread([this] { run(); });
}

void CameraLoop::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = awake_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void CameraLoop::wake() {
  {
    const std::lock_guard lock(mutex_);
    awake_ = true;
  }
  changed_.notify_one();
}

std::size_t CameraLoop::pendingJobs() const {
  std::size_t jobs = 0;
  for (const auto& queue : queues_) jobs += queue->pendingJobs();
  return jobs;
}

void CameraLoop::run() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    awake_ = false;
    lock.unlock();
    while (drawOne()) after_picture_();
    lock.lock();
    changed_.wait(lock, [this] { return awake_; });
  }
}

bool CameraLoop::drawOne() {
  bool drew = false;
  for (const auto& queue : queues_) drew |= queue->renderNext(renderer_);
  return drew;
}

}  // namespace nao::daemon
