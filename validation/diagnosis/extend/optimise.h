#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/joint/prepared_set.h"
#include "validation/report.h"

namespace nao::validation {

/// A number that a user wants fitted: `effect.parameter` for one number of all joints,
/// `effect.parameter@JOINT` for that joint, `effect.parameter@each` for every joint its own.
struct FreeParameter {
  std::string effect, parameter, joint;
};

inline constexpr const char* kEachJoint = "each";  // FreeParameter::joint of every joint

/// As it is written: "effect.parameter@joint".
std::string nameOf(const FreeParameter& free);
/// What the catalogue says of it.
const sim::Parameter& parameterOf(const FreeParameter& free);

/// "effect.parameter[@joint],...". @throws InputError for an effect, parameter or joint that is
/// none, and, unless of a `whole` robot, for effects that no single joint can show.
std::vector<FreeParameter> parseFree(const std::string& list, const RobotModel& model,
                                     bool whole = false);

struct OptimiseOptions {
  int jobs = 1;
  int runs = 8;  // simulated per motion where the set has repeats; without repeats: one, noiseless
  int sets = 400;  // drawn for the intervals
};

struct OptimisedNumber {
  FreeParameter what;
  FoundNumber found;  // value of the parameter, deviation from the robot and its 90 % interval
  bool at_bound = false;
};

struct Optimised {
  std::vector<OptimisedNumber> numbers;
  std::vector<EffectSetting> settings;  // deviations from the robot
  double before = 0, after = 0;         // [rad] mean absolute error of the fit motions
  double select_before = 0, select_after = 0;
  std::string intervals;  // what they are, for a person
};

/// Fits these numbers to the `fit` motions of a set, all at once, by the rigs of its joints;
/// `select` motions only tell the error, `test` motions are not opened.
Optimised optimise(const PreparedSet& set, const std::vector<FreeParameter>& free,
                   const OptimiseOptions& options);

Report reportOptimised(const Optimised& found, const std::string& robot);

}  // namespace nao::validation
