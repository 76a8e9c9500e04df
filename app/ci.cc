#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/commands.h"
#include "app/source_paths.h"
#include "ci/junit.h"
#include "ci/page.h"
#include "ci/scenario.h"
#include "ci/suite.h"
#include "core/check.h"
#include "core/files.h"
#include "validation/plot.h"
#include "validation/report.h"

namespace nao::app {
namespace {

struct Arguments {
  std::string path;
  std::size_t jobs = std::max(1U, std::thread::hardware_concurrency());
  std::size_t seeds = std::numeric_limits<std::size_t>::max();
  double longest = 600;  // [s]
  std::string speed = "max";
  std::string junit;
  std::string report;
  std::string record = "none";
  std::string recordings = ".";
  bool json = false;
};

ci::Places places() { return {findSourceFile("worlds"), findSourceFile("robots")}; }

// A line for each run, and on a terminal a bar that moves.
class Progress {
 public:
  explicit Progress(std::size_t runs) : runs_(runs), bar_(::isatty(STDERR_FILENO) == 1) {}

  void add(const ci::JobResult& job) {
    ++done_;
    const ci::Result& result = job.result;
    if (bar_) std::fprintf(stderr, "\r\033[K");
    if (!bar_ || !result.passed()) {
      std::fprintf(stderr, "%s  %s, seed %llu (%.1f s)\n", result.passed() ? "ok    " : "FAILED",
                   result.scenario.c_str(), static_cast<unsigned long long>(result.seed), job.wall);
    }
    for (const std::string& failure : ci::failuresOf(result)) {
      std::fprintf(stderr, "    %s\n", failure.c_str());
    }
    if (!result.passed()) tellMore(job);
    if (bar_) draw();
  }
  void end() const {
    if (bar_) std::fprintf(stderr, "\r\033[K");
  }

 private:
  static void tellMore(const ci::JobResult& job) {
    if (!job.output.empty()) std::fprintf(stderr, "    it printed:\n%s\n", job.output.c_str());
    std::fprintf(stderr, "    again: %s\n", ci::replayCommand(job.result).c_str());
  }
  void draw() const {
    constexpr std::size_t kWidth = 40;
    const std::size_t full = kWidth * done_ / runs_;
    std::fprintf(stderr, "[%s%s] %zu/%zu", std::string(full, '#').c_str(),
                 std::string(kWidth - full, '.').c_str(), done_, runs_);
    std::fflush(stderr);
  }

  std::size_t runs_;
  bool bar_;
  std::size_t done_ = 0;
};

ci::SuiteSettings settingsFor(const Arguments& arguments, Progress& progress) {
  ci::SuiteSettings settings;
  settings.jobs = arguments.jobs;
  settings.longest = arguments.longest;
  const std::string self = std::filesystem::canonical("/proc/self/exe");
  settings.command = [self, speed = arguments.speed](const ci::Job& job, const std::string& result,
                                                     const std::string& recording) {
    std::vector<std::string> words{
        self,       "run",  "--scenario", job.file, "--seed", std::to_string(job.seed),
        "--result", result, "--speed",    speed};
    if (!recording.empty()) words.insert(words.end(), {"--record", recording});
    return words;
  };
  if (arguments.record == "failed") settings.record = ci::SuiteSettings::Record::Failed;
  if (arguments.record == "all") settings.record = ci::SuiteSettings::Record::All;
  settings.recordings = arguments.recordings;
  settings.done = [&progress](const ci::JobResult& result) { progress.add(result); };
  return settings;
}

void tell(const Arguments& arguments, const std::vector<ci::JobResult>& results, double wall) {
  std::size_t passed = 0;
  for (const ci::JobResult& job : results) passed += job.result.passed() ? 1 : 0;
  const std::size_t failed = results.size() - passed;
  if (arguments.json) {
    validation::Report report;
    report.command = "ci";
    report.runs = static_cast<int>(results.size());
    report.figures = {{"scenarios", static_cast<double>(results.size())},
                      {"passed", static_cast<double>(passed)},
                      {"failed", static_cast<double>(failed)},
                      {"wall_s", wall}};
    std::printf("%s\n", validation::toJson(report).c_str());
  } else {
    std::printf("%zu runs, %zu passed, %zu failed, %.1f s\n", results.size(), passed, failed, wall);
  }
  if (failed > 0) throw CLI::RuntimeError(1);
}

void runSuite(const Arguments& arguments) {
  const std::vector<ci::Job> jobs = ci::findJobs(arguments.path, arguments.seeds);
  for (const ci::Job& job : jobs) ci::loadScenario(job.file, job.seed, places());
  if (!arguments.junit.empty()) writeFile("--junit", arguments.junit, "");  // told before the work
  if (!arguments.report.empty()) {
    validation::requireGnuplot();
    writeFile("--report", arguments.report, "");
  }
  Progress progress(jobs.size());
  const auto start = std::chrono::steady_clock::now();
  const auto results = ci::runSuite(jobs, settingsFor(arguments, progress));
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  progress.end();
  if (!arguments.junit.empty()) writeFile("--junit", arguments.junit, ci::toJUnit(results));
  if (!arguments.report.empty()) {
    writeFile("--report", arguments.report, ci::toPage(results, [](const std::string& model) {
                return loadRobotModel(findSourceFile("robots"), model);
              }));
  }
  tell(arguments, results, wall.count());
}

}  // namespace

void addCi(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "ci", "Runs scenarios, each in a process of its own, and tells which expectations failed.");
  command->add_option("path", arguments->path, "A folder of scenarios (*.yaml), or one of them.")
      ->required();
  command->add_option("--jobs", arguments->jobs, "How many run at a time. Default: one a core.")
      ->check(CLI::Range(1, 1000));
  command->add_option("--seeds", arguments->seeds, "At most so many of the seeds of each scenario.")
      ->check(CLI::Range(1, 1'000'000));
  command
      ->add_option("--speed", arguments->speed,
                   "Simulated seconds per second, or max: as fast as it goes.")
      ->capture_default_str();
  command->add_option("--timeout", arguments->longest, "Wall time that a run may take [s].")
      ->capture_default_str();
  command->add_option("--junit", arguments->junit, "Also writes the results as JUnit's XML.");
  command->add_option("--report", arguments->report,
                      "Also writes one HTML page: of each run that failed, pictures, tracks and\n"
                      "joints of its last seconds.");
  command
      ->add_option("--record", arguments->record,
                   "Records runs, for `usarnaoqi replay`: those that failed, or all.")
      ->check(CLI::IsMember({"none", "failed", "all"}))
      ->capture_default_str();
  command->add_option("--recordings", arguments->recordings, "The folder of these.")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "One JSON object instead of a sentence.");
  command->footer("The exit code is 0 if all passed, 1 if one failed, 2 if a scenario is broken.");
  command->callback([arguments] { runSuite(*arguments); });
}

}  // namespace nao::app
