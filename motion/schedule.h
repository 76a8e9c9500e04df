#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/value_ptr.h"
#include "motion/motion_request.h"
#include "motion/motion_state.h"
#include "motion/phase.h"

namespace nao::motion {

/// A motion that books joints from its start to its end.
struct Job {
  RequestId id = 0;  // 0: nobody's any more
  std::string name;  // as getTaskList shows it
  JointSet joints;
  ValuePtr<Phase> phase;
  bool has_outcome = true;  // false: whoever added it reports how it ends
};

/// The motions under way and those that wait for their joints. A job starts when no running job
/// and no job that waits longer books a joint of its own, so nobody is overtaken for ever.
class Schedule {
 public:
  /// One job more, to wait for its joints. When a thousand wait already it fails at once: false.
  bool add(Job job);

  /// One cycle of `dt` [s]: starts what may start and moves what runs.
  void advance(double dt, Body& body);

  /// A joint that a setpoint takes away from the running jobs; they go on with the others.
  void release(Joint joint);

  /// Removes a job, running or waiting; false if there is none of this number.
  bool kill(RequestId id);
  void killAll();

  JointSet booked() const;          // by running jobs
  std::vector<Task> tasks() const;  // running jobs

  /// How jobs ended since the last call, in order.
  std::vector<MotionOutcome> takeOutcomes();

  /// From now on nobody hears how the jobs end that are there now.
  void forgetCallers();

  /// Lists the jobs for hashing, not who waits for them.
  void archive(Archive& archive);

 private:
  void startWaiting(Body& body);
  void end(const Job& job, MotionOutcome::Kind kind, std::string reason = {});

  std::vector<Job> running_;
  std::vector<Job> waiting_;
  std::vector<MotionOutcome> outcomes_;
};

}  // namespace nao::motion
