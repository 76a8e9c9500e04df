// Faults of whose signal is whose: joints swapped, negated, in degrees, or late.
#include <algorithm>
#include <cmath>

#include "validation/log/fault_checks.h"
#include "validation/log/series.h"

namespace nao::validation {
namespace {

constexpr double kFollows = 0.8;    // correlation of a sensor that does what its command says
constexpr double kSurely = 0.9;     // of one that follows this command and no other
constexpr double kUnrelated = 0.5;  // below: it follows nothing
constexpr double kMoved = 0.02;     // [rad] standard deviation of a command that tells anything
constexpr double kServoLag = 0.2;   // [s] the most that correlation is looked for at
constexpr double kLagWindow = 0.5;  // [s] either way
constexpr double kLatest = 0.3;     // [s] no servo and bus is later
constexpr double kBetweenJoints = 0.15;  // [s] between one joint and the usual one
constexpr double kBetweenRuns = 0.03;    // [s] likewise for runs of one set

double calcDeviation(const std::vector<double>& values) {
  if (values.empty()) return 0;
  double sum = 0, squares = 0;
  for (const double x : values) sum += x - values.front();
  const double mean = values.front() + sum / static_cast<double>(values.size());
  for (const double x : values) squares += (x - mean) * (x - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

double calcLargest(const Column& values) {
  double largest = 0;
  for (const double x : values) {
    if (!std::isnan(x)) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

// [rad] what no reading of this joint exceeds.
double calcBound(const std::string& name, const RobotModel* model) {
  constexpr double kAnyJoint = 7;  // a bit over one turn
  if (model == nullptr) return kAnyJoint;
  const auto joint = model->findJoint(name);
  if (!joint) return kAnyJoint;
  const Actuator& actuator = model->actuators[index(*joint)];
  return 0.5 + 4 * std::max(std::abs(actuator.lower), std::abs(actuator.upper));
}

// How well sensor b follows command a over all runs, at the lag that suits it best.
double calcFollowing(const SetSeries& series, std::size_t a, std::size_t b, double dt) {
  double best = 0;
  const int steps = static_cast<int>(kServoLag / dt);
  for (int lag = 0; lag <= steps; lag += std::max(1, steps / 10)) {
    Correlation correlation;
    for (const auto& run : series) {
      if (run[a].command.empty() || run[b].sensor.empty()) continue;
      correlation.add(run[a].command, run[b].sensor, lag, run[b].stiff);
    }
    if (std::abs(correlation.value()) > std::abs(best)) best = correlation.value();
  }
  return best;
}

bool isTold(const SetSeries& series, std::size_t joint) {
  return std::any_of(series.begin(), series.end(),
                     [&](const auto& run) { return calcDeviation(run[joint].command) > kMoved; });
}
bool moves(const SetSeries& series, std::size_t joint) {
  return std::any_of(series.begin(), series.end(),
                     [&](const auto& run) { return calcDeviation(run[joint].sensor) > 0; });
}

struct Leader {
  std::size_t joint = 0;
  double following = 0;
};
Leader findLeader(const SetSeries& series, std::size_t sensor, double dt) {
  Leader leader;
  for (std::size_t a = 0; a < series.front().size(); ++a) {
    if (a == sensor || !isTold(series, a)) continue;
    const double following = calcFollowing(series, a, sensor, dt);
    if (std::abs(following) > std::abs(leader.following)) leader = {a, following};
  }
  return leader;
}

// Two joints that follow each other's commands are told once, with the first of them.
bool isToldAlready(const SetSeries& series, std::size_t j, std::size_t leader, double dt) {
  return leader < j && findLeader(series, leader, dt).joint == j;
}

void checkOneJoint(const LogSet& set, const SetSeries& series, std::size_t j, double dt,
                   FaultLog& log) {
  const double own = calcFollowing(series, j, j, dt);
  if (own > kFollows) return;
  const Leader leader = findLeader(series, j, dt);
  const std::string& name = set.joints[j].name;
  const std::string by = " (correlation " + fixed(own, 2) + ")";
  if (own < -kFollows && std::abs(own) > std::abs(leader.following) - 0.1) {
    log.add({DataFaultKind::Negated,
             false,
             "",
             name,
             "q",
             {},
             "the sensor moves against its command" + by});
  } else if (leader.following > kSurely && leader.following > std::abs(own) + 0.1) {
    if (isToldAlready(series, j, leader.joint, dt)) return;
    log.add({DataFaultKind::Swapped,
             false,
             "",
             name,
             "q",
             {},
             "the sensor follows cmd." + set.joints[leader.joint].name + " (correlation " +
                 fixed(leader.following, 2) + "), not its own command" + by});
  } else if (std::max(std::abs(own), std::abs(leader.following)) < kUnrelated) {
    log.add({DataFaultKind::Unrelated,
             false,
             "",
             name,
             "q",
             {},
             "the sensor follows neither its command nor another's" + by});
  }
}

// How much later than the command the sensors are, over some runs and joints: where the rates of
// both are most alike. Of peaks alike (periodic motions) the one nearest to no lag counts.
struct Lag {
  double seconds = 0;
  double correlation = 0;
  std::vector<double> curve;  // correlation at all lags looked at, from -kLagWindow on

  // The most alike they are at any lag in this range [s].
  double within(double from, double to, double dt) const {
    double most = -1;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const double lag = dt * (static_cast<double>(i) - static_cast<double>(curve.size() / 2));
      if (lag > from - dt / 2 && lag < to + dt / 2) most = std::max(most, curve[i]);
    }
    return most;
  }
};
using Pick = std::vector<std::pair<std::size_t, std::size_t>>;  // run, joint

Lag findLag(const SetSeries& series, const Pick& pick, double dt) {
  const int reach = static_cast<int>(kLagWindow / dt);
  std::vector<Correlation> at(static_cast<std::size_t>(2 * reach + 1));
  for (const auto& [r, j] : pick) {
    const JointSeries& joint = series[r][j];
    if (joint.command.empty() || joint.sensor.empty()) continue;
    const std::vector<double> a = differences(joint.command), b = differences(joint.sensor);
    for (int lag = -reach; lag <= reach; ++lag) {
      at[static_cast<std::size_t>(lag + reach)].add(a, b, lag, joint.stiff);
    }
  }
  Lag best{1e300, 0, {}};
  for (const Correlation& c : at) best.curve.push_back(c.value());
  const double most = *std::max_element(best.curve.begin(), best.curve.end());
  best.correlation = most;
  for (int lag = -reach; lag <= reach; ++lag) {
    const std::size_t i = static_cast<std::size_t>(lag + reach);
    const bool peak = at[i].value() >= 0.99 * most && at[i].value() >= at[i - (i > 0)].value() &&
                      at[i].value() >= at[i + (i + 1 < at.size())].value();
    if (peak && std::abs(lag * dt) < std::abs(best.seconds)) best.seconds = lag * dt;
  }
  return best;
}

constexpr double kClear = 0.8;  // correlation of rates from which a lag is one; soft servos swing

double calcMedian(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct NamedLag {
  std::string name;   // of a joint or a run's file
  std::string group;  // lags of one group should be alike
  Lag lag;
};

// Of a group's lags the one nearest to what is usual in the set.
double findGroupLag(const std::vector<NamedLag>& lags, const std::string& group, double usual) {
  double nearest = 1e300;
  for (const NamedLag& one : lags) {
    const double seconds = one.lag.seconds;
    if (one.group == group && std::abs(seconds - usual) < std::abs(nearest - usual)) {
      nearest = seconds;
    }
  }
  return nearest;
}

enum class LagOf { Runs, Joints };

// Only what fits clearly worse without a fault: slow motions tell no lag. One run alone is held
// against its repeats, not against causality: a weak joint that is stopped on its way seems early.
std::string judgeLag(const Lag& lag, double elsewhere, double apart, LagOf of, double dt) {
  constexpr double kClearly = 0.03;  // of correlation
  const double seconds = lag.seconds;
  const std::string late = fixed(1000 * seconds, 0) + " ms";
  if (lag.correlation - lag.within(0, kLatest, dt) < kClearly &&
      lag.correlation - lag.within(elsewhere - dt, elsewhere + dt, dt) < kClearly) {
    return {};
  }
  if (of == LagOf::Joints && seconds < -1.5 * dt) {
    return "the sensors move " + fixed(-1000 * seconds, 0) + " ms before their commands";
  }
  if (of == LagOf::Joints && seconds > kLatest) {
    return "the sensors move " + late + " after their commands, later than servos do";
  }
  if (std::abs(seconds - elsewhere) > std::max(apart, 2.5 * dt)) {
    return "the sensors move " + late + " after their commands, elsewhere " +
           fixed(1000 * elsewhere, 0) + " ms";
  }
  return {};
}

void checkLags(const std::vector<NamedLag>& lags, double dt, double apart, LagOf of,
               FaultLog& log) {
  std::vector<double> all;
  for (const NamedLag& one : lags) all.push_back(one.lag.seconds);
  if (all.empty()) return;
  const double usual = calcMedian(all);
  for (const NamedLag& one : lags) {
    const double elsewhere = findGroupLag(lags, one.group, usual);
    const std::string text = judgeLag(one.lag, elsewhere, apart, of, dt);
    if (text.empty()) continue;
    const bool run = of == LagOf::Runs;
    log.add({DataFaultKind::Offset,
             false,
             run ? one.name : "",
             run ? "" : one.name,
             run ? "" : "q",
             {},
             text});
  }
}

}  // namespace

void checkUnits(const LogSet& set, const RobotModel* model, FaultLog& log) {
  constexpr double kDegree = 57.295779513082323;
  for (const LogRun& run : set.runs) {
    for (const LogJoint& joint : set.joints) {
      const double bound = calcBound(joint.name, model);
      double largest[2] = {0, 0};
      const char* signals[2] = {"cmd", "q"};
      for (int s = 0; s < 2; ++s) {
        const Column* values = run.find(std::string(signals[s]) + "." + joint.name);
        if (values != nullptr) largest[s] = calcLargest(*values);
      }
      for (int s = 0; s < 2; ++s) {
        const double ratio = largest[s] / std::max(largest[1 - s], 1e-9);
        const bool scaled = largest[1 - s] > 0.1 && ratio > kDegree / 1.4 && ratio < kDegree * 1.4;
        if (largest[s] < bound && !scaled) continue;
        log.add({DataFaultKind::Units,
                 false,
                 run.file,
                 joint.name,
                 signals[s],
                 {},
                 "reaches " + fixed(largest[s], 1) + ", which are degrees, not radians"});
      }
    }
  }
}

void checkJointMap(const LogSet& set, const SetSeries& series, double dt, FaultLog& log) {
  for (std::size_t j = 0; j < set.joints.size(); ++j) {
    if (isTold(series, j) && moves(series, j)) checkOneJoint(set, series, j, dt, log);
  }
}

void checkOffsets(const LogSet& set, const SetSeries& series, double dt, FaultLog& log) {
  std::vector<NamedLag> by_run, by_joint;
  const auto judge = [&](const Pick& pick, NamedLag named, std::vector<NamedLag>& list) {
    named.lag = findLag(series, pick, dt);
    if (named.lag.correlation > kClear) list.push_back(std::move(named));
  };
  for (std::size_t r = 0; r < set.runs.size(); ++r) {
    Pick pick;
    for (std::size_t j = 0; j < set.joints.size(); ++j) pick.emplace_back(r, j);
    judge(pick, {set.runs[r].file, set.runs[r].motion, {}}, by_run);
  }
  for (std::size_t j = 0; j < set.joints.size(); ++j) {
    Pick pick;
    for (std::size_t r = 0; r < set.runs.size(); ++r) pick.emplace_back(r, j);
    judge(pick, {set.joints[j].name, "", {}}, by_joint);
  }
  FaultLog of_runs;
  checkLags(by_run, dt, kBetweenRuns, LagOf::Runs, of_runs);
  log.append(of_runs);
  if (of_runs.empty()) checkLags(by_joint, dt, kBetweenJoints, LagOf::Joints, log);
}

}  // namespace nao::validation
