#include "ci/suite.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/ci/scenario_files.h"

namespace nao::ci {
namespace {

const char* const kThree = "seeds: [4, 5, 6]\nexpect: [{upright: {}}]\n";

TEST(Suite, FindsEveryScenarioOfAFolderByNameWithItsSeeds) {
  const TemporaryFolder folder;
  folder.write("b.yaml", scenarioText("expect: [{upright: {}}]\n"));
  folder.write("a.yaml", scenarioText(kThree));
  folder.write("notes.txt", "");
  const auto jobs = findJobs(folder.path(), 2);
  ASSERT_EQ(jobs.size(), 3u);
  EXPECT_EQ(folder.withoutPath(jobs[0].file), "a.yaml");
  EXPECT_EQ(jobs[1].seed, 5u);
  EXPECT_EQ(folder.withoutPath(jobs[2].file), "b.yaml");
  EXPECT_EQ(jobs[2].seed, 1u);
}

TEST(Suite, RefusesAFolderWithoutScenarios) {
  const TemporaryFolder folder;
  EXPECT_THROW(findJobs(folder.path(), 1), InputError);
}

// Shells in place of simulators: what they write is what a job leaves.
std::vector<JobResult> runShells(const std::vector<std::string>& scripts, double longest = 60) {
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < scripts.size(); ++i) jobs.push_back({"s.yaml", i});
  SuiteSettings settings;
  settings.jobs = 2;
  settings.longest = longest;
  settings.command = [&](const Job& job, const std::string& result, const std::string&) {
    return std::vector<std::string>{"sh", "-c", scripts[job.seed], "sh", result};
  };
  return runSuite(jobs, settings);
}

std::string leaving(const std::string& name) {
  Result result;
  result.scenario = name;
  return "echo hello; printf '%s' '" + toJson(result) + "' > $1";
}

TEST(Suite, GivesResultsInTheOrderOfItsJobs) {
  const auto results = runShells({leaving("a"), leaving("b"), leaving("c"), leaving("d")});
  ASSERT_EQ(results.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(results[i].result.scenario, std::string(1, static_cast<char>('a' + i)));
    EXPECT_TRUE(results[i].result.passed());
    EXPECT_EQ(results[i].output, "hello\n");
  }
}

TEST(Suite, AJobThatLeavesNothingHasFailedAndSaysHowItEnded) {
  const auto results = runShells({"echo oh; exit 9", "kill -KILL $$"});
  EXPECT_EQ(results[0].result.trouble, "it ended with exit code 9 and left no result");
  EXPECT_EQ(results[0].output, "oh\n");
  EXPECT_EQ(results[1].result.trouble, "it ended with exit code 137 and left no result");
}

TEST(Suite, AJobThatTakesTooLongIsEnded) {
  const auto results = runShells({"exec sleep 1000"}, 0.1);
  EXPECT_EQ(results[0].result.trouble, "it did not end within 0.1 s of wall time");
}

}  // namespace
}  // namespace nao::ci
