#include <unistd.h>

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/program_file.h"
#include "app/scenario_run.h"
#include "app/shared_clock.h"
#include "app/source_paths.h"
#include "clock/futex.h"
#include "core/check.h"
#include "daemon/child_process.h"
#include "daemon/daemon.h"
#include "daemon/descriptor_limit.h"
#include "daemon/large_blocks.h"

namespace nao::app {
namespace {

constexpr timespec kPatience{10, 0};  // for a program that was asked to end

constexpr double kFramePatience = 5;  // [s] of the wall, with a LoLA program that does not answer

struct Arguments {
  daemon::Options options;
  std::vector<std::string> robots;
  std::vector<std::string> command;
  std::vector<std::string> lola;
  std::string speed = "max";
  bool lockstep = true;
  bool python2 = false;
  ScenarioRun scenario;
};

bool isScript(const std::string& word) {
  return word.size() > 3 && word.compare(word.size() - 3, 3, ".py") == 0;
}

// What is started: `script.py` alone is Python's, and where there is no `python`, python3 is meant.
// Python 2 goes through the module that converts it.
std::vector<std::string> commandOf(const Arguments& arguments) {
  std::vector<std::string> words = arguments.command;
  if (isScript(words.front())) words.insert(words.begin(), "python3");
  if (words.front() == "python" && findProgram("python").empty()) words.front() = "python3";
  if (!arguments.python2) return words;
  if (words.front().rfind("python2", 0) == 0) words.front() = "python3";
  const auto script = std::find_if(words.begin() + 1, words.end(), isScript);
  if (script == words.end()) throw InputError("--py2: there is no script FILE.py in the command");
  const std::vector<std::string> through = {"-m", "usarnaoqi_sdk.python2"};
  words.insert(script, through.begin(), through.end());
  return words;
}

void prepend(const char* name, const std::string& word) {
  const char* before = std::getenv(name);
  const std::string rest = before && *before ? ":" + std::string(before) : "";
  ::setenv(name, (word + rest).c_str(), 1);
}

/// Where converted copies of Python 2 are kept; gone with it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "usarnaoqi-py2-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw InputError(name + ": can not be made");
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;  // somebody else has removed it
    std::filesystem::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// A world and a program in it, each a child of ours. Whatever happens to us, they end.
class Run {
 public:
  explicit Run(Arguments& arguments)
      : arguments_(arguments),
        signals_(daemon::blockWatchedSignals()),
        words_(commandOf(arguments)) {
    chooseClock();
  }

  int run() {
    world_.emplace([this] { return beWorld(); }, signals_);
    if (!awaitWorld()) return *world_->findEnd();
    setEnvironment();
    program_.emplace(daemon::ChildProcess::Program{words_, ".", {}}, signals_);
    const bool worlds_fault = !watch();
    endWorld();
    if (worlds_fault) std::fprintf(stderr, "usarnaoqi: the world ended before the program did\n");
    return worlds_fault ? 1 : *program_->findEnd();
  }

 private:
  // Which clock the program gets, and how fast the world then goes.
  void chooseClock() {
    arguments_.options.speed = daemon::parseSpeed(arguments_.speed);
    const std::string file = findProgram(words_.front());
    const std::string why = file.empty() ? "" : whyNoClock(file);
    if (!arguments_.options.lola.empty()) {  // frames are its time
      if (arguments_.lockstep) arguments_.options.lola_lockstep = kFramePatience;
      arguments_.options.lola_to_the_end = true;
      has_clock_ = arguments_.lockstep = false;
    } else if (!why.empty()) {
      std::fprintf(stderr,
                   "usarnaoqi: %s %s: it keeps its own time, so the world goes at 1x and not in "
                   "lockstep\n",
                   words_.front().c_str(), why.c_str());
      arguments_.options.speed = 1;
      has_clock_ = arguments_.lockstep = false;
    }
    clock_.emplace(arguments_.lockstep ? clock::Mode::Lockstep : clock::Mode::Follow);
    arguments_.options.clock = &clock_->page();
  }

  int beWorld() {
    ::setpgid(0, 0);  // Ctrl-C is for the program, and standard output, too
    spdlog::set_default_logger(spdlog::stderr_logger_mt("usarnaoqi"));
    try {
      daemon::raiseDescriptorLimit();
      daemon::keepLargeBlocks();
      daemon::Daemon daemon(arguments_.options);
      daemon.stopOnSignals();
      daemon.run([&] { open(daemon); });
      tellEnd(daemon);
      return 0;
    } catch (const InputError& error) {
      std::fprintf(stderr, "usarnaoqi: %s\n", error.what());
      return 2;
    }
  }

  void open(daemon::Daemon& daemon) {
    clock::ClockPage& page = clock_->page();
    std::size_t i = 0;
    for (std::size_t robot = 0; robot < daemon.robotCount(); ++robot)
      for (const std::uint16_t port : daemon.endpoints(robot).gatedPorts())
        if (i + 1 < clock::kPorts) page.ports[i++] = port;
    page.ready = 1;
    clock::ring(page.ready);
  }

  void tellEnd(daemon::Daemon& daemon) {
    const daemon::LoopState end = daemon.state();
    const std::uint32_t strayed = clock_->page().strayed.load();
    const char* kept = !arguments_.lockstep ? "" : strayed ? ", not repeatable" : ", repeatable";
    std::fprintf(stderr,
                 "usarnaoqi: ended at %.3f s of simulated time, state %016" PRIx64
                 ", run %016" PRIx64 "%s\n",
                 toSeconds(end.time), end.hash, daemon.runHash(), kept);
    if (const std::string failure = daemon.recordingFailure(); !failure.empty())
      std::fprintf(stderr, "usarnaoqi: the recording ends early: %s\n", failure.c_str());
  }

  // False when it has ended before.
  bool awaitWorld() {
    clock::ClockPage& page = clock_->page();
    while (page.ready.load() == 0) {
      if (world_->hasEnded()) return false;
      clock::waitWhile(page.ready, 0, 20 * clock::kMillisecond);
    }
    return true;
  }

  void setEnvironment() {
    std::string robots;  // in the order in which they are named
    for (const std::uint16_t port : clock_->page().ports) {
      if (port == 0) break;
      robots += (robots.empty() ? "127.0.0.1:" : ",127.0.0.1:") + std::to_string(port);
    }
    ::setenv("NAOQI_ADDRESS", robots.c_str(), 1);
    prepend("PYTHONPATH", findSourceFile("naoqi_api/sdk/python"));
    if (!has_clock_) return;
    ::setenv(clock::kPageVariable, clock_->path().c_str(), 1);
    prepend("LD_PRELOAD", clockLibrary());
    if (arguments_.lockstep) ::setenv("PYTHONHASHSEED", "0", 1);
  }

  // Until the program has ended; false: the world ended before. A terminal's Ctrl-C reaches the
  // program by itself; other signals are handed on. What it makes of Ctrl-C is its affair; if it is
  // told to end and does not in time, it is ended.
  bool watch() {
    const sigset_t watched = daemon::watchedSignals();
    bool asked = false;
    bool alone = false;
    while (!program_->hasEnded()) {
      if (!alone && world_->hasEnded()) {
        alone = asked = true;
        clock_->stop();
        program_->signal(SIGTERM);
      }
      siginfo_t info{};
      const int signal =
          asked ? ::sigtimedwait(&watched, &info, &kPatience) : ::sigwaitinfo(&watched, &info);
      if (signal < 0 && errno == EAGAIN) program_->signal(SIGKILL);
      if (signal <= 0 || signal == SIGCHLD) continue;
      if (info.si_code != SI_KERNEL) program_->signal(signal);
      asked = asked || signal != SIGINT;
    }
    return !alone;
  }

  void endWorld() {
    const sigset_t watched = daemon::watchedSignals();
    clock_->stop();  // whoever of the program's processes goes on does so by itself
    world_->signal(SIGTERM);
    while (!world_->hasEnded()) {
      const int signal = ::sigtimedwait(&watched, nullptr, &kPatience);
      if (signal < 0 && errno == EAGAIN) world_->signal(SIGKILL);
    }
  }

  Arguments& arguments_;
  const sigset_t signals_;
  std::vector<std::string> words_;
  bool has_clock_ = true;
  std::optional<SharedClock> clock_;
  std::optional<daemon::ChildProcess> world_;
  std::optional<daemon::ChildProcess> program_;
};

void playScenario(Arguments& arguments) {
  ScenarioRun& scenario = arguments.scenario;
  scenario.seed = std::max<std::uint64_t>(arguments.options.seed, 1);
  scenario.speed = daemon::parseSpeed(arguments.speed);
  scenario.lockstep = arguments.lockstep;
  scenario.record = arguments.options.record;
  if (!runScenario(scenario)) throw CLI::RuntimeError(1);
}

void run(Arguments& arguments) {
  if (!arguments.scenario.file.empty()) return playScenario(arguments);
  if (arguments.command.empty()) throw InputError("run: expected a program after --");
  daemon::Options& options = arguments.options;
  for (const std::string& robot : arguments.robots) {
    options.robots.push_back(daemon::parseRobot(robot));
  }
  for (const std::string& lola : arguments.lola) {
    options.lola.push_back(daemon::parseLola(lola));
  }
  options.port = 0;
  options.world = findSourceFile(options.world);
  options.robots_dir = findSourceFile(options.robots_dir);
  options.behaviors = shippedMotions();

  std::optional<TemporaryFolder> copies;
  if (arguments.python2) ::setenv("USARNAOQI_PY2_FOLDER", copies.emplace().path().c_str(), 1);
  const int code = Run(arguments).run();
  if (code != 0) throw CLI::RuntimeError(code);
}

}  // namespace

void addRun(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  daemon::Options& options = arguments->options;
  CLI::App* command = app.add_subcommand(
      "run", "Runs a program with a robot of its own, which ends with it: run -- python3 file.py");
  command
      ->add_option("--robot", arguments->robots,
                   "A robot of the folder robots/ or a FILE.urdf, as MODEL or NAME=MODEL. Default: "
                   "nao_h21_v33.")
      ->allow_extra_args(false);
  command->add_option("--world", options.world, "The world, a YAML file.")->capture_default_str();
  command
      ->add_option("--speed", arguments->speed,
                   "Simulated seconds per second at most, or 'max' for as fast as it goes.")
      ->capture_default_str();
  command->add_flag(
      "--lockstep,!--no-lockstep", arguments->lockstep,
      "The program's clocks and sleeps are the world's, and its threads take turns with\n"
      "the world, so that every run is the same whatever else the machine does (default).\n"
      "Without it the clocks follow the world.");
  command
      ->add_option("--lola", arguments->lola,
                   "The program speaks LoLA, on [ROBOT=]PATH (/tmp/robocup): the world waits for\n"
                   "its answer to every frame, and its clocks stay its own.")
      ->expected(0, 1)
      ->default_str("")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      ->add_option("--seed", options.seed,
                   "Draws what makes real runs differ; 0: no variation (see serve --help).")
      ->capture_default_str();
  command
      ->add_option("--data-dir", options.data_dir,
                   "Where the files are that the program plays, records and writes on the robot.")
      ->check(CLI::ExistingDirectory);
  command->add_option("--naoqi", options.naoqi, "The NAOqi to be like: 1.12 to 2.9.");
  command->add_option("--record", options.record,
                      "Writes the run into this FILE, for `usarnaoqi replay`.");
  command->add_flag("--py2", arguments->python2,
                    "The program is Python 2: it runs converted, from a temporary copy.");
  CLI::Option* program = command->add_option("command", arguments->command,
                                             "The program and its arguments, after --.");
  CLI::Option* scenario =
      command
          ->add_option("--scenario", arguments->scenario.file,
                       "Runs this scenario, its own clients included, instead of a program.")
          ->excludes(program);
  command
      ->add_option("--result", arguments->scenario.result,
                   "Writes how the scenario ended, as JSON.")
      ->needs(scenario);
  command->positionals_at_end();
  command->footer(
      "The program finds the robot whatever address it names: NAOQI_ADDRESS is set, and "
      "PYTHONPATH,\n"
      "so that naoqi, qi, almath, motion and vision_definitions are there unless they are "
      "installed.\n"
      "Of several robots, robot i from 0 on is meant by port 9559 + i, or else by the i-th\n"
      "address that it names.\n"
      "The exit code is the program's; 128 + n if signal n ended it. In lockstep time passes only\n"
      "while the program waits; a call that is answered at once takes 0.5 ms of it.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace nao::app
