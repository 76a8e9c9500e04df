#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "motion/motion_engine.h"
#include "motion/robot_ports.h"
#include "runtime/body_drive.h"
#include "runtime/input.h"

namespace nao::runtime {

/// One robot without its body: requests in, a joint command per cycle out. Lives on the
/// simulation thread; other threads hold its ports.
///
/// Who drives: a program that commands the body itself (RobotPorts::body), as long as it does so
/// (BodyDrive). Its first command ends every motion and starts the motion side anew, as after a
/// power cycle; while it drives, requests of motions fail.
class Robot {
 public:
  explicit Robot(std::shared_ptr<const RobotModel> model);

  const RobotModel& model() const { return *model_; }
  const std::shared_ptr<const RobotModel>& sharedModel() const { return model_; }
  const std::shared_ptr<motion::RobotPorts>& ports() const { return ports_; }

  /// Told of all that is taken over through the ports.
  void tellInputs(std::function<void(Input::Place, const Input::Content&)> told) {
    told_ = std::move(told);
  }

  /// Takes over what clients asked for. Called by tick(), and alone while the world is paused, so
  /// that nobody waits for an answer that only needs accepting.
  void acceptRequests();

  /// One control cycle. All of the robot happens here, in this order.
  JointCommand tick(const SensorFrame& frame);

  /// Forgets every motion, as after a power cycle; requests under way end as killed.
  void restart();

  /// All of the robot that goes on in time, as a value.
  struct Snapshot {
    motion::MotionEngine motion;
    BodyDrive drive;
    std::shared_ptr<const SensorFrame> sensors;  // published last, or null
  };
  Snapshot snapshot() const;

  /// Sets the robot, or one of the same model, back. Requests that have not ended fail with one
  /// text, those posted before and after the snapshot alike: nobody waits for what goes on.
  void restore(const Snapshot& snapshot);

  /// Adds what decides how the robot goes on.
  void addTo(Archive& hash) const {
    motion_.addTo(hash);
    drive_.addTo(hash);
  }

 private:
  void accept(const motion::MotionRequest& request, Input::Place place);
  void publish();
  void powerCycle(motion::MotionOutcome::Kind kind, const char* reason);
  void endOpen(motion::MotionOutcome::Kind kind, const char* reason);

  std::shared_ptr<const RobotModel> model_;
  std::shared_ptr<motion::RobotPorts> ports_;
  std::function<void(Input::Place, const Input::Content&)> told_;  // empty: nobody asked
  const motion::MotionEngine at_start_;
  motion::MotionEngine motion_;
  BodyDrive drive_;
  std::set<motion::RequestId> open_;           // accepted and not yet ended
  motion::RequestId last_accepted_ = 0;        // outlives restarts, as clients' counts do
  std::uint64_t set_back_ = 0;                 // how often
  std::vector<motion::MotionOutcome> unsent_;  // while the mailbox is full
};

}  // namespace nao::runtime
