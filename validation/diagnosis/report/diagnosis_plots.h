#pragma once

#include <utility>
#include <vector>

#include "validation/diagnosis/joint/diagnose.h"
#include "validation/diagnosis/replay/replay.h"
#include "validation/plot.h"

namespace nao::validation {

/// The effects that stand for what was found at a joint, at its `place` (JointSimulator::place),
/// those that all joints share included: numbers that were not fitted do nothing.
std::vector<EffectSetting> foundEffects(const SetDiagnosis& diagnosis, const JointVerdict& joint,
                                        const std::vector<Joint>& place);

/// One joint in one motion: mean of the repeats against mean of simulated runs.
struct JointCourse {
  std::string motion;
  double dt = 0;                                  // [s]
  Eigen::VectorXd measured, nominal, extended;    // [rad] means
  Eigen::VectorXd floor;                          // [rad] SD of the measured mean
  Eigen::VectorXd measured_sd{}, simulated_sd{};  // [rad] of one run; empty: not known
  std::string rival{};  // the first of a finding's rivals, in its place; empty: there is none
  Eigen::VectorXd with_rival{};
};

/// The same with the first rival that has numbers in the place of its finding, and the rival's
/// name; an empty name: no finding of this joint has one.
std::pair<std::string, std::vector<EffectSetting>> rivalEffects(const SetDiagnosis& diagnosis,
                                                                const JointVerdict& joint,
                                                                const std::vector<Joint>& place);

/// The motion in which the nominal model is furthest off, of those that were replayed.
JointCourse worstCourse(const JointSimulator& joint, const ReplayedRuns& nominal,
                        const ReplayedRuns& extended);
/// Adds what a rival makes of that motion, by `runs` runs.
void addRival(JointCourse& course, const JointTask& task, const std::string& rival,
              const std::vector<EffectSetting>& effects, int runs);

/// The angle, measured and simulated; below what is left of the error, in the band of noise, and
/// the spread of runs.
Picture drawCourse(const JointCourse& course);

/// Over the same motion: the error against the joint's speed and angle, where friction, play and
/// loads each draw a shape of their own.
Picture drawSignature(const JointCourse& course);

/// The finding's Finding::profile with the interval; it must have one.
Picture drawProfile(const Finding& finding);

/// What each cause explains or would have explained [nats], the largest first, and the threshold.
Picture drawRanking(const JointVerdict& joint);

}  // namespace nao::validation
