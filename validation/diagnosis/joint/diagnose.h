#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "validation/diagnosis/jobs/kept_work.h"
#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/joint/joint_search.h"

namespace nao::validation {

/// A joint to be diagnosed: what predicts it, and its noise.
struct JointTask {
  const JointSimulator* joint = nullptr;
  JointNoise noise;
  JointNoise nominal{};  // of the robot's file, to report; may be left out
};

struct DiagnosisOptions {
  Effort effort;
  int jobs = 1;                      // threads; the result is the same for any number
  long runs_per_joint = 1000000000;  // granted
  /// Called often and by any thread: what is being done, and which part of all is done, 0 to 1.
  std::function<void(const std::string&, double)> progress;
  /// The other processes that work on it; all are given the same tasks.
  std::shared_ptr<const Team> team = std::make_shared<Team>();
  /// What was finished before and is finished now; names of units begin with a joint's.
  KeptWork kept;
};

/// One number that several joints share.
struct SharedFinding {
  Finding finding;         // its joint is "all joints"
  int joints = 0;          // that it helps by more than the threshold
  std::string robot_id{};  // of several robots of a set; empty: it has one
};

/// What a set of joints shows.
struct SetDiagnosis {
  Verdict verdict = Verdict::NoDiscrepancy;
  std::vector<SharedFinding> shared;
  std::vector<JointVerdict> joints;
  double critical_gain = 0;  // [nats] 99 % quantile over null sets, all joints and causes
  int null_sets = 0;
  long runs = 0;
};

/// What a set comes to: the gravest of its joints, or what all of them share.
Verdict overall(const SetDiagnosis& diagnosis);

/// Diagnoses all joints of a set: causes of Scope::Robot are first tried as one number for all of
/// them, then each joint is searched on its own. Thresholds are those of the whole set.
SetDiagnosis diagnoseJoints(const std::vector<JointTask>& tasks, const std::vector<Cause>& causes,
                            const DiagnosisOptions& options);

}  // namespace nao::validation
