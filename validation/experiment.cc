#include "validation/experiment.h"

#include <algorithm>

namespace nao::validation {

bool Experiment::heeds(Choice choice) const {
  return std::find(choices.begin(), choices.end(), choice) != choices.end();
}

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{
      gravityExperiment(),  timestepExperiment(), standExperiment(),      thrashExperiment(),
      kickExperiment(),     taichiExperiment(),   singlestepExperiment(), walkExperiment(),
      turnExperiment(),     circleExperiment(),   fastWalkExperiment(),   randomWalkExperiment(),
      pushExperiment(),     slopeExperiment(),    moveToExperiment(),     standUpExperiment(),
      posturesExperiment(), headYawExperiment(),  robotsExperiment(),     sonarExperiment()};
  return all;
}

std::shared_ptr<const RobotModel> loadRobot(const ExperimentSettings& settings) {
  return loadRobotModel(settings.robots_dir, settings.robot);
}

std::shared_ptr<const WorldModel> loadWorld(const ExperimentSettings& settings) {
  if (!settings.world.empty()) return loadWorldModel(settings.world);
  auto flat = std::make_shared<WorldModel>();
  flat->name = "flat";
  return flat;
}

Report startReport(const char* name, const ExperimentSettings& settings) {
  Report report;
  report.command = std::string("experiment ") + name;
  report.robot = settings.robot;
  report.seed = settings.seed;
  report.runs = settings.runs;
  report.step_s = toSeconds(settings.step);
  return report;
}

}  // namespace nao::validation
