#include "validation/diagnosis/extend/optimise.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <sstream>

#include "core/check.h"
#include "sim/effects/parameter.h"
#include "sim/joint_rig.h"
#include "validation/diagnosis/folds/diagnose_folds.h"
#include "validation/diagnosis/folds/motion_fit.h"
#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/maths/block_bootstrap.h"
#include "validation/diagnosis/maths/least_squares.h"

namespace nao::validation {
namespace {

constexpr std::size_t kManyLogs = 8;      // as blocks of their own; fewer are cut into seconds
constexpr Eigen::Index kBlockRows = 100;  // about a second
constexpr std::uint64_t kSeed = 1;

FreeParameter parseOne(const std::string& text, const RobotModel& model, bool whole) {
  const std::size_t at = text.find('@'), dot = text.find('.');
  FreeParameter free;
  if (dot == std::string::npos || (at != std::string::npos && at < dot)) {
    throw InputError("--free " + text + ": expected effect.parameter or effect.parameter@joint");
  }
  free.effect = text.substr(0, dot);
  free.parameter = text.substr(dot + 1, at == std::string::npos ? at : at - dot - 1);
  if (at != std::string::npos) free.joint = text.substr(at + 1);
  const sim::EffectType* type = sim::standardEffects().find(free.effect);
  if (type == nullptr || (!whole && !sim::actsOnJoint(*type))) {
    throw InputError("--free " + text + ": expected an effect" +
                     (whole ? "" : " that acts on a joint") + "; `usarnaoqi effects` lists all");
  }
  std::string names;
  for (const sim::Parameter& p : type->parameters) names += (names.empty() ? "" : ", ") + p.name;
  if (std::none_of(type->parameters.begin(), type->parameters.end(),
                   [&](const sim::Parameter& p) { return p.name == free.parameter; })) {
    throw InputError("--free " + text + ": expected a parameter of " + free.effect + ": " + names);
  }
  if (!free.joint.empty() && free.joint != kEachJoint && !model.findJoint(free.joint)) {
    throw InputError("--free " + text + ": " + model.name + " has no joint '" + free.joint + "'");
  }
  return free;
}

// One joint's share of the numbers: its causes, and the place of each of their numbers in the list.
struct JointShare {
  std::size_t joint = 0;  // of PreparedSet::joints
  std::vector<Cause> causes;
  CauseList model;
  std::vector<std::size_t> place;
  std::unique_ptr<MotionFit> fit;
  std::map<std::vector<double>, Eigen::VectorXd> known;  // residuals by own numbers

  CauseList at(const std::vector<double>& x) const {
    std::vector<double> own;
    for (const std::size_t i : place) own.push_back(x[i]);
    return withNumbers(model, own);
  }
};

/// All joints of a set, and the numbers they share or have alone.
class SetFit {
 public:
  SetFit(const PreparedSet& set, const std::vector<FreeParameter>& free,
         const OptimiseOptions& options)
      : set_(set), options_(options) {
    for (const FreeParameter& one : free) addNumber(one);
    for (std::size_t j = 0; j < set.joints.size(); ++j) addJoint(j);
  }

  const std::vector<FreeParameter>& numbers() const { return numbers_; }

  FitSpace space() const {
    FitSpace space;
    space.iterations = 30;
    space.start.assign(numbers_.size(), 0);
    for (const FreeParameter& one : numbers_) {
      const sim::Parameter& p = parameterOf(one);
      space.lower.push_back(p.min - p.neutral);
      space.upper.push_back(p.max - p.neutral);
      space.step.push_back(p.smallest / 2);
    }
    for (const JointShare& share : shares_) {
      std::size_t next = 0;
      for (const Cause& cause : share.causes) {
        for (const FreeNumber& number : cause.free) {
          const std::size_t i = share.place[next++];
          space.lower[i] = std::max(space.lower[i], number.lower);
          space.upper[i] = std::min(space.upper[i], number.upper);
        }
      }
    }
    return space;
  }

  /// Measured less predicted angles [rad] of the motions of a split, joint by joint.
  Eigen::VectorXd residual(const std::vector<double>& x, Split split) {
    std::vector<Eigen::VectorXd> parts(shares_.size());
    inParallel(parts.size(), options_.jobs, [&](std::size_t s) {
      const std::vector<std::size_t> motions = motionsOf(shares_[s].joint, split);
      if (!motions.empty()) parts[s] = partOf(shares_[s], x, split, motions);
    });
    return joined(parts);
  }

  /// The motions of all joints in residual(), one after another.
  std::vector<SampleBlock> logs(Split split) const {
    std::vector<SampleBlock> logs;
    Eigen::Index at = 0;
    for (const JointShare& share : shares_) {
      for (const std::size_t m : motionsOf(share.joint, split)) {
        logs.push_back({at, simulator(share.joint).measured()[m].repeats.front().rows()});
        at += logs.back().size;
      }
    }
    return logs;
  }

  /// The deviations of all joints.
  std::vector<EffectSetting> settings(const std::vector<double>& x) const {
    std::vector<EffectSetting> all;
    for (const JointShare& share : shares_) {
      for (EffectSetting& setting : settingsOf(share.causes, share.at(x))) {
        setting.joints = {set_.set->joints()[share.joint]};
        all.push_back(std::move(setting));
      }
    }
    return all;
  }

  Eigen::VectorXd softened(const Eigen::VectorXd& residual) const {
    return shares_.front().fit->softened(residual);
  }
  Eigen::VectorXd weights(const Eigen::VectorXd& residual) const {
    return shares_.front().fit->weights(residual);
  }
  /// What the robot has of a number already, at the first joint that it concerns.
  double present(std::size_t number) const {
    for (const JointShare& share : shares_) {
      if (std::find(share.place.begin(), share.place.end(), number) == share.place.end()) continue;
      return simulator(share.joint).present(numbers_[number].effect, numbers_[number].parameter);
    }
    return 0;
  }

 private:
  const RigSimulator& simulator(std::size_t joint) const { return *set_.joints[joint].simulator; }

  void addNumber(const FreeParameter& free) {
    if (free.joint != kEachJoint) {
      numbers_.push_back(free);
      return;
    }
    for (const PreparedJoint& joint : set_.joints) {
      numbers_.push_back({free.effect, free.parameter, joint.simulator->joint()});
    }
  }

  void addJoint(std::size_t j) {
    JointShare share;
    share.joint = j;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const FreeParameter& free = numbers_[i];
      if (!free.joint.empty() && free.joint != simulator(j).joint()) continue;
      if (!share.causes.empty() && share.causes.back().effect == free.effect) {
        share.causes.back().free.push_back({free.parameter, {}, Form::Offset, "", 0, 0, 0, 0});
        share.model.back().x.push_back(0);
      } else {
        Cause cause;
        cause.id = cause.effect = free.effect;
        cause.free = {{free.parameter, {}, Form::Offset, "", 0, 0, 0, 0}};
        share.model.push_back({share.causes.size(), {0}});
        share.causes.push_back(std::move(cause));
      }
      share.place.push_back(i);
    }
    if (share.causes.empty()) return;
    for (Cause& cause : share.causes) {
      cause = boundedAt(cause, simulator(j), sim::standardEffects());
    }
    shares_.push_back(std::move(share));
    JointShare& kept = shares_.back();
    MotionFitOptions options;
    options.runs = isWithoutRepeats(simulator(j)) ? 1 : options_.runs;
    kept.fit =
        std::make_unique<MotionFit>(simulator(j), set_.joints[j].noise, kept.causes, options);
  }

  std::vector<std::size_t> motionsOf(std::size_t joint, Split split) const {
    std::vector<std::size_t> motions;
    for (std::size_t m = 0; m < simulator(joint).measured().size(); ++m) {
      if (simulator(joint).measured()[m].split == split) motions.push_back(m);
    }
    return motions;
  }

  // A joint's part changes with its own numbers alone; the last ones are remembered.
  static Eigen::VectorXd partOf(JointShare& share, const std::vector<double>& x, Split split,
                                const std::vector<std::size_t>& motions) {
    std::vector<double> key = numbersOf(share.at(x));
    key.push_back(static_cast<double>(split));
    const auto known = share.known.find(key);
    if (known != share.known.end()) return known->second;
    if (share.known.size() > kMostKnown) share.known.clear();
    return share.known[key] = share.fit->residual(share.at(x), motions);
  }

  static Eigen::VectorXd joined(const std::vector<Eigen::VectorXd>& parts) {
    Eigen::Index size = 0, at = 0;
    for (const Eigen::VectorXd& part : parts) size += part.size();
    Eigen::VectorXd all(size);
    for (const Eigen::VectorXd& part : parts) {
      all.segment(at, part.size()) = part;
      at += part.size();
    }
    return all;
  }

  static constexpr std::size_t kMostKnown = 40;
  const PreparedSet& set_;
  OptimiseOptions options_;
  std::vector<FreeParameter> numbers_;
  std::deque<JointShare> shares_;  // a MotionFit keeps its causes by reference
};

double meanError(const Eigen::VectorXd& residual) {
  return residual.size() == 0 ? 0 : residual.cwiseAbs().mean();
}

// From the robot as it is, and from where every effect is switched on as its catalogue has it.
FitPoint bestFit(SetFit& set, const FitSpace& space) {
  const auto residual = [&](const std::vector<double>& x) {
    return set.softened(set.residual(x, Split::Fit));
  };
  const FitPoint near = leastSquares(residual, space);
  FitSpace on = space;
  for (std::size_t i = 0; i < on.start.size(); ++i) {
    const sim::Parameter& p = parameterOf(set.numbers()[i]);
    on.start[i] = std::clamp(p.nominal - p.neutral, on.lower[i], on.upper[i]);
  }
  const FitPoint far = leastSquares(residual, on);
  return far.cost < near.cost ? far : near;
}

// Of the prediction, by the steps of the fit.
Eigen::MatrixXd jacobianOf(SetFit& set, const FitSpace& space, const std::vector<double>& x,
                           const Eigen::VectorXd& residual) {
  Eigen::MatrixXd jacobian(residual.size(), static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::vector<double> beside = x;
    beside[i] += differenceStep(space, i, x[i]);
    jacobian.col(static_cast<Eigen::Index>(i)) =
        (residual - set.residual(beside, Split::Fit)) / (beside[i] - x[i]);
  }
  return jacobian;
}

}  // namespace

const sim::Parameter& parameterOf(const FreeParameter& free) {
  return sim::parameterOf(sim::standardEffects(), free.effect, free.parameter);
}

std::string nameOf(const FreeParameter& free) {
  return free.effect + "." + free.parameter + (free.joint.empty() ? "" : "@" + free.joint);
}

std::vector<FreeParameter> parseFree(const std::string& list, const RobotModel& model, bool whole) {
  std::vector<FreeParameter> all;
  std::istringstream in(list);
  for (std::string one; std::getline(in, one, ',');) {
    if (!one.empty()) all.push_back(parseOne(one, model, whole));
  }
  if (all.empty()) throw InputError("--free: expected effect.parameter[@joint],...");
  // Numbers of one effect act together: side by side.
  std::stable_sort(all.begin(), all.end(), [](const FreeParameter& a, const FreeParameter& b) {
    return a.effect < b.effect;
  });
  return all;
}

Optimised optimise(const PreparedSet& prepared, const std::vector<FreeParameter>& free,
                   const OptimiseOptions& options) {
  SetFit set(prepared, free, options);
  const std::vector<SampleBlock> logs = set.logs(Split::Fit);
  if (logs.empty()) throw InputError("expected fit motions of a joint with free numbers");
  const FitSpace space = set.space();
  Optimised found;
  found.before = meanError(set.residual(space.start, Split::Fit));
  found.select_before = meanError(set.residual(space.start, Split::Select));
  const FitPoint best = bestFit(set, space);
  const Eigen::VectorXd residual = set.residual(best.x, Split::Fit);
  found.after = meanError(residual);
  found.select_after = meanError(set.residual(best.x, Split::Select));
  found.settings = set.settings(best.x);
  found.intervals = std::string("the fit's ") + (logs.size() >= kManyLogs ? "logs" : "seconds") +
                    " drawn again with replacement";
  const auto blocks = blocksOf(logs, kManyLogs, kBlockRows);
  const Eigen::MatrixXd moves = bootstrapMoves(jacobianOf(set, space, best.x, residual), residual,
                                               set.weights(residual), blocks, options.sets, kSeed);
  for (std::size_t i = 0; i < best.x.size(); ++i) {
    const sim::Parameter& p = parameterOf(set.numbers()[i]);
    const Eigen::VectorXd move = moves.col(static_cast<Eigen::Index>(i));
    const double x = best.x[i], margin = 1e-6 * (space.upper[i] - space.lower[i]);
    OptimisedNumber number{set.numbers()[i],
                           {p.name, p.unit, p.neutral + set.present(i) + x, x,
                            x + quantileOf(move, 0.05), x + quantileOf(move, 0.95)},
                           x < space.lower[i] + margin || x > space.upper[i] - margin};
    found.numbers.push_back(std::move(number));
  }
  return found;
}

Report reportOptimised(const Optimised& found, const std::string& robot) {
  Report report;
  report.command = "optimise";
  report.robot = robot;
  report.figures = {{"before_mae", found.before},
                    {"after_mae", found.after},
                    {"select_before_mae", found.select_before},
                    {"select_after_mae", found.select_after}};
  TextTable table{"Fitted numbers", {"number", "value", "90 % interval", "change"}, {}};
  std::vector<Row> rows;
  for (const OptimisedNumber& number : found.numbers) {
    const FoundNumber& n = number.found;
    const auto [low, high] = valueInterval(n);
    rows.push_back({{"number", nameOf(number.what)},
                    {"unit", n.unit},
                    {"value", n.value},
                    {"low", low},
                    {"high", high},
                    {"deviation", n.deviation}});
    table.lines.push_back({nameOf(number.what),
                           valueText(n) + (number.at_bound ? " (at its bound)" : ""),
                           intervalText(n), fixed(n.deviation, 5)});
  }
  report.figures.push_back({"rows", std::move(rows)});
  report.tables.push_back(std::move(table));
  report.remarks.push_back("Mean absolute error of the fit motions " +
                           fixed(1e3 * found.before, 2) + " -> " + fixed(1e3 * found.after, 2) +
                           " mrad, of the select motions " + fixed(1e3 * found.select_before, 2) +
                           " -> " + fixed(1e3 * found.select_after, 2) +
                           "; test motions were not opened.");
  report.remarks.push_back("Intervals: " + found.intervals + ".");
  return report;
}

}  // namespace nao::validation
