#include "naoqi_api/sdk/cpp/src/workers.h"

#include <utility>

namespace nao::client {
namespace {

thread_local Workers* own_workers = nullptr;  // of this thread, if it is one of theirs

}  // namespace

Workers::~Workers() { stop(); }

bool Workers::post(std::function<void()> job) {
  const std::lock_guard lock(mutex_);
  if (stopped_) return false;
  jobs_.push_back(std::move(job));
  startOneIfNeeded();
  return true;
}

void Workers::startOneIfNeeded() {
  if (running_ > 0 || jobs_.empty()) return;
  if (idle_ == 0 && threads_.size() < kMostThreads) {
    threads_.emplace_back([this] { run(); });
  }
  changed_.notify_one();
}

void Workers::run() {
  own_workers = this;
  std::unique_lock lock(mutex_);
  while (!stopped_) {
    ++idle_;
    changed_.wait(lock, [this] { return stopped_ || (!jobs_.empty() && running_ == 0); });
    --idle_;
    if (stopped_) return;
    const std::function<void()> job = std::move(jobs_.front());
    jobs_.pop_front();
    ++running_;
    lock.unlock();
    job();
    lock.lock();
    --running_;
    if (running_ == 0) startOneIfNeeded();
  }
}

void Workers::stop() {
  std::vector<std::thread> threads;
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    jobs_.clear();
    threads.swap(threads_);
  }
  changed_.notify_all();
  for (std::thread& thread : threads) {
    thread.get_id() == std::this_thread::get_id() ? thread.detach() : thread.join();
  }
}

Workers::Waiting::Waiting() : workers_(own_workers) {
  if (!workers_) return;
  const std::lock_guard lock(workers_->mutex_);
  --workers_->running_;
  workers_->startOneIfNeeded();
}

Workers::Waiting::~Waiting() {
  if (!workers_) return;
  const std::lock_guard lock(workers_->mutex_);
  ++workers_->running_;
}

}  // namespace nao::client
