#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/replay/replay.h"
#include "validation/diagnosis/replay/whole_simulator.h"

namespace nao::validation {

/// A number of gait_numbers.h in the runs of a motion for one purpose: measured beside simulated.
struct GaitReplay {
  std::string motion, split, name, unit;
  double measured = 0;  // mean of the runs
  double error = 0;     // of the simulated mean
  double floor = 0;     // SD of the measured mean, or what is no difference if that is more
};

/// How far the model is from a robot on its feet.
struct WholeReplay {
  std::vector<JointReplay> joints;
  std::vector<GaitReplay> gait;
  int runs = 0, fell = 0;  // simulated, and how many of them ended on the floor
};

/// What replayJoint (replay.h) says of a hung-up joint, of every joint that `simulator` has
/// measured, with the torque noise of its robot's file. Runs of one motion are told different
/// things (a walk heeds its sensors), so that each is compared with `per_run` simulated ones of its
/// own commands, and errors are of the mean of these differences. `jobs`: threads; the result is
/// the same.
WholeReplay replayWhole(const WholeSimulator& simulator, const std::vector<EffectSetting>& causes,
                        int per_run, int jobs);

/// Runs to simulate of each measured one so that a motion has at least `per_motion`.
int runsOfEach(const WholeSimulator& simulator, int per_motion);

}  // namespace nao::validation
