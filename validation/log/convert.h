#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// Recordings of others that can become a set.
enum class LogFormat {
  Bam,       // JSON files of Rhoban's test bench for servos: one pendulum, a file per run
  Poppy,     // one CSV file: position.<joint> and target.<joint> in degrees
  Almemory,  // one CSV file of NAOqi's ALMemory keys, the time [s] first
  Lola,      // the frames of a NAO V6's socket, one MessagePack map after the other
};

/// By their contents. @throws InputError if it is none of them, or nothing is there.
LogFormat guessFormat(const std::string& from);

/// What the files themselves do not tell.
struct ConvertSettings {
  std::string robot;           // the nominal model; empty: the format's own choice
  std::string licence;         // of the data
  std::optional<Split> split;  // of all runs; else the format's rule
  std::string motion;          // all runs are repeats of it; empty: each is the format's
  bool suspended = false;      // the robot hung by its torso, feet in the air
};

/// Reads a file or a folder of such files. What has no column in RobotLog 1 is left out.
///   Bam       the robot xl330_pendulum, runs in order of their files' names. kp_scale is the P
///   gain
///             over 100. Gains lie in one split each: the lowest and highest fit, those between
///             select, so that the choice is made on a gain no estimate has seen and that lies
///             where unseen gains do; a single gain is for test
///   Poppy     a run per segment; the last is for test, the one before for select
///   Almemory  a run per file, named after it; the last is for test, the one before for select. A
///   robot with wrists is taken for a nao_h25_v50, else for a nao_h21_v33
///   Lola      the same, a row per sensor frame, 12 ms apart; an actuator frame is the command of
///   the sensor frame before it. The robot nao_h25_v60
/// @throws InputError with file, place and what was expected.
LogSet convertLog(const std::string& from, LogFormat format, const ConvertSettings& settings);

/// Leaves out what a set has of joints that its robot's model does not have, and returns their
/// names: of a robot with other arms, say.
std::vector<std::string> leaveOutUnknownJoints(LogSet& set, const RobotModel& model);

}  // namespace nao::validation
