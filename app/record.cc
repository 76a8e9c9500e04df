#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/source_paths.h"
#include "core/check.h"
#include "naoqi_api/call_error.h"
#include "recorder/hanging.h"
#include "recorder/lola_recorder.h"
#include "recorder/quiet_robot.h"
#include "recorder/robot_recorder.h"
#include "validation/log/floor_recording.h"
#include "validation/log/growing_set.h"
#include "validation/log/simulated_recording.h"
#include "validation/log/standard_motions.h"
#include "core/suspend.h"

namespace nao::app {
namespace {

struct Arguments {
  std::string out;
  std::string protocol = "standard";
  std::string robot = "nao_h21_v33";
  std::string robots_dir = "robots";
  std::string host = "127.0.0.1";
  std::uint16_t port = 9559;
  std::string lola;
  bool simulate = false;
  std::uint64_t seed = 1;
  std::optional<int> repeats_asked;
  std::optional<double> seconds_asked;
  double noise = 0.03;    // [N m]
  double start = 0.001;   // [s]
  double step = 0.00025;  // [s]
  std::vector<std::string> joints;
  bool hangs = false;

  int repeats() const { return repeats_asked.value_or(validation::kStandardRepeats); }
  double seconds() const { return seconds_asked.value_or(60); }
};

validation::LogSet recordSimulation(const Arguments& arguments, const RobotModel& model) {
  validation::RecordingPlan plan;
  plan.name = "standard set of a simulated " + model.name;
  plan.model = std::make_shared<RobotModel>(suspend(model));
  if (arguments.noise > 0) {
    plan.extra = {{"process_noise", {{"sd", arguments.noise}}, {}, "--noise"}};
  }
  plan.motions = validation::standardRecording(plan.model);
  if (!arguments.joints.empty()) {
    validation::moveOnly(arguments.joints, plan.model, plan.motions);
  }
  plan.repeats = arguments.repeats();
  plan.step = fromSeconds(arguments.step);
  plan.seed = arguments.seed;
  plan.start_sd = arguments.start;
  plan.joints = arguments.joints;
  plan.inertial_unit = true;
  return validation::recordSimulated(plan);
}

const std::vector<validation::FloorMotion>& floorMotions(const std::string& protocol) {
  return protocol == "walk" ? validation::walkingMotions() : validation::standingMotions();
}

validation::LogSet recordSimulatedFloor(const Arguments& arguments, const RobotModel& model) {
  validation::FloorPlan plan;
  plan.model = std::make_shared<RobotModel>(model);
  if (arguments.noise > 0) {
    plan.extra = {{"process_noise", {{"sd", arguments.noise}}, {}, "--noise"}};
  }
  plan.motions = floorMotions(arguments.protocol);
  plan.repeats = arguments.repeats();
  plan.seed = arguments.seed;
  return validation::recordOnFloor(plan);
}

// The standing or walking set of a robot that speaks NaoQi.
void recordFloor(recorder::RobotRecorder& recorder, const Arguments& arguments,
                 validation::GrowingSet& set) {
  for (const validation::FloorMotion& motion : floorMotions(arguments.protocol)) {
    for (int repeat = 0; repeat < arguments.repeats(); ++repeat) {
      std::fprintf(stderr, "%s, run %d of %d\n", motion.name.c_str(), repeat + 1,
                   arguments.repeats());
      set.add(recorder.play(motion, repeat));
    }
  }
}

// The standard set by any recorder that can watch(), describe() a set and play() a run of it.
template <class Recorder>
validation::LogSet recordStandard(Recorder& recorder, const Arguments& arguments,
                                  const RobotModel& model) {
  constexpr double kLook = 0.5;  // [s] at whether the robot hangs
  if (!arguments.hangs) recorder::requireHanging(recorder.watch(kLook), model);
  validation::LogSet empty = recorder.describe("standard set");
  empty.environment.suspended = true;
  validation::GrowingSet set(std::move(empty), arguments.out);
  const auto& motions = validation::standardMotions();
  const std::size_t runs = motions.size() * static_cast<std::size_t>(arguments.repeats());
  for (std::size_t m = 0; m < motions.size(); ++m) {
    for (int repeat = 0; repeat < arguments.repeats(); ++repeat) {
      std::fprintf(stderr, "run %zu of %zu: %s\n", set.set().runs.size() + 1, runs,
                   motions[m].name.c_str());
      set.add(recorder.play(m, repeat));
    }
  }
  return set.set();
}

validation::LogSet recordRobot(const Arguments& arguments,
                               const std::shared_ptr<const RobotModel>& model) {
  daemon::QiClient client(arguments.host, arguments.port);
  recorder::RobotRecorder recorder(client, model, arguments.joints);
  if (arguments.protocol == "standard") {
    const recorder::QuietRobot quiet(client, recorder.moving());
    return recordStandard(recorder, arguments, *model);
  }
  const bool watch = arguments.protocol == "watch";
  validation::GrowingSet set(recorder.describe(watch ? "watched" : arguments.protocol + "ing set"),
                             arguments.out);
  if (watch) {
    set.add(recorder.watch(arguments.seconds()));
  } else {
    recorder.wakeUp();
    recordFloor(recorder, arguments, set);
  }
  return set.set();
}

validation::LogSet recordLola(const Arguments& arguments,
                              const std::shared_ptr<const RobotModel>& model) {
  daemon::LolaLink link(arguments.lola);
  recorder::LolaRecorder recorder(link, model, arguments.joints);
  return recordStandard(recorder, arguments, *model);
}

validation::LogSet recordInSimulation(const Arguments& arguments, const RobotModel& model) {
  const validation::LogSet set = arguments.protocol == "standard"
                                     ? recordSimulation(arguments, model)
                                     : recordSimulatedFloor(arguments, model);
  validation::writeLogSet(set, arguments.out);
  return set;
}

validation::LogSet record(const Arguments& arguments,
                          const std::shared_ptr<const RobotModel>& model) {
  if (!arguments.lola.empty()) return recordLola(arguments, model);
  if (arguments.simulate) return recordInSimulation(arguments, *model);
  return recordRobot(arguments, model);
}

// Options that would do nothing where they stand are told, not passed over.
void check(const Arguments& arguments) {
  const bool standard = arguments.protocol == "standard";
  if (!arguments.lola.empty() && !standard) {
    throw InputError("--lola: expected --protocol standard, found " + arguments.protocol);
  }
  if (arguments.simulate && arguments.protocol == "watch") {
    throw InputError("--simulate: there is nothing to watch");
  }
  if (!standard && !arguments.joints.empty()) {
    throw InputError("--joints: expected --protocol standard, found " + arguments.protocol);
  }
  const bool watch = arguments.protocol == "watch";
  if (!watch && arguments.seconds_asked) {
    throw InputError("--seconds: expected --protocol watch, found " + arguments.protocol);
  }
  if (watch && arguments.repeats_asked) {
    throw InputError("--repeats: expected motions to repeat, found --protocol watch");
  }
  validation::requireNoSet(arguments.out);
}

void run(const Arguments& arguments) {
  check(arguments);
  const auto model = loadRobotModel(findSourceFile(arguments.robots_dir), arguments.robot);
  try {
    const validation::LogSet set = record(arguments, model);
    std::printf("%zu runs of %zu joints: %s\n", set.runs.size(), set.joints.size(),
                arguments.out.c_str());
  } catch (const rpc::CallError& error) {
    throw InputError(arguments.host + ": the robot refused: " + error.what());
  }
}

void addOptions(CLI::App& command, Arguments& arguments) {
  command.add_option("out", arguments.out, "The set's folder; made if it is not there.")
      ->required();
  command
      .add_option("--protocol", arguments.protocol,
                  "standard: seven motions of every joint, six times 6 s each (20 minutes).\n"
                  "Hang the robot up by its torso first, feet in the air, arms free.\n"
                  "watch: what the robot does by itself, for --seconds.")
      ->check(CLI::IsMember({"standard", "stand", "walk", "watch"}))
      ->capture_default_str();
  command.add_option("--robot", arguments.robot, "The nominal model, of the folder robots/.")
      ->capture_default_str();
  command.add_option("--robots-dir", arguments.robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command
      .add_option("--joints", arguments.joints,
                  "The joints that the standard motions move. Default: all.")
      ->delimiter(',');
  command.add_option("--repeats", arguments.repeats_asked, "Runs of each motion; 6.")
      ->check(CLI::Range(1, 1000));
  command.add_option("--seconds", arguments.seconds_asked, "How long to watch; 60.")
      ->check(CLI::Range(0.1, 86400.0));
}

CLI::Option* addWires(CLI::App& command, Arguments& arguments) {
  CLI::Option* host =
      command.add_option("--host", arguments.host, "The robot, or the host of a daemon.")
          ->capture_default_str();
  CLI::Option* port = command.add_option("--port", arguments.port, "Where its NaoQi listens.")
                          ->capture_default_str();
  CLI::Option* lola =
      command
          .add_option("--lola", arguments.lola,
                      "The LoLA socket of a NAO V6 instead, /tmp/robocup there (--robot "
                      "nao_h25_v60).")
          ->excludes(host)
          ->excludes(port);
  CLI::Option* hangs = command.add_flag("--hangs", arguments.hangs,
                                        "It does hang, whatever its force and tilt sensors say.");
  return command
      .add_flag("--simulate", arguments.simulate,
                "Records a simulated robot, hung up, without a daemon.")
      ->excludes(host)
      ->excludes(port)
      ->excludes(lola)
      ->excludes(hangs);
}

void addSimulationOptions(CLI::App& command, Arguments& arguments, CLI::Option* simulate) {
  command.add_option("--seed", arguments.seed, "Of all that differs between simulated runs.")
      ->needs(simulate)
      ->capture_default_str();
  command.add_option("--noise", arguments.noise, "Random torque on every simulated joint [N m].")
      ->check(CLI::Range(0.0, 5.0))
      ->needs(simulate)
      ->capture_default_str();
  command.add_option("--start-jitter", arguments.start, "Of a simulated run's begin [s].")
      ->check(CLI::Range(0.0, 0.1))
      ->needs(simulate)
      ->capture_default_str();
  command.add_option("--step", arguments.step, "Length of a physics step [s] of a hung-up robot.")
      ->check(CLI::Range(1e-5, 0.005))
      ->needs(simulate)
      ->capture_default_str();
}

}  // namespace

void addRecord(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "record", "Records a set (docs/robot_log.md) from a robot or a simulation.");
  addOptions(*command, *arguments);
  addSimulationOptions(*command, *arguments, addWires(*command, *arguments));
  command->callback([arguments] { run(*arguments); });
}

}  // namespace nao::app
