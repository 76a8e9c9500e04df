#include "validation/diagnosis/whole_simulator.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "core/random.h"
#include "core/world_model.h"
#include "sim/world.h"
#include "validation/diagnosis/merge_effects.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

constexpr double kFallenTilt = 45 * M_PI / 180;  // [rad] nobody comes back from there

// One replay of a run's commands.
class Replay {
 public:
  Replay(std::shared_ptr<const RobotModel> model, const WholeRun& measured,
         const sim::WorldOptions& options)
      : measured_(measured),
        catalogue_(*options.effects),
        drawn_(options.seed != 0),
        robot_(*model),
        world_(std::make_shared<WorldModel>(), {{"robot", std::move(model), {}}}, options),
        order_{JointArray<double>(robot_.jointCount()), JointArray<double>(robot_.jointCount())} {}

  WholeRun run(double settle, std::uint64_t seed) {
    begin();
    take(0);
    const JointArray<double> start = startAngles(Random(seed, "start"));
    world_.placeRobot(0, {}, &start);
    for (long i = std::lround(settle / measured_.dt); i > 0; --i) cycle();
    for (Eigen::Index k = 0; k < measured_.rows() && world_.healthy(); ++k) {
      take(k);
      row(k, cycle());
    }
    if (!world_.healthy()) played_.fell = true;
    if (played_.place.size() > 0) played_.place = fromFirstRow(played_.place);
    return std::move(played_);
  }

 private:
  void begin() {
    const Eigen::Index rows = measured_.rows();
    played_.dt = measured_.dt;
    played_.command = measured_.command;
    played_.stiffness = measured_.stiffness;
    played_.angle = Eigen::MatrixXd::Zero(rows, measured_.angle.cols());
    played_.tilt = Eigen::MatrixXd::Zero(measured_.tilt.rows(), measured_.tilt.cols());
    played_.weight = Eigen::MatrixXd::Zero(measured_.weight.rows(), measured_.weight.cols());
    played_.place = Eigen::MatrixXd::Zero(measured_.place.rows(), measured_.place.cols());
  }

  // Where the links were: feet that stand hold the legs beside their commands. Encoders see the
  // motors; a motor that pushes is ahead of its link by half the play; else nobody knows.
  JointArray<double> startAngles(Random random) const {
    constexpr double kPushes = 0.003;  // [rad] of error: two counts of a Nao's encoder
    JointArray<double> angle = order_.angle;
    for (std::size_t j = 0; j < robot_.jointCount(); ++j) {
      const double measured = measured_.angle(0, static_cast<Eigen::Index>(j));
      if (measured == 0) continue;
      const double play = presentDeviation(robot_, j, "backlash", "width", catalogue_);
      const double side = std::clamp((order_.angle[j] - measured) / kPushes, -1.0, 1.0);
      const double unknown = drawn_ ? (1 - std::abs(side)) * random.uniform(-1, 1) : 0;
      angle[j] = measured - (side + unknown) * play / 2;
    }
    return angle;
  }

  void take(Eigen::Index k) {
    for (std::size_t j = 0; j < robot_.jointCount(); ++j) {
      order_.angle[j] = measured_.command(k, static_cast<Eigen::Index>(j));
      order_.stiffness[j] = measured_.stiffness(k, static_cast<Eigen::Index>(j));
    }
  }

  SensorFrame cycle() {
    const SensorFrame frame = world_.readSensors(0);
    world_.setCommand(0, order_);
    const SimTime end = world_.now() + robot_.cycle;
    while (world_.now() < end && world_.healthy()) world_.step();
    return frame;
  }

  void row(Eigen::Index k, const SensorFrame& frame) {
    for (std::size_t j = 0; j < robot_.jointCount(); ++j) {
      played_.angle(k, static_cast<Eigen::Index>(j)) = frame.angle[j];
    }
    lookForFall();
    if (played_.tilt.size() > 0) played_.tilt.row(k) << frame.angle_x, frame.angle_y;
    if (played_.weight.size() > 0) {
      played_.weight.row(k) << frame.feet[0].total, frame.feet[1].total;
    }
    if (played_.place.size() > 0) writePlace(k);
  }

  void lookForFall() {
    const Pose X_WT = world_.scene().robots[0].X_WB[0];
    if (!robot_.fixed_base && X_WT.linear()(2, 2) < std::cos(kFallenTilt)) played_.fell = true;
  }

  void writePlace(Eigen::Index k) {
    const Pose X_WT = world_.scene().robots[0].X_WB[0];
    double yaw = std::atan2(X_WT.linear()(1, 0), X_WT.linear()(0, 0));
    if (k > 0) yaw = played_.place(k - 1, 2) + wrapAngle(yaw - played_.place(k - 1, 2));
    played_.place.row(k) << X_WT.translation().x(), X_WT.translation().y(), yaw;
  }

  const WholeRun& measured_;
  const sim::EffectCatalogue& catalogue_;
  const bool drawn_;
  const RobotModel robot_;
  sim::World world_;
  JointCommand order_;
  WholeRun played_;
};

// Why repeats differ, as far as it is drawn anew in every run: the floor of a set is one floor, and
// places count from where a run began.
std::vector<EffectSetting> noiseOf(const RobotModel& model, double scale) {
  std::vector<EffectSetting> noise;
  for (EffectSetting effect : model.noise) {
    if (effect.name == "floor_friction" || effect.name == "start_pose") continue;
    const auto sd = effect.parameters.find("sd");
    if (effect.name == "process_noise" && sd != effect.parameters.end()) sd->second *= scale;
    noise.push_back(std::move(effect));
  }
  return noise;
}

}  // namespace

WholeSimulator::WholeSimulator(const LogSet& set, std::shared_ptr<const RobotModel> model,
                               const WholeOptions& options)
    : model_(std::move(model)), options_(options) {
  if (set.environment.suspended && !model_->fixed_base) {
    model_ = std::make_shared<RobotModel>(suspend(*model_));
  }
  joints_ = jointsMeasured(set, *model_);
  if (joints_.empty()) throw InputError(set.name + ": no joint was measured in all runs");
  for (const Split split : {Split::Fit, Split::Select}) {
    for (const LogRun& run : set.runs) {
      if (run.split != split) continue;
      const auto same = [&](const WholeBlock& block) {
        return block.motion == run.motion && block.split == split;
      };
      auto at = std::find_if(blocks_.begin(), blocks_.end(), same);
      if (at == blocks_.end()) at = blocks_.insert(at, WholeBlock{run.motion, split, {}, 0});
      measured_.push_back(wholeRunOf(run, set, *model_));
      const Eigen::Index rows = measured_.back().rows();
      at->rows = at->runs.empty() ? rows : std::min(at->rows, rows);
      at->runs.push_back(measured_.size() - 1);
    }
  }
  if (blocks_.empty() || blocks_.front().split != Split::Fit) {
    throw InputError(set.name + ": expected at least one run to fit");
  }
}

const sim::EffectCatalogue& WholeSimulator::catalogue() const {
  return options_.catalogue ? *options_.catalogue : sim::standardEffects();
}

std::shared_ptr<const RobotModel> WholeSimulator::withEffects(
    const std::vector<EffectSetting>& causes, double noise) const {
  auto robot = std::make_shared<RobotModel>(*model_);
  robot->variation.clear();
  // Noise first: the place in the list is part of a stream's name.
  robot->effects = noise > 0 ? noiseOf(*model_, noise) : std::vector<EffectSetting>{};
  for (EffectSetting& effect : mergedEffects(*model_, causes, catalogue())) {
    robot->effects.push_back(std::move(effect));
  }
  return robot;
}

WholeRun WholeSimulator::simulate(const std::vector<EffectSetting>& causes, std::size_t run,
                                  std::uint64_t stream, double noise) const {
  sim::WorldOptions options(options_.step);
  options.seed = stream;
  options.effects = &catalogue();
  return Replay(withEffects(causes, noise), measured_[run], options).run(options_.settle, stream);
}

}  // namespace nao::validation
