#include "ci/suite.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "ci/process_pool.h"
#include "ci/scenario.h"
#include "ci/sentence.h"
#include "core/check.h"
#include "core/files.h"

namespace nao::ci {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kOutput = 8000;  // bytes of what is printed that a report keeps

/// A folder for the results on their way; gone with it.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "usarnaoqi-ci-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw InputError(name + ": can not be made");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(std::size_t i, const char* ending) const {
    return (path_ / (std::to_string(i) + ending)).string();
  }

 private:
  fs::path path_;
};

std::string contentOf(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string endOf(const std::string& text) {
  return text.size() <= kOutput ? text : "...\n" + text.substr(text.size() - kOutput);
}

// A process that left no result tells by its end what was wrong.
std::string troubleOf(const PoolEnd& end, double longest) {
  if (end.slow) return "it did not end within " + shown(longest) + " s of wall time";
  return "it ended with exit code " + std::to_string(end.code) + " and left no result";
}

JobResult resultOf(const Job& job, const PoolEnd& end, const std::string& file, double longest) {
  JobResult result;
  result.wall = end.wall;
  const std::string json = contentOf(file);
  if (json.empty()) {
    result.result.scenario = fs::path(job.file).stem();
    result.result.file = job.file;
    result.result.seed = job.seed;
    result.result.trouble = troubleOf(end, longest);
  } else {
    result.result = parseResult(json);
  }
  return result;
}

std::string recordingOf(const Job& job, const SuiteSettings& settings) {
  if (settings.record == SuiteSettings::Record::None) return {};
  const std::string name =
      fs::path(job.file).stem().string() + "-" + std::to_string(job.seed) + ".run";
  return (fs::path(settings.recordings) / name).string();
}

// The recording's file, if it is to stay and there is one.
std::string keep(const std::string& recording, const Result& result, SuiteSettings::Record record) {
  if (recording.empty()) return {};
  if (record == SuiteSettings::Record::Failed && result.passed()) {
    std::error_code ignored;  // it was never written
    fs::remove(recording, ignored);
  }
  return fs::exists(recording) ? recording : "";
}

}  // namespace

std::vector<Job> findJobs(const std::string& path, std::size_t most_seeds) {
  std::vector<std::string> files;
  if (fs::is_directory(path)) {
    for (const fs::path& entry : listFolder(path)) {
      if (entry.extension() == ".yaml") files.push_back(entry);
    }
    if (files.empty()) throw InputError(path + ": there is no scenario (*.yaml) in it");
  } else {
    files.push_back(path);
  }
  std::vector<Job> jobs;
  for (const std::string& file : files) {
    std::vector<std::uint64_t> seeds = loadSeeds(file);
    if (seeds.size() > most_seeds) seeds.resize(most_seeds);
    for (const std::uint64_t seed : seeds) jobs.push_back({file, seed});
  }
  return jobs;
}

std::vector<JobResult> runSuite(const std::vector<Job>& jobs, const SuiteSettings& settings) {
  const Folder folder;
  std::vector<PoolJob> processes;
  std::vector<std::string> recordings;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    recordings.push_back(recordingOf(jobs[i], settings));
    processes.push_back({settings.command(jobs[i], folder.file(i, ".json"), recordings[i]),
                         folder.file(i, ".log")});
  }
  std::vector<JobResult> results(jobs.size());
  runPool(processes, settings.jobs, settings.longest, [&](std::size_t i, const PoolEnd& end) {
    results[i] = resultOf(jobs[i], end, folder.file(i, ".json"), settings.longest);
    results[i].output = endOf(contentOf(folder.file(i, ".log")));
    results[i].recording = keep(recordings[i], results[i].result, settings.record);
    if (settings.done) settings.done(results[i]);
  });
  return results;
}

}  // namespace nao::ci
