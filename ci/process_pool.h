#pragma once

#include <functional>
#include <string>
#include <vector>

namespace nao::ci {

/// A program to run, and where what it prints goes.
struct PoolJob {
  std::vector<std::string> command;
  std::string output;  // file for its standard output and error
};

/// How it ended.
struct PoolEnd {
  int code = 0;       // 128 + n: by signal n
  bool slow = false;  // it was ended because it took too long
  double wall = 0;    // [s]
};

/// Runs programs, at most `at_a_time`, each for `longest` [s] of the wall at most; `ended` is told
/// of each. They end when we do. To be called from a thread that has SIGCHLD to itself.
void runPool(const std::vector<PoolJob>& jobs, std::size_t at_a_time, double longest,
             const std::function<void(std::size_t job, const PoolEnd& end)>& ended);

}  // namespace nao::ci
