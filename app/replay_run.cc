#include "app/replay_run.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>

#include "core/check.h"
#include "validation/recorded/run_difference.h"
#include "validation/recorded/run_log.h"
#include "validation/recorded/start_change.h"

namespace nao::app {
namespace {

using runtime::Recording;
using runtime::Replayer;

void printHead(const Recording& recording) {
  std::string robots;
  for (const sim::RobotSetup& robot : recording.start.robots) {
    robots += (robots.empty() ? "" : ", ") + robot.name + " (" + robot.model->name + ")";
  }
  std::printf("%s: %.3f s, %s in %s, seed %" PRIu64 ", %zu inputs%s\n", recording.file.c_str(),
              toSeconds(recording.length()), robots.c_str(), recording.start.world->name.c_str(),
              recording.start.seed, recording.inputs.size(),
              recording.ended ? "" : "; it was cut short");
}

std::size_t findRobot(const Recording& recording, const std::string& name) {
  if (name.empty()) return 0;
  std::string names;
  for (std::size_t i = 0; i < recording.start.robots.size(); ++i) {
    if (recording.start.robots[i].name == name) return i;
    names += (names.empty() ? "" : ", ") + recording.start.robots[i].name;
  }
  throw InputError("--signals-of: expected one of " + names + ", found '" + name + "'");
}

// One line for equal ones of one moment.
void listInputs(const Recording& recording, validation::Stretch stretch) {
  const auto& inputs = recording.inputs;
  for (std::size_t i = 0, next = 0; i < inputs.size(); i = next) {
    const auto& [elapsed, input] = inputs[i];
    const std::string name = nameOf(input.content);
    for (next = i + 1; next < inputs.size() && inputs[next].elapsed == elapsed; ++next) {
      if (inputs[next].input.robot != input.robot) break;
      if (nameOf(inputs[next].input.content) != name) break;
    }
    if (elapsed < stretch.from || elapsed > stretch.to) continue;
    const bool is_worlds = std::holds_alternative<runtime::WorldRequest>(input.content);
    const std::string who = is_worlds ? "world" : recording.start.robots[input.robot].name;
    const std::string times = next - i > 1 ? " x" + std::to_string(next - i) : "";
    std::printf("%9.3f s  %s  %s%s\n", toSeconds(elapsed), who.c_str(), name.c_str(),
                times.c_str());
  }
}

void writeSignals(const ReplayRunOptions& options, const validation::RunLog& log) {
  const validation::LogSet set = log.set("replayed from " + options.file);
  if (set.runs[0].t.empty()) {
    throw InputError("--from, --to: the run has no cycle between them");
  }
  if (!options.csv.empty()) validation::writeRows(log.run(), options.csv);
  if (!options.set_out.empty()) validation::writeLogSet(set, options.set_out);
}

void checkStretch(const ReplayRunOptions& options, const Recording& recording) {
  if (options.from > options.to) throw InputError("--from, --to: expected --from before --to");
  if (fromSeconds(options.from) <= recording.length()) return;
  throw InputError("--from: the recording ends at " +
                   std::to_string(toSeconds(recording.length())) + " s");
}

// True if every recorded state was met.
bool replayOnce(const ReplayRunOptions& options, const Recording& recording,
                const runtime::RunStart& start) {
  checkStretch(options, recording);
  const validation::Stretch stretch{fromSeconds(options.from), fromSeconds(options.to)};
  Replayer replayer(recording, start);
  if (options.inputs) listInputs(recording, stretch);
  const bool writes = !options.csv.empty() || !options.set_out.empty();
  const validation::RunLog log(replayer, findRobot(recording, options.robot),
                               writes ? stretch : validation::Stretch{Duration::max()});
  replayer.advanceTo(stretch.to);
  if (replayer.elapsed() == recording.length()) replayer.finish();
  if (writes) writeSignals(options, log);
  if (!options.set.empty()) return true;  // it is to be another
  if (const auto& departure = replayer.departure()) {
    std::printf("it parts from the recorded states at %.3f s, after %zu that are the same\n",
                toSeconds(departure->elapsed), replayer.statesMet());
    return false;
  }
  const auto& states = recording.states;
  const auto before = std::count_if(states.begin(), states.end(), [&stretch](const auto& state) {
    return state.elapsed < stretch.from;
  });
  const std::size_t skipped = std::min(static_cast<std::size_t>(before), replayer.statesMet());
  std::printf("from %.3f to %.3f s all %zu recorded states are the same to the last bit\n",
              std::min(options.from, toSeconds(replayer.elapsed())), toSeconds(replayer.elapsed()),
              replayer.statesMet() - skipped);
  return replayer.elapsed() == std::min(recording.length(), stretch.to);
}

// True if the two are the same.
bool compare(const Recording& recording, const runtime::RunStart& start, const Recording& other) {
  const std::string inputs = validation::describeInputDifference(recording, other);
  if (!inputs.empty()) std::printf("%s\n", inputs.c_str());
  Replayer here(recording, start);
  Replayer there(other);
  const auto difference = validation::findDifference(here, there);
  if (!difference) {
    std::printf("both have the same states to the last bit until %.3f s\n",
                toSeconds(std::min(here.elapsed(), there.elapsed())));
    return inputs.empty() && recording.length() == other.length();
  }
  std::printf("their states part at %.3f s: %s\n", toSeconds(difference->elapsed),
              describe(difference->at_once).c_str());
  std::printf("at %.3f s: %s\n", toSeconds(difference->later_at),
              describe(difference->later).c_str());
  return false;
}

}  // namespace

bool replayRun(const ReplayRunOptions& options) {
  const Recording recording = runtime::readRecording(options.file);
  runtime::RunStart start = recording.start;
  for (const std::string& setting : options.set) validation::changeStart(setting, start);
  printHead(recording);
  const bool met = replayOnce(options, recording, start);
  if (!options.diff.empty()) {
    const Recording other = runtime::readRecording(options.diff);
    printHead(other);
    return compare(recording, start, other);
  }
  if (options.set.empty()) return met;
  compare(recording, start, recording);
  return true;
}

}  // namespace nao::app
