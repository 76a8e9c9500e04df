#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/joint/joint_search.h"

// Searches for what is wrong with a ToyJoint.
namespace nao::validation::test {

// A fraction of what a diagnosis takes by default: enough for effects that are far from small.
inline Effort quick() {
  Effort effort;
  effort.look_runs = 4;
  effort.final_runs = 8;
  effort.difference_runs = 16;
  effort.base_runs = 24;
  effort.null_sets = 50;
  effort.survivors = 5;
  effort.finalists = 2;
  effort.most_causes = 1;
  return effort;
}

inline JointVerdict diagnose(const ToyLaws& truth, const std::vector<Cause>& causes,
                             const Effort& effort = quick(), long granted = 1000000,
                             const JointNoise& noise = kToyNoise) {
  const ToyJoint toy(truth, 1, noise, 6, 3);
  JointSearch search(toy, noise, causes, effort, granted);
  search.begin();
  return search.conclude({});
}

inline std::vector<Cause> without(const std::vector<std::string>& ids) {
  std::vector<Cause> causes;
  for (const Cause& cause : toyCauses()) {
    if (std::find(ids.begin(), ids.end(), cause.id) == ids.end()) causes.push_back(cause);
  }
  return causes;
}

inline std::vector<Cause> withStop() {
  std::vector<Cause> causes = toyCauses();
  for (const Cause& cause : jointCauses()) {
    if (cause.id == "joint_stop.lower") causes.push_back(cause);
  }
  return causes;
}

inline ToyLaws softServo() {
  ToyLaws laws;
  laws.kp *= 0.7;
  return laws;
}

}  // namespace nao::validation::test
