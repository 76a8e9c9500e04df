#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "core/sim_time.h"
#include "motion/robot_ports.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/pending.h"

namespace nao::services {

/// The services' end of one robot: numbers and posts their requests, tells them how these ended,
/// and reads what the robot last published. Owned by the I/O thread; nothing here waits. Before
/// the robot's first cycle the readers throw.
class RobotLink {
 public:
  RobotLink(std::shared_ptr<const RobotModel> model, std::shared_ptr<motion::RobotPorts> ports);

  const RobotModel& model() const { return *model_; }
  const std::shared_ptr<const RobotModel>& sharedModel() const { return model_; }

  /// @throws CallError when the robot has too many requests to take another.
  motion::RequestId post(motion::MotionAction action);

  /// Ends a motion if it still goes on, and if the robot takes another request now.
  void kill(motion::RequestId id);

  /// Asks for a light; false if the robot has too many such orders to take another.
  bool light(LedOrder order) { return ports_->leds.post(std::move(order)); }

  /// How the request just posted ends. Canceling it kills the motion. Once per request.
  rpc::Pending<motion::MotionOutcome> outcomeOf(motion::RequestId id);

  /// Posts, and ends when the motion has ended, be it killed; a failure becomes an error.
  rpc::Pending<void> postAndWait(motion::MotionAction action);

  /// Ends when `condition` holds for the robot's state and every request posted before this call
  /// has been taken over: at once if so already. Can be canceled. Fails when the robot is set back
  /// to a snapshot.
  rpc::Pending<void> until(std::function<bool(const motion::MotionState&)> condition);

  /// What `read` returns once everything posted so far has been taken over, so that a client
  /// reads its own writes. A CallError of `read` becomes the error of the result.
  template <class F>
  auto whenSettled(F read) {
    using Result = std::invoke_result_t<F>;
    rpc::Pending<Result> result;
    const auto readNow = [result, read](const auto& /*settled*/) {
      try {
        result.resolve(read());
      } catch (const rpc::CallError& error) {
        result.fail(error.what());
      }
    };
    if (isSettled()) {
      readNow(0);
    } else {
      until({}).whenDone(readNow);
    }
    return result;
  }

  /// The newest sensors and state. @throws CallError before the robot's first cycle.
  std::shared_ptr<const SensorFrame> sensors() const;
  std::shared_ptr<const motion::MotionState> state() const;

  /// Simulated time of the robot's last cycle; 0 before the first.
  SimTime now() const;

  /// Calls `callback` when this much simulated time has passed, in order of time and then of
  /// asking. Returns the number to cancel it with. When time is set back, the rest of the delay
  /// stays.
  std::uint64_t after(Duration delay, std::function<void()> callback);
  void cancelTimer(std::uint64_t timer);

  /// `told` is called with every frame that feels another touch than the one told before, in order,
  /// as often as the link lives; the newest was told last.
  using Touched = std::function<void(const std::shared_ptr<const SensorFrame>&)>;
  void onTouch(Touched told) { on_touch_.push_back(std::move(told)); }

  /// Hands on what the robot has published since: touches, outcomes, fulfilled conditions, due
  /// timers. The daemon calls it on the I/O thread after the robot's cycles.
  void deliver();

 private:
  struct Waiting {
    motion::RequestId posted = 0;
    std::uint64_t set_back = 0;  // as the robot's state says
    std::function<bool(const motion::MotionState&)> condition;
    rpc::Pending<void> pending;
  };
  struct Timer {
    std::uint64_t id = 0;
    std::function<void()> callback;
  };
  static constexpr std::size_t kForgetAt = 64;

  bool isSettled() const;
  void forgetCanceled();
  static bool holds(const Waiting& waiting, const motion::MotionState* state);
  void deliverTouches();
  void tellTouch(const std::shared_ptr<const SensorFrame>& frame);
  void deliverOutcomes();
  void deliverConditions();
  void deliverTimers();
  void keepDelays();

  std::shared_ptr<const RobotModel> model_;
  std::shared_ptr<motion::RobotPorts> ports_;
  motion::RequestId last_posted_ = 0;
  std::map<motion::RequestId, rpc::Pending<motion::MotionOutcome>> awaited_;
  std::vector<Waiting> waiting_;
  std::size_t forget_at_ = kForgetAt;  // so many waiting, some of them canceled perhaps
  std::vector<Touched> on_touch_;
  std::shared_ptr<const SensorFrame> touch_told_;  // the last frame that was, or null
  std::multimap<SimTime, Timer> timers_;
  std::uint64_t last_timer_ = 0;
  std::uint64_t set_back_ = 0;  // seen last, with
  SimTime last_now_{};          // the time it then was
};

}  // namespace nao::services
