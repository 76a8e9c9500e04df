#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/commands.h"
#include "app/source_paths.h"
#include "core/check.h"
#include "daemon/daemon.h"
#include "daemon/descriptor_limit.h"

namespace nao::app {
namespace {

constexpr int kNotFound = 127;        // as a shell says that there is no such program
constexpr int kBySignal = 128;        // as a shell says that a program ended by signal n: 128 + n
constexpr timespec kPatience{10, 0};  // for a program that was asked to end

struct Arguments {
  daemon::Options options;
  std::vector<std::string> robots;
  std::vector<std::string> command;
  bool python2 = false;
};

bool isScript(const std::string& word) {
  return word.size() > 3 && word.compare(word.size() - 3, 3, ".py") == 0;
}

bool isInPath(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string folders = path ? path : "";
  for (std::size_t start = 0; start <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', start), folders.size());
    const auto file = std::filesystem::path(folders.substr(start, end - start)) / program;
    if (::access(file.c_str(), X_OK) == 0) return true;
    start = end + 1;
  }
  return false;
}

// What is started: `script.py` alone is Python's, and where there is no `python`, python3 is meant.
// Python 2 goes through the module that converts it.
std::vector<std::string> commandOf(const Arguments& arguments) {
  std::vector<std::string> words = arguments.command;
  if (isScript(words.front())) words.insert(words.begin(), "python3");
  if (words.front() == "python" && !isInPath("python")) words.front() = "python3";
  if (!arguments.python2) return words;
  if (words.front().rfind("python2", 0) == 0) words.front() = "python3";
  const auto script = std::find_if(words.begin() + 1, words.end(), isScript);
  if (script == words.end()) throw InputError("--py2: there is no script FILE.py in the command");
  const std::vector<std::string> through = {"-m", "usarnaoqi_sdk.python2"};
  words.insert(script, through.begin(), through.end());
  return words;
}

void prepend(const char* name, const std::string& folder) {
  const char* before = std::getenv(name);
  const std::string rest = before && *before ? ":" + std::string(before) : "";
  ::setenv(name, (folder + rest).c_str(), 1);
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

sigset_t watchedSignals() {
  sigset_t watched;
  ::sigemptyset(&watched);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) ::sigaddset(&watched, signal);
  return watched;
}

/// The user's program: started once the robot answers; its end, and signals to us, are waited for
/// on a thread of its own. Whatever happens to us, it ends.
class Program {
 public:
  /// No thread is running yet: all are to leave the signals to ours.
  explicit Program(std::vector<std::string> command) : words_(std::move(command)) {
    const sigset_t watched = watchedSignals();
    ::pthread_sigmask(SIG_BLOCK, &watched, &before_);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    if (watcher_.joinable()) watcher_.join();
  }

  /// `ended` is called on the other thread.
  void start(const std::function<void()>& ended) {
    std::vector<char*> pointers;
    for (std::string& word : words_) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const pid_t parent = ::getpid();
    process_ = ::fork();
    NAO_CHECK(process_ >= 0);
    if (process_ == 0) become(pointers, parent);
    watcher_ = std::thread([this, ended] {
      watch();
      ended();
    });
  }

  /// After the end.
  int exitCode() const { return exit_code_; }

 private:
  [[noreturn]] void become(const std::vector<char*>& words, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(kNotFound);  // we were too late to be told
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    ::execvp(words[0], words.data());
    std::perror(words[0]);
    ::_exit(kNotFound);
  }

  // A terminal's Ctrl-C reaches the program by itself; other signals are handed on. What it makes
  // of Ctrl-C is its affair; if it is told to end and does not in time, it is ended.
  void watch() {
    const sigset_t watched = watchedSignals();
    bool asked = false;
    while (!hasEnded()) {
      siginfo_t info{};
      const int signal =
          asked ? ::sigtimedwait(&watched, &info, &kPatience) : ::sigwaitinfo(&watched, &info);
      if (signal < 0 && asked) ::kill(process_, SIGKILL);
      if (signal <= 0 || signal == SIGCHLD) continue;
      if (info.si_code != SI_KERNEL) ::kill(process_, signal);
      asked = asked || signal != SIGINT;
    }
  }

  bool hasEnded() {
    int status = 0;
    if (::waitpid(process_, &status, WNOHANG) != process_) return false;
    exit_code_ = WIFSIGNALED(status) ? kBySignal + WTERMSIG(status) : WEXITSTATUS(status);
    return true;
  }

  std::vector<std::string> words_;
  sigset_t before_{};
  pid_t process_ = 0;
  int exit_code_ = 0;
  std::thread watcher_;
};

void run(Arguments& arguments) {
  daemon::Options& options = arguments.options;
  for (const std::string& robot : arguments.robots) {
    options.robots.push_back(daemon::parseRobot(robot));
  }
  options.port = 0;
  options.world = findSourceFile(options.world);
  options.robots_dir = findSourceFile(options.robots_dir);
  options.behaviors = shippedMotions();

  std::optional<TemporaryFolder> copies;
  if (arguments.python2) ::setenv("USARNAOQI_PY2_FOLDER", copies.emplace().path().c_str(), 1);
  Program program(commandOf(arguments));
  daemon::raiseDescriptorLimit();
  daemon::Daemon daemon(options);
  daemon.run([&] {
    const std::string port = std::to_string(daemon.port(0));
    ::setenv("NAOQI_ADDRESS", ("127.0.0.1:" + port).c_str(), 1);
    prepend("PYTHONPATH", findSourceFile("naoqi_api/sdk/python"));
    program.start([&] { daemon.stop(); });
  });
  if (program.exitCode() != 0) throw CLI::RuntimeError(program.exitCode());
}

}  // namespace

void addRun(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  daemon::Options& options = arguments->options;
  CLI::App* command = app.add_subcommand(
      "run", "Runs a program with a robot of its own, which ends with it: run -- python3 file.py");
  command->add_option(
      "--robot", arguments->robots,
      "A robot of the folder robots/ or a FILE.urdf, as MODEL or NAME=MODEL. Default: "
      "nao_h21_v33.");
  command->add_option("--world", options.world, "The world, a YAML file.")->capture_default_str();
  command->add_flag("--py2", arguments->python2,
                    "The program is Python 2: it runs converted, from a temporary copy.");
  command->add_option("command", arguments->command, "The program and its arguments, after --.")
      ->required();
  command->positionals_at_end();
  command->footer(
      "The program finds the robot whatever address it names: NAOQI_ADDRESS is set, and "
      "PYTHONPATH,\n"
      "so that naoqi, qi, almath, motion and vision_definitions are there unless they are "
      "installed.\n"
      "The exit code is the program's; 128 + n if signal n ended it.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace nao::app
