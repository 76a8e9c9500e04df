#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/input.h"
#include "runtime/simulation.h"

// A recorded run is one SQLite file (docs/recording.md), of these tables:
//   run     name TEXT, value              what everything began with, as named values
//   robot   number, name TEXT, model TEXT, setup BLOB
//   input   number, elapsed_ns, time_ns, place, robot, kind TEXT, content BLOB
//   state   number, elapsed_ns, time_ns, inputs, hash
// `elapsed` is the simulated time that has passed since the start; it is `time` until the world is
// set back to a snapshot. Inputs of one moment, robot and kind share a row. A state was reached
// after the first so many inputs. BLOBs are archives (core/members.h) with a sum behind
// (recording_format.h).

namespace nao::runtime {

/// What a run begins with.
struct RunStart {
  std::shared_ptr<const WorldModel> world;
  std::vector<sim::RobotSetup> robots;
  Duration step = std::chrono::milliseconds(2);
  sim::Mode mode = sim::Mode::Implicit;
  std::uint64_t seed = 0;
  bool any_step = false;

  Simulation makeSimulation() const;
};

/// A recorded run, read.
struct Recording {
  struct TimedInput {
    Duration elapsed{};
    Input input;
  };
  struct State {
    Duration elapsed{};
    SimTime time{};
    std::size_t inputs = 0;  // so many were taken over before
    std::uint64_t hash = 0;
  };
  std::string file;
  RunStart start;
  std::vector<TimedInput> inputs;
  std::vector<State> states;  // every 100 ms, and the last
  bool ended = false;         // false: whoever recorded was killed, or is still at it

  /// The simulated time that has passed at the last state.
  Duration length() const { return states.empty() ? Duration::zero() : states.back().elapsed; }
};

/// @throws InputError naming the file: none there, no recording, broken, or of another version.
Recording readRecording(const std::string& file);

/// Whether a file is there and begins as SQLite's do, as a recording does.
bool looksRecorded(const std::string& file);

}  // namespace nao::runtime
