#include "validation/diagnosis/replay/whole_simulator.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "core/random.h"
#include "core/world_model.h"
#include "sim/effects/parameter.h"
#include "sim/world.h"
#include "validation/diagnosis/replay/gait_numbers.h"
#include "validation/diagnosis/replay/replay_start.h"
#include "validation/diagnosis/rig/run_load.h"
#include "validation/merge_effects.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

// Steps are implicit Euler's, off by as much as they are long. A swinging leg by 2 ms is off by
// more than its noise from one by 0.25 ms: its misfit is 3, at 1 ms 1.1. A walk by 2 ms is 0.7 ms
// late and 1.3 mrad RMS off, at 0.5 ms 0.1 ms and 0.5 mrad, which is how far its runs part anyway.
constexpr auto kHungStep = std::chrono::milliseconds(1);
constexpr auto kHungExactStep = std::chrono::microseconds(250);
constexpr auto kFloorStep = std::chrono::milliseconds(2);
constexpr auto kFloorExactStep = std::chrono::microseconds(500);

constexpr double kFallenTilt = 45 * M_PI / 180;  // [rad] nobody comes back from there

// What a walk makes of its gyroscope is in the commands of a run already; what it would have made
// of what a replay feels beside that is added here, or a replay rocks as no walk would. Ankles that
// stand turn with the torso's excess rate, and with its excess pitch a little; hips give way in
// roll. The law is the ankle strategy that walks have in common (Horak and Nashner 1986); the gains
// are of the order that walks for a Nao use. Free choices.
class Balance {
 public:
  explicit Balance(const RobotModel& model) {
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string side = i == 0 ? "L" : "R";
      pitch_[i] = model.findJoint(side + "AnklePitch");
      roll_[i] = model.findJoint(side + "AnkleRoll");
      hip_[i] = model.findJoint(side + "HipRoll");
    }
  }

  void apply(const SensorFrame& frame, const WholeRun& measured, Eigen::Index k,
             JointArray<double>& angle) const {
    const double roll_rate = frame.gyroscope.x() - measured.turning(k, 0);
    const double pitch_rate = frame.gyroscope.y() - measured.turning(k, 1);
    const double pitch = frame.angle_y - measured.tilt(k, 1);
    const double weight = frame.feet[0].total + frame.feet[1].total;
    for (std::size_t i = 0; i < 2; ++i) {
      if (frame.feet[i].total < kStands * weight) continue;
      add(angle, roll_[i], kRollRate * roll_rate);
      add(angle, pitch_[i], kPitchRate * pitch_rate + kPitch * pitch);
      add(angle, hip_[i], -kHip * roll_rate);
    }
  }

 private:
  static constexpr double kRollRate = 0.06, kPitchRate = 0.035, kHip = 0.02;  // [s]
  static constexpr double kPitch = 0.1;
  static constexpr double kStands = 0.1;  // of the weight
  static constexpr double kMost = 0.15;   // [rad]

  static void add(JointArray<double>& angle, const std::optional<Joint>& joint, double by) {
    if (joint) angle[*joint] += std::clamp(by, -kMost, kMost);
  }

  std::array<std::optional<Joint>, 2> pitch_, roll_, hip_;  // left, right
};

bool walks(const WholeRun& run) {
  if (run.turning.size() == 0 || run.tilt.size() == 0) return false;
  for (const GaitNumber& number : calcGait(run)) {
    if (number.name == "steps") return number.value >= 3;
  }
  return false;
}

// One replay of a run's commands.
class Replay {
 public:
  Replay(std::shared_ptr<const RobotModel> model, const WholeRun& measured, const Balance* balance,
         const sim::WorldOptions& options)
      : measured_(measured),
        balance_(balance),
        catalogue_(*options.effects),
        drawn_(options.seed != 0),
        robot_(*model),
        world_(std::make_shared<WorldModel>(), {{"robot", std::move(model), {}}}, options),
        order_{JointArray<double>(robot_.jointCount()), JointArray<double>(robot_.jointCount())} {}

  WholeRun run(double settle, std::uint64_t seed) {
    begin();
    take(0);
    Random random(seed, "start");
    const JointArray<double> start =
        startAngles(robot_, measured_, catalogue_, drawn_ ? &random : nullptr);
    world_.placeRobot(0, {}, &start);
    for (long i = std::lround(settle / measured_.dt); i > 0; --i) {
      world_.readSensors(0);
      move();
    }
    for (Eigen::Index k = 0; k < measured_.rows() && world_.healthy(); ++k) {
      take(k);
      const SensorFrame frame = world_.readSensors(0);
      if (balance_) balance_->apply(frame, measured_, k, order_.angle);
      move();
      row(k, frame);
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
    for (Eigen::MatrixXd WholeRun::*signal :
         {&WholeRun::tilt, &WholeRun::acceleration, &WholeRun::turning, &WholeRun::weight,
          &WholeRun::place}) {
      (played_.*signal).setZero((measured_.*signal).rows(), (measured_.*signal).cols());
    }
  }

  void take(Eigen::Index k) {
    for (std::size_t j = 0; j < robot_.jointCount(); ++j) {
      order_.angle[j] = measured_.command(k, static_cast<Eigen::Index>(j));
      order_.stiffness[j] = measured_.stiffness(k, static_cast<Eigen::Index>(j));
    }
  }

  void move() {
    world_.setCommand(0, order_);
    const SimTime end = world_.now() + robot_.cycle;
    while (world_.now() < end && world_.healthy()) world_.step();
  }

  void row(Eigen::Index k, const SensorFrame& frame) {
    for (std::size_t j = 0; j < robot_.jointCount(); ++j) {
      played_.angle(k, static_cast<Eigen::Index>(j)) = frame.angle[j];
    }
    lookForFall();
    if (played_.tilt.size() > 0) played_.tilt.row(k) << frame.angle_x, frame.angle_y;
    if (played_.acceleration.size() > 0) {
      played_.acceleration.row(k) = frame.accelerometer.transpose();
    }
    if (played_.turning.size() > 0) {
      played_.turning.row(k) = frame.gyroscope.head(played_.turning.cols()).transpose();
    }
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
  const Balance* balance_;  // null: the robot did not walk
  const sim::EffectCatalogue& catalogue_;
  const bool drawn_;
  const RobotModel robot_;
  sim::World world_;
  JointCommand order_;
  WholeRun played_;
};

// Rows up to half a second after the last order that differs from the one before: a robot that
// stands still tells no more.
Eigen::Index rowsThatMove(const WholeRun& run) {
  constexpr double kStill = 1e-4;  // [rad]
  Eigen::Index last = run.rows() - 1;
  while (last > 0 &&
         (run.command.row(last) - run.command.row(last - 1)).cwiseAbs().maxCoeff() < kStill) {
    --last;
  }
  if (last == 0) return run.rows();
  return std::min<Eigen::Index>(run.rows(), last + std::lround(0.5 / run.dt));
}

void cut(WholeRun& run, Eigen::Index rows) {
  for (Eigen::MatrixXd* signal : {&run.command, &run.stiffness, &run.angle, &run.tilt,
                                  &run.acceleration, &run.turning, &run.weight, &run.place}) {
    if (signal->rows() > rows) signal->conservativeResize(rows, Eigen::NoChange);
  }
}

void scale(EffectSetting& effect, const char* parameter, double by) {
  const auto at = effect.parameters.find(parameter);
  if (at == effect.parameters.end()) return;
  const double most = sim::parameterOf(sim::standardEffects(), effect.name, parameter).max;
  at->second = std::min(at->second * by, most);
}

// Why repeats differ, as far as it is drawn anew in every run: the floor of a set is one floor, and
// places count from where a run began.
std::vector<EffectSetting> noiseOf(const RobotModel& model, const NoiseParts& parts) {
  std::vector<EffectSetting> noise;
  if (parts.torque <= 0) return noise;
  for (EffectSetting effect : model.noise) {
    if (effect.name == "floor_friction" || effect.name == "start_pose") continue;
    if (effect.name == "process_noise") scale(effect, "sd", parts.torque);
    if (effect.name == "encoder_jitter") scale(effect, "amplitude", parts.jitter);
    noise.push_back(std::move(effect));
  }
  return noise;
}

}  // namespace

bool isOnItsFeet(const LogSet& set, const RobotModel& model) {
  return !set.environment.suspended && !model.fixed_base;
}

WholeSimulator::WholeSimulator(const LogSet& set, std::shared_ptr<const RobotModel> model,
                               const WholeOptions& options)
    : model_(std::move(model)), options_(options) {
  if (set.environment.suspended && !model_->fixed_base) {
    model_ = std::make_shared<RobotModel>(suspend(*model_));
  }
  joints_ = jointsMeasured(set, *model_);
  if (joints_.empty()) throw InputError(set.name + ": no joint was measured in all runs");
  for (const Split split : options_.splits) {
    for (const LogRun& run : set.runs) {
      if (run.split != split) continue;
      const auto same = [&](const WholeBlock& block) {
        return block.motion == run.motion && block.split == split;
      };
      auto at = std::find_if(blocks_.begin(), blocks_.end(), same);
      if (at == blocks_.end()) at = blocks_.insert(at, WholeBlock{run.motion, split, {}, 0});
      measured_.push_back(wholeRunOf(run, set, *model_));
      at->rows = std::max(at->rows, rowsThatMove(measured_.back()));
      at->runs.push_back(measured_.size() - 1);
    }
  }
  for (WholeBlock& block : blocks_) {
    for (const std::size_t run : block.runs) {
      block.rows = std::min(block.rows, measured_[run].rows());
    }
    for (const std::size_t run : block.runs) cut(measured_[run], block.rows);
  }
  for (const WholeRun& run : measured_) walks_.push_back(!model_->fixed_base && walks(run));
  const Split first = options_.splits.front();
  if (blocks_.empty() || blocks_.front().split != first) {
    throw InputError(set.name + ": expected at least one run to " + nameOf(first));
  }
}

Duration WholeSimulator::step(Pace pace) const {
  if (model_->fixed_base) return pace == Pace::Exact ? Duration(kHungExactStep) : kHungStep;
  return pace == Pace::Exact ? Duration(kFloorExactStep) : kFloorStep;
}

std::vector<Joint> WholeSimulator::judged() const {
  std::vector<Joint> some;
  for (const Joint joint : joints_) {
    const bool shared = model_->actuators[index(joint)].coordinates.size() > 1;
    if (model_->fixed_base || !shared) some.push_back(joint);
  }
  return some;
}

const sim::EffectCatalogue& WholeSimulator::catalogue() const {
  return options_.catalogue ? *options_.catalogue : sim::standardEffects();
}

std::shared_ptr<const RobotModel> WholeSimulator::robotOf(const WholeRun& run,
                                                          const std::vector<EffectSetting>& causes,
                                                          const NoiseParts& noise) const {
  auto robot = std::make_shared<RobotModel>(*model_);
  robot->variation.clear();
  for (Actuator& actuator : robot->actuators) actuator.kp *= run.kp_scale;
  // Noise first: the place in the list is part of a stream's name.
  robot->effects = noiseOf(*model_, noise);
  for (EffectSetting& effect : mergedEffects(*model_, causes, catalogue())) {
    robot->effects.push_back(std::move(effect));
  }
  if (!run.load) return robot;
  if (auto payload = effectOf(*run.load, *model_)) robot->effects.push_back(std::move(*payload));
  return robot;
}

WholeRun WholeSimulator::simulate(const std::vector<EffectSetting>& causes, std::size_t run,
                                  std::uint64_t stream, const NoiseParts& noise, Pace pace) const {
  sim::WorldOptions options(step(pace));
  options.seed = stream;
  options.effects = &catalogue();
  options.any_step = true;
  const Balance balance(*model_);
  const Balance* balances = walks_[run] ? &balance : nullptr;
  return Replay(robotOf(measured_[run], causes, noise), measured_[run], balances, options)
      .run(options_.settle, stream);
}

}  // namespace nao::validation
