#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "camera/render_queue.h"

namespace nao::daemon {

/// The camera thread: draws what the simulation offered, for all robots in turn. After every
/// picture it calls `after_picture`, on its own thread.
class CameraLoop {
 public:
  explicit CameraLoop(std::function<void()> after_picture);
  ~CameraLoop();

  /// Before start().
  void add(std::shared_ptr<camera::RenderQueue> queue) { queues_.push_back(std::move(queue)); }

  void start();
  void stop();  // waits for the thread

  /// From any thread: something may have been offered.
  void wake();

  /// Instants offered and not yet drawn. Simulation thread.
  std::size_t pendingJobs() const;

 private:
  void run();
  bool drawOne();

  std::function<void()> after_picture_;
  std::vector<std::shared_ptr<camera::RenderQueue>> queues_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool awake_ = false;
  bool stopping_ = false;
  camera::Renderer renderer_;
  std::thread thread_;
};

}  // namespace nao::daemon
