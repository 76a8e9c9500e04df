#include "validation/log/error_map.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/check.h"

namespace nao::validation {
namespace {

constexpr double kMostLag = 0.4;    // [s] servos and links are faster
constexpr double kLagStep = 0.005;  // [s]
constexpr double kRest = 0.15;      // [s] after which a joint has followed as far as it does
constexpr double kMoves = 0.05;     // [rad] a command that covers less says nothing of lags
constexpr double kSure = 3;         // standard errors: with 25 joints less is chance
constexpr double kMatters = 0.01;   // [rad] of a difference between sides: free choice, 0.6 degrees
constexpr double kDegrees = 180 / M_PI;

struct Samples {
  std::vector<double> t, command, angle;
  std::vector<bool> rests;  // the command has not changed for kRest
};

std::optional<Samples> samplesOf(const LogRun& run, const LogJoint& joint) {
  const Column* command = run.find("cmd." + joint.name);
  const Column* angle = run.find("q." + joint.name);
  if (command == nullptr || angle == nullptr) return std::nullopt;
  Samples samples;
  double held = kUnknown, changed = -1e9;
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    if (!std::isnan((*command)[i]) && (*command)[i] != held) {
      if (!std::isnan(held)) changed = run.t[i];
      held = (*command)[i];
    }
    if (std::isnan(held) || std::isnan((*angle)[i])) continue;
    samples.t.push_back(run.t[i]);
    samples.command.push_back(held);
    samples.angle.push_back((*angle)[i]);
    samples.rests.push_back(run.t[i] - changed > kRest);
  }
  if (samples.t.size() < 2) return std::nullopt;
  return samples;
}

// The command that was valid `lag` before each angle.
std::vector<double> shifted(const Samples& samples, double lag) {
  std::vector<double> command;
  std::size_t i = 0;
  for (const double t : samples.t) {
    while (i + 1 < samples.t.size() && samples.t[i + 1] <= t - lag) ++i;
    command.push_back(samples.command[i]);
  }
  return command;
}

struct Line {
  double slope = 1, rms = 0;
};

// Angles as a straight line over commands, all runs together.
Line lineOf(const std::vector<Samples>& runs, double lag) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (const Samples& samples : runs) {
    const std::vector<double> x = shifted(samples, lag);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double y = samples.angle[i];
      n += 1, sx += x[i], sy += y, sxx += x[i] * x[i], sxy += x[i] * y, syy += y * y;
    }
  }
  const double xx = sxx - sx * sx / n, xy = sxy - sx * sy / n, yy = syy - sy * sy / n;
  if (xx <= 0) return {1, std::sqrt(std::max(0.0, yy / n))};
  return {xy / xx, std::sqrt(std::max(0.0, (yy - xy * xy / xx) / n))};
}

void findLag(const std::vector<Samples>& runs, JointError& error) {
  double least = lineOf(runs, 0).rms;
  std::vector<double> lengths;
  for (const Samples& samples : runs) lengths.push_back(samples.t.back() - samples.t.front());
  std::nth_element(lengths.begin(),
                   lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2),
                   lengths.end());
  const double most = std::min(kMostLag, lengths[lengths.size() / 2] / 4);
  for (double lag = 0; lag <= most; lag += kLagStep) {
    const Line line = lineOf(runs, lag);
    if (line.rms > least) continue;
    least = line.rms;
    error.lag = lag;
    error.following = line.slope;
  }
  if (error.lag > 0.75 * most) error.lag = kUnknown;  // no longest lag is the best
}

JointError errorOf(const std::string& joint, const std::vector<Samples>& runs) {
  JointError error;
  error.joint = joint;
  double low = 1e9, high = -1e9, sum = 0, squares = 0, n = 0;
  for (const Samples& samples : runs) {
    double run_sum = 0, run_squares = 0, rest_sum = 0;
    int rests = 0;
    for (std::size_t i = 0; i < samples.t.size(); ++i) {
      const double off = samples.command[i] - samples.angle[i];
      run_sum += off;
      run_squares += off * off;
      if (samples.rests[i]) rest_sum += off, ++rests;
      low = std::min(low, samples.command[i]);
      high = std::max(high, samples.command[i]);
    }
    const auto count = static_cast<double>(samples.t.size());
    error.rest_biases.push_back(rests > 0 ? rest_sum / rests : run_sum / count);
    error.rmses.push_back(std::sqrt(run_squares / count));
    sum += run_sum, squares += run_squares, n += count;
  }
  error.bias = sum / n;
  error.rest = calcStatistics(error.rest_biases).mean;
  error.rms = std::sqrt(squares / n);
  error.moved = high - low;
  if (error.moved > kMoves) findLag(runs, error);
  return error;
}

// "l_knee_y" -> "r_knee_y"; empty for a name that is of no left side.
std::string otherSide(const std::string& left) {
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"left", "right"},
                                 {"Left", "Right"},
                                 {"l_", "r_"},
                                 {"L", "R"}}) {
    if (left.rfind(from, 0) == 0) return to + left.substr(from.size());
  }
  return "";
}

struct Mean {
  double value = 0, error = 0;
};

Mean meanOf(const std::vector<double>& values) {
  if (values.empty()) return {};
  const Statistics all = calcStatistics(values);
  return {all.mean, all.sd / std::sqrt(static_cast<double>(all.n))};
}

SideDifference compare(const JointError& left, const JointError& right) {
  SideDifference found{left.joint, right.joint, 0, 0, 0, 0, false};
  const std::size_t n = std::min(left.rmses.size(), right.rmses.size());
  std::vector<double> rms, straight, mirrored;
  for (std::size_t i = 0; i < n; ++i) {
    rms.push_back(left.rmses[i] - right.rmses[i]);
    straight.push_back(left.rest_biases[i] - right.rest_biases[i]);
    mirrored.push_back(left.rest_biases[i] + right.rest_biases[i]);
  }
  const Mean of_rms = meanOf(rms), same = meanOf(straight), other = meanOf(mirrored);
  const Mean& bias = std::abs(same.value) <= std::abs(other.value) ? same : other;
  found.rms = of_rms.value, found.rms_error = of_rms.error;
  found.bias = bias.value, found.bias_error = bias.error;
  const auto sure = [n](const Mean& mean) {
    return n > 2 && std::abs(mean.value) > std::max(kMatters, kSure * mean.error);
  };
  found.differs = sure(of_rms) || sure(bias);
  return found;
}

TextTable jointTable(const std::vector<JointError>& joints) {
  TextTable table{"Command against sensor, all runs",
                  {"joint", "error RMS [deg]", "mean [deg]", "at rest [deg]", "lag [ms]",
                   "following", "moved [deg]"},
                  {}};
  for (const JointError& joint : joints) {
    const bool moves = joint.moved > kMoves;
    table.lines.push_back({joint.joint, fixed(joint.rms * kDegrees, 2),
                           fixed(joint.bias * kDegrees, 2), fixed(joint.rest * kDegrees, 2),
                           moves && !std::isnan(joint.lag) ? fixed(1e3 * joint.lag, 0) : "-",
                           moves ? fixed(joint.following, 2) : "-",
                           fixed(joint.moved * kDegrees, 1)});
  }
  return table;
}

TextTable sideTable(const std::vector<SideDifference>& sides) {
  TextTable table{
      "Left less right, and its standard error from run to run",
      {"joints", "error RMS [deg]", "+-", "at rest, mirrored if nearer [deg]", "+-", ""},
      {}};
  for (const SideDifference& side : sides) {
    table.lines.push_back({side.left + ", " + side.right, fixed(side.rms * kDegrees, 2),
                           fixed(side.rms_error * kDegrees, 2), fixed(side.bias * kDegrees, 2),
                           fixed(side.bias_error * kDegrees, 2), side.differs ? "differs" : ""});
  }
  return table;
}

std::string inWords(const SideDifference& side) {
  const bool rests = std::abs(side.bias) > std::abs(side.rms);
  return side.left + "/" + side.right + " (" + (rests ? "at rest " : "RMS ") +
         fixed((rests ? side.bias : side.rms) * kDegrees, 2) + " +- " +
         fixed((rests ? side.bias_error : side.rms_error) * kDegrees, 2) + " deg)";
}

// Those that differ for sure, and else those that differ most.
std::string sidesInWords(std::vector<SideDifference> sides) {
  const auto size = [](const SideDifference& side) {
    return std::max(std::abs(side.rms), std::abs(side.bias));
  };
  std::stable_sort(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
    return a.differs != b.differs ? a.differs : size(a) > size(b);
  });
  const bool sure = sides.front().differs;
  std::string all =
      sure ? "Left and right differ: " : "Left and right differ most, but no more than runs do: ";
  constexpr std::size_t kFew = 3;
  for (std::size_t i = 0; i < sides.size() && (sure ? sides[i].differs : i < kFew); ++i) {
    all += (i > 0 ? ", " : "") + inWords(sides[i]);
  }
  return all + ".";
}

}  // namespace

std::vector<JointError> errorMapOf(const LogSet& set) {
  std::vector<JointError> all;
  for (const LogJoint& joint : set.joints) {
    std::vector<Samples> runs;
    for (const LogRun& run : set.runs) {
      if (auto samples = samplesOf(run, joint)) runs.push_back(std::move(*samples));
    }
    if (!runs.empty()) all.push_back(errorOf(joint.name, runs));
  }
  return all;
}

std::vector<SideDifference> sideDifferences(const std::vector<JointError>& joints) {
  std::vector<SideDifference> sides;
  for (const JointError& left : joints) {
    const std::string name = otherSide(left.joint);
    const auto right = std::find_if(joints.begin(), joints.end(),
                                    [&](const JointError& one) { return one.joint == name; });
    if (!name.empty() && right != joints.end()) sides.push_back(compare(left, *right));
  }
  return sides;
}

Report reportErrorMap(const LogSet& set) {
  const std::vector<JointError> joints = errorMapOf(set);
  if (joints.empty()) throw InputError(set.name + ": expected a joint with command and angle");
  const std::vector<SideDifference> sides = sideDifferences(joints);
  Report report;
  report.command = "replay";
  report.robot = set.robot;
  report.runs = static_cast<int>(set.runs.size());
  std::vector<Row> rows, side_rows;
  for (const JointError& joint : joints) {
    rows.push_back({{"joint", joint.joint},
                    {"rms_rad", joint.rms},
                    {"bias_rad", joint.bias},
                    {"rest_rad", joint.rest},
                    {"lag_s", joint.lag},
                    {"following", joint.following},
                    {"moved_rad", joint.moved}});
  }
  for (const SideDifference& side : sides) {
    side_rows.push_back({{"left", side.left},
                         {"right", side.right},
                         {"rms_rad", side.rms},
                         {"rms_error_rad", side.rms_error},
                         {"bias_rad", side.bias},
                         {"bias_error_rad", side.bias_error},
                         {"differs", side.differs ? 1.0 : 0.0}});
  }
  report.figures = {{"rows", rows}, {"sides", side_rows}};
  report.tables.push_back(jointTable(joints));
  if (!sides.empty()) report.tables.push_back(sideTable(sides));
  if (!sides.empty()) report.remarks.push_back(sidesInWords(sides));
  return report;
}

}  // namespace nao::validation
