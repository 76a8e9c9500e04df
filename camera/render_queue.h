#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "camera/eye.h"
#include "camera/image_feed.h"
#include "camera/renderer.h"
#include "core/latest.h"
#include "core/mailbox.h"
#include "core/scene_frame.h"

namespace nao::camera {

/// Takes scenes from the simulation thread to the camera thread, for one robot, and the pictures
/// made of them, as that robot's eyes give them, to its ImageFeed. Nothing here waits: who finds
/// the queue full drops the pictures of that instant and counts them. The owner of the threads
/// decides whether to wait until pendingJobs() falls (maximum speed, lockstep) or to go on (1x).
/// Without a camera thread, call renderNext() after offer().
class RenderQueue {
 public:
  /// At most `capacity` instants wait or are being drawn.
  explicit RenderQueue(std::shared_ptr<const ImageFeed> feed, std::size_t capacity = 4);

  // --- Simulation thread ---

  /// Whether a picture is due at `now`: cheap enough for every step. If so, offer() the scene.
  /// Also hands on the pictures whose latency has passed.
  bool anyDue(SimTime now);

  /// Queues the pictures due at the scene's time, as robot `robot` of the scene sees it. False
  /// when they had to be dropped.
  bool offer(std::shared_ptr<const SceneFrame> scene, std::size_t robot);

  /// Instants offered and not yet drawn.
  std::size_t pendingJobs() const;

  /// Those that found the queue full, so far. Any thread.
  std::int64_t droppedImages() const;

  // --- Camera thread ---

  /// Draws the pictures of the next instant; those that differ in colour space only are drawn
  /// once. False if there was nothing to do.
  bool renderNext(Renderer& renderer);

 private:
  struct Job {
    std::shared_ptr<const SceneFrame> scene;
    std::size_t robot = 0;
    std::vector<Subscription> due;
    std::shared_ptr<const std::vector<CameraControl>> controls;
  };

  void findNextDue();
  void hold(SimTime until, Job job);
  bool post(Job job);
  Eye& eyeOf(const Job& job, int camera);

  const std::shared_ptr<const ImageFeed> feed_;
  const std::size_t capacity_;
  Mailbox<Job> jobs_;
  Latest<std::int64_t> finished_;  // jobs, ever
  Latest<std::int64_t> dropped_;   // images, ever

  // Of the simulation thread.
  std::shared_ptr<const std::vector<Subscription>> table_;
  std::map<std::uint64_t, std::int64_t> taken_;  // by subscription: k of the last picture
  SimTime now_ = SimTime::min();
  SimTime next_due_ = SimTime::max();
  std::deque<std::pair<SimTime, Job>> held_;  // until the latency of their camera has passed
  std::int64_t offered_jobs_ = 0;

  // Of the camera thread.
  std::deque<Job> waiting_;
  std::map<int, Eye> eyes_;  // by camera
  std::int64_t finished_jobs_ = 0;
};

/// The number k of the latest picture due at `now`: the largest with k / frame_rate <= now.
std::int64_t pictureNumber(SimTime now, int frame_rate);

/// The first nanosecond at which picture k is due.
SimTime dueTime(std::int64_t k, int frame_rate);

}  // namespace nao::camera
