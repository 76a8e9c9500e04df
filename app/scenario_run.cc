#include "app/scenario_run.h"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "app/program_file.h"
#include "app/shared_clock.h"
#include "app/source_paths.h"
#include "ci/executor.h"
#include "ci/junit.h"
#include "core/check.h"
#include "core/files.h"
#include "daemon/descriptor_limit.h"

namespace nao::app {
namespace {

// Which of its clients keeps its own time, and why; empty: none.
std::string whoKeepsTime(const ci::Scenario& scenario) {
  for (const ci::ClientSetup& client : scenario.clients) {
    const std::string file = findProgram(client.command.front());
    const std::string why = file.empty() ? "" : whyNoClock(file);
    if (!why.empty()) return client.command.front() + " " + why;
  }
  return {};
}

void shareClock(SharedClock& clock, bool lockstep, ci::ExecutorSettings& settings) {
  settings.clock = &clock.page();
  const char* before = std::getenv("LD_PRELOAD");
  settings.clock_environment = {
      {clock::kPageVariable, clock.path()},
      {"LD_PRELOAD", clockLibrary() + (before && *before ? ":" + std::string(before) : "")}};
  if (lockstep) settings.clock_environment["PYTHONHASHSEED"] = "0";
}

void tell(const ci::Result& result) {
  for (const std::string& failure : ci::failuresOf(result)) {
    std::fprintf(stderr, "usarnaoqi: %s\n", failure.c_str());
  }
  std::fprintf(stderr, "usarnaoqi: %s seed %" PRIu64 " %s, state %016" PRIx64 "\n",
               result.scenario.c_str(), result.seed, result.passed() ? "passed" : "FAILED",
               result.hash);
}

}  // namespace

bool runScenario(const ScenarioRun& run) {
  const ci::Scenario scenario =
      ci::loadScenario(run.file, run.seed, {findSourceFile("worlds"), findSourceFile("robots")});
  ci::ExecutorSettings settings;
  settings.robots_dir = findSourceFile("robots");
  settings.python_path = findSourceFile("naoqi_api/sdk/python");
  settings.behaviors = shippedMotions();
  settings.speed = run.speed;
  settings.record = run.record;
  std::optional<SharedClock> clock;
  const std::string who = whoKeepsTime(scenario);
  if (who.empty()) {
    clock.emplace(run.lockstep ? clock::Mode::Lockstep : clock::Mode::Follow);
    shareClock(*clock, run.lockstep, settings);
  } else {
    std::fprintf(stderr, "usarnaoqi: %s: it keeps its own time, so the world goes at 1x\n",
                 who.c_str());
    settings.speed = 1;
  }
  daemon::raiseDescriptorLimit();
  const ci::Result result = ci::execute(scenario, settings);
  tell(result);
  if (run.result.empty()) return result.passed();
  writeFile("--result", run.result, ci::toJson(result));
  return result.passed();
}

}  // namespace nao::app
