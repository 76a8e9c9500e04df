#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "motion/timeline/timeline.h"
#include "naoqi_api/pending.h"
#include "naoqi_api/robot_link.h"

namespace nao::services {

/// A recorded motion that clients can start, watch, wait for and end. Lives in a shared_ptr; when
/// it goes its motion goes on, but nobody hears of it. I/O thread.
class Playback : public std::enable_shared_from_this<Playback> {
 public:
  /// `changed`, if any, is called whenever it has started or ended. `link` must outlive it.
  Playback(RobotLink& link, motion::Timeline timeline, std::function<void()> changed = {});

  const motion::Timeline& timeline() const { return timeline_; }
  bool isRunning() const { return request_ != 0; }
  bool wasStarted() const { return started_; }

  /// Plays it, from where the joints are; nothing if it plays already. It waits for joints that
  /// others have booked. @throws CallError when the robot has too many requests.
  void start();

  /// Ends with the motion, at once if it does not run; a failure becomes an error. Canceling it
  /// ends the motion.
  rpc::Pending<void> untilEnd();

  /// Asks the robot to end it; it counts as running until the robot has.
  void stop();

  /// Ends it for those who wait, whatever the robot does about it.
  void drop();

 private:
  void ended(motion::RequestId request, const std::string& failure);

  RobotLink& link_;
  motion::Timeline timeline_;
  std::function<void()> changed_;
  motion::RequestId request_ = 0;  // while it runs
  bool started_ = false;
  std::vector<rpc::Pending<void>> waiting_;  // for its end
};

}  // namespace nao::services
