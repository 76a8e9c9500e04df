#include "ci/junit.h"

#include <cstdio>
#include <map>

#include "ci/sentence.h"
#include "validation/html.h"

namespace nao::ci {
namespace {

std::string seconds(double wall) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", wall);
  return text;
}

// XML 1.0 has no place for other control characters, not even as references.
std::string escaped(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t';
    plain += control ? '?' : c;
  }
  return validation::escapeHtml(plain);
}

std::string caseOf(const JobResult& job) {
  const Result& result = job.result;
  std::string xml = "    <testcase classname=\"" + escaped(result.scenario) + "\" name=\"seed " +
                    std::to_string(result.seed) + "\" time=\"" + seconds(job.wall) + "\"";
  const auto failures = failuresOf(result);
  if (failures.empty()) return xml + "/>\n";
  xml += ">\n      <failure message=\"" + escaped(failures.front()) + "\">";
  for (const std::string& failure : failures) xml += escaped(failure) + "\n";
  return xml + "replay: " + escaped(replayCommand(result)) + "</failure>\n    </testcase>\n";
}

struct Count {
  std::size_t tests = 0, failures = 0;
  double wall = 0;
  void add(const JobResult& job) {
    ++tests;
    failures += job.result.passed() ? 0 : 1;
    wall += job.wall;
  }
  std::string text() const {
    return "tests=\"" + std::to_string(tests) + "\" failures=\"" + std::to_string(failures) +
           "\" time=\"" + seconds(wall) + "\"";
  }
};

}  // namespace

std::vector<std::string> failuresOf(const Result& result) {
  std::vector<std::string> failures;
  if (!result.trouble.empty()) failures.push_back(result.trouble);
  for (const Verdict& verdict : result.verdicts) {
    if (verdict.passed) continue;
    const std::string place =
        verdict.line > 0 ? result.file + ":" + std::to_string(verdict.line) + ": " : "";
    failures.push_back(place + "expected " + verdict.expected + "; " + verdict.seen +
                       (verdict.at > Duration::zero() ? " at " + shown(verdict.at) : ""));
  }
  return failures;
}

std::string replayCommand(const Result& result) {
  return "usarnaoqi run --scenario " + result.file + " --seed " + std::to_string(result.seed);
}

std::string toJUnit(const std::vector<JobResult>& results) {
  std::vector<std::string> order;
  std::map<std::string, std::pair<Count, std::string>> suites;
  Count all;
  for (const JobResult& job : results) {
    const std::string& name = job.result.scenario;
    if (!suites.count(name)) order.push_back(name);
    auto& [count, cases] = suites[name];
    count.add(job);
    cases += caseOf(job);
    all.add(job);
  }
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + all.text() + ">\n";
  for (const std::string& name : order) {
    const auto& [count, cases] = suites[name];
    xml += "  <testsuite name=\"" + escaped(name) + "\" " + count.text() + ">\n" + cases +
           "  </testsuite>\n";
  }
  return xml + "</testsuites>\n";
}

}  // namespace nao::ci
