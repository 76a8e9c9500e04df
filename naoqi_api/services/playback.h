#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "motion/timeline/timeline.h"
#include "naoqi_api/pending.h"
#include "naoqi_api/robot_link.h"

namespace nao::services {

/// Something that clients can start, watch, wait for and end. I/O thread.
class Performance {
 public:
  virtual ~Performance() = default;
  virtual bool isRunning() const = 0;

  /// Begins; nothing if it runs already. @throws CallError if it can not begin.
  virtual void start() = 0;

  /// Ends with it, at once if it does not run; a failure becomes an error. Canceling it ends it.
  virtual rpc::Pending<void> untilEnd() = 0;

  /// Asks it to end; it counts as running until it has. Ends when a motion has ended, however; of
  /// code, which may take its time, at once.
  virtual rpc::Pending<void> stop() = 0;

  /// Ends it for those who wait, at once.
  virtual void drop() = 0;
};

/// A recorded motion as a performance. Lives in a shared_ptr; when it goes its motion goes on, but
/// nobody hears of it. I/O thread.
class Playback final : public Performance, public std::enable_shared_from_this<Playback> {
 public:
  /// `changed`, if any, is called whenever it has started or ended. `link` must outlive it.
  Playback(RobotLink& link, motion::Timeline timeline, std::function<void()> changed = {});

  const motion::Timeline& timeline() const { return timeline_; }
  bool isRunning() const override { return request_ != 0; }
  bool wasStarted() const { return started_; }

  /// Plays it, from where the joints are. It waits for joints that others have booked.
  /// @throws CallError when the robot has too many requests.
  void start() override;
  rpc::Pending<void> untilEnd() override;
  rpc::Pending<void> stop() override;
  void drop() override;

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
