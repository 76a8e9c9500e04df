#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "core/sim_time.h"
#include "core/world_model.h"
#include "sim/world.h"
#include "validation/plot.h"
#include "validation/report.h"

namespace nao::validation {

/// What the user can choose for an experiment. Each heeds those that it lists.
enum class Choice { Robot, World, Step, Mode, Seed, Runs, Duration, Metres, Newton };

struct ExperimentSettings {
  std::string robots_dir = "robots";
  std::string motions_dir = "motions";
  std::string robot = "nao_h21_v33";
  std::string world;  // a file; empty: a flat ground
  Duration step = std::chrono::milliseconds(2);
  sim::Mode mode = sim::Mode::Implicit;
  std::uint64_t seed = 0;  // 0: none
  int runs = 1;
  Duration duration{};
  double metres = 0;  // to walk in all; 0: none
  double newton = 0;  // of a push; 0: the experiment looks for the strongest one
};

struct Outcome {
  Report report;
  Picture picture;
};

/// An experiment as `usarnaoqi experiment NAME` offers it. Same settings, same outcome to the last
/// bit, but for figures whose name says cpu, wall, realtime or memory.
struct Experiment {
  std::string name;
  std::string summary;  // one sentence
  std::vector<Choice> choices;
  ExperimentSettings defaults;
  std::function<Outcome(const ExperimentSettings&)> run;

  bool heeds(Choice choice) const;
};

/// All of them, in the order of the thesis.
const std::vector<Experiment>& experiments();

// One file each.
Experiment gravityExperiment();
Experiment timestepExperiment();
Experiment standExperiment();
Experiment thrashExperiment();
Experiment headYawExperiment();
Experiment robotsExperiment();
Experiment sonarExperiment();
Experiment walkExperiment();
Experiment turnExperiment();
Experiment kickExperiment();
Experiment taichiExperiment();
Experiment singlestepExperiment();
Experiment circleExperiment();
Experiment fastWalkExperiment();
Experiment randomWalkExperiment();
Experiment pushExperiment();
Experiment slopeExperiment();
Experiment moveToExperiment();
Experiment standUpExperiment();
Experiment posturesExperiment();

/// What all experiments with a robot start from. @throws InputError.
std::shared_ptr<const RobotModel> loadRobot(const ExperimentSettings& settings);
std::shared_ptr<const WorldModel> loadWorld(const ExperimentSettings& settings);

/// A report with its head filled in.
Report startReport(const char* name, const ExperimentSettings& settings);

}  // namespace nao::validation
