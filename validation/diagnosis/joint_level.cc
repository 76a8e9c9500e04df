#include "validation/diagnosis/joint_level.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/check.h"
#include "validation/diagnosis/folds/diagnose_folds.h"
#include "validation/diagnosis/jobs/packed.h"
#include "validation/diagnosis/joint/prepared_set.h"
#include "validation/log/log_robots.h"

namespace nao::validation {
namespace {

// How many runs each joint may take, from what one costs here and now. Which runs are made depends
// on this number alone.
long runsWithin(double seconds, const PreparedSet& set, int jobs) {
  const auto begin = std::chrono::steady_clock::now();
  constexpr int kRuns = 20;
  const PreparedJoint& joint = set.joints.front();
  for (int i = 0; i < kRuns; ++i) joint.simulator->coarse().run({}, 0, 1u + i, joint.noise);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  const double threads = std::min(jobs, static_cast<int>(set.joints.size()));
  return std::lround(seconds * threads / static_cast<double>(set.joints.size()) /
                     (taken.count() / kRuns));
}

// The same in every process, and in one that goes on.
long grantedRuns(const PreparedSet& set, const JointLevelOptions& options) {
  if (options.seconds <= 0) return options.runs_per_joint;
  const int jobs = options.jobs * static_cast<int>(options.team->size());
  return unpack<long>(askFirst(*options.team, "budget", [&] {
    return options.kept.remember("budget",
                                 [&] { return pack(runsWithin(options.seconds, set, jobs)); });
  }));
}

std::vector<JointTask> tasksOf(const PreparedSet& set, const std::string& only) {
  std::vector<JointTask> tasks;
  for (const PreparedJoint& joint : set.joints) {
    if (!only.empty() && joint.simulator->joint() != only) continue;
    tasks.push_back({joint.simulator.get(), joint.noise, joint.nominal});
  }
  if (tasks.empty()) throw InputError("--joint " + only + ": it was not measured in all runs");
  return tasks;
}

// Without repeats nothing tells the noise: what is held out must decide.
FoldedSet diagnoseTasks(const std::vector<JointTask>& tasks, const PreparedSet& set,
                        const DiagnosisOptions& options) {
  if (!isWithoutRepeats(*tasks.front().joint)) {
    return {diagnoseJoints(tasks, jointCauses(), options), ""};
  }
  FoldSearchOptions by_folds;
  by_folds.jobs = options.jobs;
  by_folds.granted = options.runs_per_joint;
  for (const GriddedMotion& motion : set.set->motions()) {
    by_folds.gains.push_back(motion.kp_scale);
  }
  if (options.progress && options.team->rank() == 0) {
    by_folds.progress = [&](const std::string& what) { options.progress(what, 0); };
  }
  return diagnoseByFolds(tasks, benchCauses(), by_folds, *options.team, options.kept);
}

JointLevelDiagnosis diagnoseRobot(const LogSet& set, const std::shared_ptr<const RobotModel>& model,
                                  const VerdictRecords& records, JointLevelOptions options) {
  const PreparedSet prepared = prepareSet(set, model, options);
  if (prepared.joints.empty()) throw InputError(set.name + ": no joint was measured in all runs");
  options.runs_per_joint = grantedRuns(prepared, options);
  const std::vector<JointTask> tasks = tasksOf(prepared, options.only);
  auto [found, notes] = diagnoseTasks(tasks, prepared, options);
  addRecords(found, records, tasks);
  JointLevelDiagnosis diagnosis{std::move(found), std::move(notes), {}};
  if (options.examine) diagnosis.examined = examineJoints(diagnosis.found, tasks, options);
  return diagnosis;
}

// One robot's part of what a set of several may take and let pass.
JointLevelOptions partOf(const JointLevelOptions& all, const std::string& robot, std::size_t at,
                         std::size_t robots) {
  const auto count = static_cast<double>(robots);
  JointLevelOptions options = all;
  options.effort.false_alarms /= count;
  options.seconds /= count;
  options.kept = all.kept.part(robot);
  if (!all.progress) return options;
  options.progress = [&all, robot, at, count](const std::string& what, double part) {
    all.progress(robot + ": " + what, (static_cast<double>(at) + part) / count);
  };
  return options;
}

void add(const std::string& robot, JointLevelDiagnosis one, JointLevelDiagnosis& all) {
  for (SharedFinding& shared : one.found.shared) {
    shared.robot_id = robot;
    all.found.shared.push_back(std::move(shared));
  }
  for (JointVerdict& joint : one.found.joints) {
    joint.joint = robot + "/" + joint.joint;
    all.found.joints.push_back(std::move(joint));
  }
  for (ExaminedJoint& joint : one.examined) all.examined.push_back(std::move(joint));
  if (!one.notes.empty()) all.notes += robot + ": " + one.notes;
  all.found.critical_gain = std::max(all.found.critical_gain, one.found.critical_gain);
  all.found.null_sets = one.found.null_sets;
  all.found.runs += one.found.runs;
}

}  // namespace

JointLevelDiagnosis diagnoseJointLevel(const LogSet& set,
                                       const std::shared_ptr<const RobotModel>& model,
                                       const VerdictRecords& records,
                                       const JointLevelOptions& options) {
  const std::vector<std::string> robots = robotsOf(set);
  if (robots.size() < 2) return diagnoseRobot(set, model, records, options);
  std::vector<LogSet> sets;
  for (const std::string& robot : robots) {
    sets.push_back(runsOf(set, robot));
    sets.back().name += " of robot " + robot;
    requireRuns(sets.back(), {Split::Fit});
  }
  JointLevelDiagnosis all;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const JointLevelOptions part = partOf(options, robots[i], i, robots.size());
    add(robots[i], diagnoseRobot(sets[i], model, records, part), all);
  }
  all.found.verdict = overall(all.found);
  return all;
}

}  // namespace nao::validation
