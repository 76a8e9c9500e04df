#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nao::validation {

/// What a run may be used for; fixed in the set's file, so that nobody tunes on test.
enum class Split { Fit, Select, Test };

/// A column of a run: one signal of one joint or place, "cmd.LKneePitch" [rad], "q.LKneePitch"
/// [rad], "cur.LKneePitch" [A] ... NaN: not sampled at this time.
using Column = std::vector<double>;

/// One run of a set: the rows of its CSV file.
struct LogRun {
  std::string file;    // within the set's folder
  std::string motion;  // runs of one motion are repeats of each other
  int repeat = 0;
  std::string robot_id;
  Split split = Split::Fit;
  std::string start_pose;
  std::string notes;

  std::vector<double> t;  // [s]
  std::map<std::string, Column> columns;

  const Column* find(const std::string& name) const;
};

/// What a set's meta.json says of one joint; NaN: unknown.
struct LogJoint {
  std::string name;
  double sign = 1;                                                    // of the axis
  double zero = 0;                                                    // [rad]
  double encoder_quantum = std::numeric_limits<double>::quiet_NaN();  // [rad]
  double stiffness = 1;
};

/// A set of runs in the format "RobotLog 1": a folder with meta.json and one CSV file per run.
/// SI units and radians; docs/robot_log.md lists every column.
struct LogSet {
  std::string name;
  std::string source;  // URL and commit, or how it was recorded
  std::string licence;
  std::string robot;    // of robots/: the nominal model
  std::string version;  // of the robot
  bool suspended = false;
  double rate = 0;  // [Hz] nominal, of the rows
  std::vector<LogJoint> joints;
  std::vector<LogRun> runs;
};

/// @throws InputError with file, row, column and what was expected.
LogSet readLogSet(const std::string& folder);
void writeLogSet(const LogSet& set, const std::string& folder);

}  // namespace nao::validation
