#include "validation/diagnosis/extend/whole_optimise.h"

#include <algorithm>
#include <memory>

#include "core/check.h"
#include "validation/diagnosis/maths/block_bootstrap.h"
#include "validation/diagnosis/replay/whole_replay.h"
#include "validation/diagnosis/whole/whole_numbers.h"
#include "validation/diagnosis/whole/whole_spread.h"
#include "validation/merge_effects.h"

namespace nao::validation {
namespace {

constexpr int kMostFits = 4;     // one after another, as long as they gain
constexpr double kNothing = 1;   // [nats] that a further fit gains at most
constexpr int kEachMotion = 16;  // runs that an error is told by

/// The numbers to fit, as causes of the whole robot.
class Numbers {
 public:
  Numbers(const std::vector<FreeParameter>& free, const WholeSimulator& simulator)
      : simulator_(simulator) {
    for (const FreeParameter& one : free) {
      if (one.joint != kEachJoint) {
        add(one);
        continue;
      }
      for (const Joint joint : simulator.judged()) {
        add({one.effect, one.parameter, simulator.model().actuators[index(joint)].name});
      }
    }
    for (PlacedCause& one : causes_) {
      one = placedCause(one.cause, one.place, one.joints, simulator.model(), simulator.joints());
    }
  }

  const std::vector<PlacedCause>& causes() const { return causes_; }

  /// As the robot is, or with every effect on as its catalogue has it.
  CauseList start(bool on) const {
    CauseList model;
    for (std::size_t c = 0; c < causes_.size(); ++c) {
      model.push_back({c, {}});
      for (const FreeNumber& number : causes_[c].cause.free) {
        const sim::Parameter& p = parameterOf({causes_[c].cause.effect, number.parameter, ""});
        const double nominal = std::clamp(p.nominal - p.neutral, number.lower, number.upper);
        model.back().x.push_back(on ? nominal : 0);
      }
    }
    return model;
  }

  /// In the order of the model's numbers.
  std::vector<OptimisedNumber> list(const CauseList& model, const Eigen::MatrixXd& draws) const {
    std::vector<OptimisedNumber> all;
    for (const Chosen& one : model) {
      for (std::size_t i = 0; i < one.x.size(); ++i) {
        const Eigen::VectorXd moves = draws.row(static_cast<Eigen::Index>(all.size()));
        all.push_back(numberOf(causes_[one.cause], i, one.x[i], moves));
      }
    }
    return all;
  }

 private:
  // Numbers of one effect at one place act together.
  void add(const FreeParameter& free) {
    const std::string place = free.joint.empty() ? "robot" : free.joint;
    const auto same = [&](const PlacedCause& one) {
      return one.cause.effect == free.effect && one.place == place;
    };
    auto at = std::find_if(causes_.begin(), causes_.end(), same);
    if (at == causes_.end()) {
      Cause cause;
      cause.id = cause.effect = free.effect;
      std::vector<Joint> joints;
      if (!free.joint.empty()) joints = {*simulator_.model().findJoint(free.joint)};
      at = causes_.insert(at, {std::move(cause), place, joints});
    }
    at->cause.free.push_back({free.parameter, {}, Form::Offset, "", 0, 0, 0, 0});
  }

  OptimisedNumber numberOf(const PlacedCause& placed, std::size_t i, double x,
                           const Eigen::VectorXd& moves) const {
    const FreeNumber& number = placed.cause.free[i];
    const std::string joint = placed.joints.empty() ? "" : placed.place;
    // What the robot has of it already, at the first joint that it concerns.
    const Joint first = placed.joints.empty() ? simulator_.joints()[0] : placed.joints[0];
    const double present = presentDeviation(simulator_.model(), index(first), placed.cause.effect,
                                            number.parameter, simulator_.catalogue());
    const double margin = 1e-6 * (number.upper - number.lower);
    return {{placed.cause.effect, number.parameter, joint},
            {number.parameter, number.unit, number.neutral + present + x, x,
             x + quantileOf(moves, 0.05), x + quantileOf(moves, 0.95)},
            x < number.lower + margin || x > number.upper - margin};
  }

  const WholeSimulator& simulator_;
  std::vector<PlacedCause> causes_;
};

WholeFit fitTillDone(const WholeTask& task, const WholeStage& stage, const CauseList& start) {
  WholeFit best = fitModel(task, stage, start, task.jobs);
  for (int i = 1; i < kMostFits; ++i) {
    WholeFit next = fitModel(task, stage, best.model, task.jobs);
    const bool done = next.cost > best.cost - kNothing;
    if (next.cost < best.cost) best = std::move(next);
    if (done) break;
  }
  return best;
}

// To where many runs ask the numbers to be.
std::unique_ptr<WholeStage> walkOn(const WholeTask& task, WholeFit& fit) {
  auto stage = std::make_unique<WholeStage>(task, fit.model, fit.jacobian);
  for (int i = 0; i < kMostFarSteps; ++i) {
    auto to = farStep(task, *stage, fit);
    if (!to) break;
    fit.model = std::move(*to);
    addJacobian(task, fit, stage.get());
    stage = std::make_unique<WholeStage>(task, fit.model, fit.jacobian);
  }
  refine(task, *stage, fit);
  return stage;
}

// `change`: of the runs, a column per number.
void requireShown(const Eigen::MatrixXd& change, const std::vector<OptimisedNumber>& numbers,
                  const LogSet& set) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (change.col(static_cast<Eigen::Index>(i)).norm() > 0) continue;
    throw InputError("--free " + nameOf(numbers[i].what) + ": " + set.name + " does not show it");
  }
}

// A fit takes long: first, whether anything moves as the robot is or with the effects on.
void requireShownAnywhere(const WholeTask& task, const Numbers& numbers, const LogSet& set) {
  WholeFit off, on;
  off.model = numbers.start(false);
  on.model = numbers.start(true);
  addJacobian(task, off);
  addJacobian(task, on);
  requireShown(off.jacobian.cwiseAbs() + on.jacobian.cwiseAbs(),
               numbers.list(off.model, Eigen::MatrixXd::Zero(off.jacobian.cols(), 1)), set);
}

// Mean absolute error of all joints' angles [rad]; 0 of a split without runs.
double errorOf(const LogSet& set, const std::shared_ptr<const RobotModel>& model,
               const std::vector<EffectSetting>& settings, Split split, int jobs) {
  const auto of_split = [&](const LogRun& run) { return run.split == split; };
  if (std::none_of(set.runs.begin(), set.runs.end(), of_split)) return 0;
  WholeOptions options;
  options.splits = {split};
  const WholeSimulator simulator(set, model, options);
  const WholeReplay replay =
      replayWhole(simulator, settings, runsOfEach(simulator, kEachMotion), jobs);
  double sum = 0;
  for (const JointReplay& joint : replay.joints) sum += joint.mae;
  return sum / static_cast<double>(replay.joints.size());
}

}  // namespace

Optimised optimiseWhole(const LogSet& set, const std::shared_ptr<const RobotModel>& model,
                        const std::vector<FreeParameter>& free, const OptimiseOptions& options) {
  WholeOptions whole;
  whole.splits = {Split::Fit};
  const WholeSimulator simulator(set, model, whole);
  WholeData data(simulator, simulator.judged(), true);
  const Numbers numbers(free, simulator);
  WholeTask task{&data, &numbers.causes(), {}, {}, options.jobs};
  task.effort.fit_runs = options.runs;
  task.noise = fitSpread(data, {}, task.effort.base_runs, options.jobs).noise;
  data.learnStepErrors({}, task.effort.step_runs, task.noise, options.jobs);
  requireShownAnywhere(task, numbers, set);
  const Eigen::MatrixXd none(data.size(), 0);
  const WholeStage stage(task, numbers.start(false), none);
  WholeFit best = fitTillDone(task, stage, numbers.start(false));
  WholeFit other = fitTillDone(task, stage, numbers.start(true));
  if (other.cost < best.cost) best = std::move(other);

  Optimised found;
  found.settings = settingsOf(numbers.causes(), best.model);
  task.noise = fitSpread(data, found.settings, task.effort.base_runs, options.jobs).noise;
  learnStepErrors(task, best.model);
  addJacobian(task, best, &stage);
  const auto at_best = walkOn(task, best);
  found.settings = settingsOf(numbers.causes(), best.model);
  found.numbers = numbers.list(best.model, drawNumbers(task, *at_best, best));
  requireShown(best.jacobian, found.numbers, set);
  found.intervals =
      "what chance would have made of the numbers in sets of the fitted model, and what "
      "signals disagree about beyond that";
  const auto error = [&](const std::vector<EffectSetting>& settings, Split split) {
    return errorOf(set, model, settings, split, options.jobs);
  };
  found.before = error({}, Split::Fit);
  found.after = error(found.settings, Split::Fit);
  found.select_before = error({}, Split::Select);
  found.select_after = error(found.settings, Split::Select);
  return found;
}

}  // namespace nao::validation
