#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/frames.h"

namespace nao::validation {

/// What a run may be used for; fixed in the set's file, so that nobody tunes on test.
enum class Split { Fit, Select, Test };

/// A column of a run: one signal of one joint or place, "cmd.LKneePitch" [rad], "q.LKneePitch"
/// [rad], "cur.LKneePitch" [A] ... NaN: not sampled at this time.
using Column = std::vector<double>;

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A known weight that was fixed to a link for a run.
struct LogLoad {
  std::string link;
  double mass = 0;                // [kg]
  Vec3 p_BoBcm_B = Vec3::Zero();  // [m] in the link
};

/// One run of a set: the rows of its CSV file.
struct LogRun {
  std::string file;    // within the set's folder
  std::string motion;  // runs of one motion are repeats of each other
  int repeat = 0;
  std::string robot_id;
  Split split = Split::Fit;
  std::string start_pose;
  std::string notes;
  std::optional<LogLoad> load;
  double kp_scale = 1;  // P gain of the servos in this run, over that of the nominal model

  std::vector<double> t;  // [s]
  std::map<std::string, Column> columns;

  const Column* find(const std::string& name) const;
};

/// What a set's meta.json says of one joint; NaN: unknown.
struct LogJoint {
  std::string name;
  double sign = 1;                    // of the axis
  double zero = 0;                    // [rad]
  double encoder_quantum = kUnknown;  // [rad]
  double stiffness = 1;
  double gear = kUnknown;  // turns of the motor for one of the joint
  double kp = kUnknown;    // [N m/rad]
  double kd = kUnknown;    // [N m s/rad]
};

/// What the times and values of a set's rows mean.
struct LogClock {
  std::string type;           // simulated, robot, host
  std::string command_stamp;  // issued, sent or executed at t
  std::string sensor_stamp;   // measured or received at t
};

struct LogEnvironment {
  std::string floor;
  double tilt = kUnknown;         // [rad] of the floor
  double temperature = kUnknown;  // [deg C]
  bool suspended = false;         // torso held, feet in the air
};

/// A set of runs in the format "RobotLog 1": a folder with meta.json and one CSV file per run.
/// SI units and radians; docs/robot_log.md lists every column.
struct LogSet {
  std::string name;
  std::string source;  // URL and commit, or how it was recorded
  std::string licence;
  std::string robot;    // of robots/: the nominal model
  std::string version;  // of the robot
  std::string serial;
  double body_mass = kUnknown;  // [kg] weighed
  std::string model_sha256;     // of the robot's model file, if known
  LogClock clock;
  LogEnvironment environment;
  double rate = 0;  // [Hz] nominal, of the rows
  std::vector<LogJoint> joints;
  std::vector<LogRun> runs;
};

/// "fit", "select" or "test".
const char* nameOf(Split split);

/// @throws InputError if the set has no run of any of these splits.
void requireRuns(const LogSet& set, const std::vector<Split>& splits);

/// Reads FOLDER/meta.json and the runs it lists (.csv, or .csv.gz).
/// @throws InputError with file, row, column and what was expected.
LogSet readLogSet(const std::string& folder);

/// Creates the folder. What is read back is the same to the last bit.
/// @throws InputError if a file can not be written.
void writeLogSet(const LogSet& set, const std::string& folder);

}  // namespace nao::validation
