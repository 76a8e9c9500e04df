#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ci/result.h"

namespace nao::ci {

/// One scenario with one seed, to be run in a process of its own.
struct Job {
  std::string file;
  std::uint64_t seed = 0;
};

/// How a job ended.
struct JobResult {
  Result result;
  double wall = 0;        // [s]
  std::string output;     // the end of what it and its clients printed
  std::string recording;  // its file; empty: none
};

/// The scenarios of a folder (its *.yaml, by name) or the one file, each with the seeds it asks
/// for, `most_seeds` of them at most. @throws InputError where there are none.
std::vector<Job> findJobs(const std::string& path, std::size_t most_seeds);

/// How jobs are run.
struct SuiteSettings {
  std::size_t jobs = 1;  // at a time
  double longest = 600;  // [s] of the wall; who needs longer is ended and has failed
  /// Which runs are recorded, into <scenario>-<seed>.run of `recordings`.
  enum class Record { None, Failed, All };
  Record record = Record::None;
  std::string recordings = ".";
  /// The command that runs a job and writes its result to this file, and its recording to that one
  /// unless it is empty.
  std::function<std::vector<std::string>(const Job& job, const std::string& result,
                                         const std::string& recording)>
      command;
  /// After each.
  std::function<void(const JobResult& result)> done;
};

/// Runs all, some at a time. The results stand in the order of the jobs.
std::vector<JobResult> runSuite(const std::vector<Job>& jobs, const SuiteSettings& settings);

}  // namespace nao::ci
