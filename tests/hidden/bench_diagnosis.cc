// Hides effects in sets and lets `usarnaoqi diagnose` find them: usarnaoqi-bench-diagnosis.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "core/check.h"
#include "core/files.h"
#include "tests/hidden/figures.h"
#include "tests/hidden/preset.h"
#include "tests/hidden/track_record.h"
#include "tests/hidden/trial.h"
#include "validation/diagnosis/jobs/team.h"

namespace nao::hidden {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string preset = "quick";
  std::uint64_t seed = 1;
  std::string shard = "1/1";
  bool json = false, add = false;
  int most = 0, at_once = 1;
  std::string kind, level, record;
  std::vector<std::string> results;  // that are there already
  Counts counts;
  TrialPlace place;
};

struct Shard {
  std::size_t index = 0, count = 1;
};

Shard parseShard(const std::string& text) {
  unsigned index = 0, count = 0;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%u/%u%c", &index, &count, &rest);
  if (read != 2 || index < 1 || index > count) {
    throw InputError("--shard: expected i/n with 1 <= i <= n, found '" + text + "'");
  }
  return {index - 1, count};
}

// What is done already, by name; a last line that was cut short is left out.
std::map<std::string, std::string> readDone(const fs::path& file) {
  std::map<std::string, std::string> done;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t begin = line.find("\"name\":\"");
    if (begin == std::string::npos || line.back() != '}') continue;
    done[line.substr(begin + 8, 16)] = line;
  }
  return done;
}

// Those of the preset that --kind and --level leave.
std::vector<HiddenCase> chosenCases(const Arguments& arguments) {
  std::vector<HiddenCase> cases = makeCases(arguments.counts, arguments.seed);
  const auto is_other = [&](const HiddenCase& one) {
    return (!arguments.kind.empty() && nameOf(one.kind) != arguments.kind) ||
           (!arguments.level.empty() && one.level != arguments.level);
  };
  cases.erase(std::remove_if(cases.begin(), cases.end(), is_other), cases.end());
  if (cases.empty()) {
    throw InputError("--kind, --level: expected what preset " + arguments.preset +
                     " holds, such as single or exact_null, joint or limb, found '" +
                     arguments.kind + "', '" + arguments.level + "'");
  }
  return cases;
}

double secondsSince(std::chrono::steady_clock::time_point begun) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

// This shard's sets: all that are done already, and of the others as many as --most says.
std::vector<HiddenCase> casesToTry(const Arguments& arguments, const std::set<std::string>& done) {
  const Shard shard = parseShard(arguments.shard);
  const std::vector<HiddenCase> cases = chosenCases(arguments);
  std::vector<HiddenCase> mine;
  int more = 0;
  for (std::size_t i = shard.index; i < cases.size(); i += shard.count) {
    if (done.count(cases[i].name()) == 0 && arguments.most > 0 && more++ == arguments.most) break;
    mine.push_back(cases[i]);
  }
  return mine;
}

// The lines of this shard's sets, those that were there already included. Several are tried side by
// side, each by itself: lines do not depend on how many.
std::vector<std::string> tryAll(const Arguments& arguments) {
  const auto begun = std::chrono::steady_clock::now();
  const fs::path results = fs::path(arguments.place.folder) / "results.jsonl";
  fs::create_directories(results.parent_path());
  const std::map<std::string, std::string> before = readDone(results);
  std::set<std::string> done;
  for (const auto& [name, line] : before) done.insert(name);
  const std::vector<HiddenCase> mine = casesToTry(arguments, done);
  std::vector<std::string> lines(mine.size());
  std::atomic<std::size_t> next{0};
  std::size_t ready = 0;
  std::mutex mutex;
  const auto at_once = static_cast<std::size_t>(arguments.at_once);
  validation::inParallel(at_once, arguments.at_once, [&](std::size_t) {
    for (std::size_t i = next++; i < mine.size(); i = next++) {
      const auto known = before.find(mine[i].name());
      lines[i] = known != before.end() ? known->second : runTrial(mine[i], arguments.place);
      const std::lock_guard<std::mutex> lock(mutex);
      if (known == before.end()) appendToFile("", results.string(), lines[i] + "\n");
      std::fprintf(stderr, "\r%zu of %zu sets, %.0f s ", ++ready, mine.size(), secondsSince(begun));
    }
  });
  std::fprintf(stderr, "\n");
  return lines;
}

std::vector<std::string> readAll(const std::vector<std::string>& files) {
  std::vector<std::string> lines;
  for (const std::string& file : files) {
    if (!fs::exists(file)) throw InputError("--results " + file + ": no such file");
    for (const auto& [name, line] : readDone(file)) lines.push_back(line);
  }
  return lines;
}

void run(const Arguments& arguments) {
  const auto begun = std::chrono::steady_clock::now();
  const std::vector<std::string> lines =
      arguments.results.empty() ? tryAll(arguments) : readAll(arguments.results);
  const Figures figures = figuresOf(lines);
  if (arguments.json) {
    std::printf("%s\n", toJson(figures, arguments.preset, secondsSince(begun)).c_str());
  } else {
    std::printf("%s%s", toText(figures).c_str(), listWrong(lines).c_str());
  }
  if (arguments.record.empty()) return;
  using validation::VerdictRecords;
  const VerdictRecords record =
      trackRecord(lines, arguments.add ? VerdictRecords::read(arguments.record) : VerdictRecords());
  writeFile("--record", arguments.record, toYaml(record));
}

}  // namespace
}  // namespace nao::hidden

int main(int argc, char** argv) {
  using namespace nao::hidden;
  CLI::App app("Hides effects in simulated sets and lets `usarnaoqi diagnose` find them.");
  Arguments arguments;
  const fs::path here = fs::canonical("/proc/self/exe").parent_path();
  arguments.place.program = (here / "usarnaoqi").string();
  arguments.place.robots_dir = NAO_SOURCE_DIR "/robots";
  arguments.place.folder = "hidden_sets";
  arguments.at_once = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  app.add_option("--preset", arguments.preset, "quick, standard (300 sets) or full (950).")
      ->capture_default_str();
  app.add_option("--seed", arguments.seed, "Another number, other sets.")->capture_default_str();
  app.add_option("--shard", arguments.shard, "i/n: every n-th set, from the i-th on.")
      ->capture_default_str();
  app.add_option("--out", arguments.place.folder,
                 "Where results.jsonl and reports go; sets that are done already are not repeated.")
      ->capture_default_str();
  app.add_option("--jobs", arguments.place.jobs, "Threads of a diagnosis.")->capture_default_str();
  app.add_option("--at-once", arguments.at_once,
                 "Sets that are tried side by side; by default as many as the machine has cores.")
      ->check(CLI::Range(1, 1024));
  app.add_option("--most", arguments.most, "Stop after this many sets more; 0: all.");
  app.add_option("--kind", arguments.kind,
                 "Sets of this kind alone, such as single or exact_null.");
  app.add_option("--level", arguments.level, "Sets of this level alone: joint, limb or robot.");
  app.add_option("--results", arguments.results,
                 "results.jsonl of earlier calls: their figures, no new sets.");
  app.add_option("--record", arguments.record,
                 "Writes what the statements of these diagnoses came to, by kind: the table that\n"
                 "`usarnaoqi diagnose` quotes from (validation/record/diagnosis.yaml).");
  app.add_flag("--add", arguments.add, "To what --record holds already, instead of anew.");
  app.add_option("--program", arguments.place.program, "The program on trial.");
  app.add_option("--robots-dir", arguments.place.robots_dir, "The nominal models.");
  app.add_flag("--keep", arguments.place.keep_sets, "Keep the sets.");
  app.add_flag("--json", arguments.json, "Figures as one JSON object.");
  try {
    app.parse(argc, argv);
    arguments.counts = countsOf(arguments.preset);
    run(arguments);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const nao::InputError& error) {
    std::fprintf(stderr, "usarnaoqi-bench-diagnosis: %s\n", error.what());
    return 2;
  }
}
