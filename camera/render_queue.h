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
  std::size_t pendingJobs();

  /// The pictures of a moment of simulated time: what the cameras have adapted to, what was shown
  /// last, what is due next and what is still being drawn.
  class Moment;
  std::shared_ptr<const Moment> moment() const;

  /// Goes on from a moment of this queue, or of one for a robot and cameras made alike, with the
  /// pictures that followed it. Who subscribed since, or to the other queue, gets a first picture
  /// at once. Null: from the start.
  void restore(const std::shared_ptr<const Moment>& moment);

  /// Those that found the queue full, so far. Any thread.
  std::int64_t droppedImages() const;

  // --- Camera thread ---

  /// Draws the pictures of the next instant; those that differ in colour space only are drawn
  /// once. False if there was nothing to do.
  bool renderNext(Renderer& renderer);

 private:
  /// What the camera thread has come to.
  struct Drawn {
    std::int64_t jobs = 0;                                       // finished, ever
    std::map<int, Adaptation> eyes;                              // by camera
    std::map<std::uint64_t, std::shared_ptr<const Image>> last;  // by subscription
  };
  struct Job {
    std::shared_ptr<const SceneFrame> scene;  // null: nothing to draw, go back to `start`
    std::size_t robot = 0;
    std::vector<Subscription> due;
    std::shared_ptr<const std::vector<CameraControl>> controls;
    std::shared_ptr<const Drawn> start;
  };
  using JobPointer = std::shared_ptr<const Job>;
  using Held = std::deque<std::pair<SimTime, JobPointer>>;

  void findNextDue();
  void hold(SimTime until, JobPointer job);
  bool post(JobPointer job);
  void handOver();
  JobPointer startOf(const Moment& moment) const;
  JobPointer mine(const JobPointer& job, const Moment& moment) const;
  void draw(const Job& job, Renderer& renderer);
  void publish(const Raster& raster, const Job& job, const ImageRequest& view);
  void goBackTo(const Drawn& start);
  void showAgain(const Drawn& start) const;
  void tellDrawn();
  Eye& eyeOf(const Job& job, int camera);

  const std::shared_ptr<const ImageFeed> feed_;
  const std::size_t capacity_;
  Mailbox<JobPointer> jobs_;
  Latest<Drawn> drawn_;
  Latest<std::int64_t> dropped_;  // images, ever

  // Of the simulation thread.
  std::shared_ptr<const std::vector<Subscription>> table_;
  std::map<std::uint64_t, std::int64_t> taken_;  // by subscription: k of the last picture
  SimTime now_ = SimTime::min();
  SimTime next_due_ = SimTime::max();
  Held held_;                         // until the latency of their camera has passed
  std::deque<JobPointer> under_way_;  // the newest offered, among them all that are not finished
  std::size_t to_hand_over_ = 0;      // the last ones of these: not yet in the mailbox
  std::int64_t offered_jobs_ = 0;

  // Of the camera thread.
  std::deque<JobPointer> waiting_;
  std::map<int, Eye> eyes_;  // by camera
  Drawn so_far_;
};

class RenderQueue::Moment {
  friend class RenderQueue;
  std::shared_ptr<const ImageFeed> feed;  // whose subscriptions are meant
  std::shared_ptr<const Drawn> drawn;     // null: nothing yet
  std::vector<JobPointer> under_way;
  std::map<std::uint64_t, std::int64_t> taken;
  Held held;
};

/// The number k of the latest picture due at `now`: the largest with k / frame_rate <= now.
std::int64_t pictureNumber(SimTime now, int frame_rate);

/// The first nanosecond at which picture k is due.
SimTime dueTime(std::int64_t k, int frame_rate);

}  // namespace nao::camera
