#include "tests/hidden/trial.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/check.h"
#include "core/files.h"
#include "core/robot_model.h"

namespace nao::hidden {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  writeFile("", file.string(), text + "\n");
}

std::string read(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

double secondsOf(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

struct Ended {
  int code = 0;
  double cpu = 0;  // [s] that it and its children took
};

// Runs a program in `folder` with an empty environment but for PATH; both outputs go to `log`. Any
// number of threads may: nothing is allocated between fork and exec.
Ended runIn(const std::string& folder, const std::vector<std::string>& words,
            const std::string& log) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  char path[] = "PATH=/usr/bin:/bin";
  char* environment[] = {path, nullptr};
  const pid_t child = fork();
  NAO_CHECK(child >= 0);
  if (child == 0) {
    const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (out < 0 || chdir(folder.c_str()) != 0) _exit(127);
    dup2(out, 1);
    dup2(out, 2);
    execve(arguments[0], arguments.data(), environment);
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  NAO_CHECK(wait4(child, &status, 0, &usage) == child);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime)};
}

Json toJson(const Score& score) {
  Json numbers = Json::array();
  for (const Score::Number& number : score.numbers) {
    numbers.push_back({{"error", number.error},
                       {"interval", number.has_interval},
                       {"covered", number.covered},
                       {"own_law", number.own_law}});
  }
  return {{"false_alarm", score.false_alarm},
          {"said_unknown", score.said_unknown},
          {"detected", score.detected},
          {"exact", score.exact},
          {"look_alike", score.look_alike},
          {"named_wrong", score.named_wrong},
          {"truth_in_set", score.truth_in_set},
          {"ambiguous", score.ambiguous},
          {"unknown", score.unknown},
          {"set_size", score.set_size},
          {"found", score.found},
          {"found_among", score.found_among},
          {"named", score.named},
          {"named_right", score.named_right},
          {"flagged", score.flagged},
          {"signature_right", score.signature_right},
          {"fault_found", score.fault_found},
          {"fault_named", score.fault_named},
          {"numbers", numbers}};
}

Json toJson(const std::vector<JudgedStatement>& statements) {
  Json list = Json::array();
  for (const JudgedStatement& one : statements) {
    list.push_back({{"level", one.kind.level},
                    {"verdict", one.kind.verdict},
                    {"size", one.kind.size},
                    {"signals", one.kind.signals},
                    {"repeats", one.kind.repeats},
                    {"right", one.right},
                    {"wrong", one.wrong}});
  }
  return list;
}

// What was said, short: "HeadYaw: kp_error | motor_inertia".
std::string saying(const GivenReport& report) {
  std::string text = report.verdict;
  for (const std::string& fault : report.faults) text += " " + fault;
  for (const GivenCause& cause : report.causes) {
    text += "; " + (cause.joint.empty() ? "all" : cause.joint) + ": " + cause.cause;
    for (const std::string& rival : cause.rivals) text += " | " + rival;
  }
  for (const GivenJoint& joint : report.joints) {
    if (!joint.signature.empty()) text += "; " + joint.joint + " goes with " + joint.signature;
  }
  return text;
}

}  // namespace

SealedSet sealSet(const HiddenCase& hidden, const TrialPlace& place) {
  const auto nominal = loadRobotModel(place.robots_dir, hidden.robot());
  const HiddenSet made = makeHiddenSetSomewhere(hidden, nominal);
  SealedSet sealed;
  sealed.truth = made.truth;
  sealed.folder = (fs::path(place.folder) / "sets" / made.truth.name).string();
  sealed.truth_file = (fs::path(place.folder) / "truths" / (made.truth.name + ".json")).string();
  if (!made.truth.shortfall.empty()) return sealed;
  validation::writeLogSet(made.set, sealed.folder);
  write(sealed.truth_file, toJson(sealed.truth));
  return sealed;
}

Diagnosed diagnoseSealed(const std::string& set_folder, const std::string& robot,
                         const std::string& report_folder, const TrialPlace& place,
                         const std::string& level) {
  fs::create_directories(report_folder);
  const std::string out = fs::absolute(report_folder).string();
  const auto begun = std::chrono::steady_clock::now();
  Diagnosed diagnosed;
  const Ended ended = runIn(set_folder,
                            {fs::absolute(place.program).string(), "diagnose", ".", "--model",
                             robot, "--robots-dir", fs::absolute(place.robots_dir).string(),
                             "--level", level, "--out", out, "--jobs", std::to_string(place.jobs)},
                            out + "/log.txt");
  diagnosed.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  diagnosed.exit_code = ended.code;
  diagnosed.cpu = ended.cpu;
  diagnosed.report = read(out + "/report.json");
  diagnosed.printed = read(out + "/log.txt");
  return diagnosed;
}

std::string runTrial(const HiddenCase& hidden, const TrialPlace& place) {
  const SealedSet sealed = sealSet(hidden, place);
  Json line = {{"name", sealed.truth.name}, {"truth", Json::parse(toJson(sealed.truth))}};
  if (!sealed.truth.shortfall.empty()) {
    line["skipped"] = sealed.truth.shortfall;
  } else {
    const fs::path reports = fs::path(place.folder) / "reports" / sealed.truth.name;
    const Diagnosed diagnosed =
        diagnoseSealed(sealed.folder, hidden.robot(), reports.string(), place, hidden.level);
    line["exit_code"] = diagnosed.exit_code;
    line["wall_s"] = diagnosed.wall;
    line["cpu_s"] = diagnosed.cpu;
    GivenReport report;
    if (!diagnosed.report.empty()) {
      report = readReport(diagnosed.report);
    } else {
      report.verdict = diagnosed.exit_code == 20 ? "data_fault" : "failed";
      if (diagnosed.exit_code == 20) report.faults = readFaults(diagnosed.printed);
    }
    line["said"] = saying(report);
    line["score"] = toJson(score(sealed.truth, report));
    line["statements"] = toJson(judgeStatements(sealed.truth, report));
    const bool alone = hidden.level == "joint";  // limbs replay the test motions
    if (alone && report.verdict != "data_fault") {
      const Gain gain = calcGain(validation::readLogSet(sealed.folder), sealed.truth, report,
                                 *loadRobotModel(place.robots_dir, hidden.robot()));
      line["gain"] = {
          {"known", gain.known}, {"removed", gain.removed}, {"over_floor", gain.over_floor}};
    }
  }
  if (!place.keep_sets) fs::remove_all(sealed.folder);
  return line.dump();
}

}  // namespace nao::hidden
