#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ci/judge.h"

namespace nao::ci {

/// The last seconds of a run, for a report. Lists run by time unless said otherwise.
struct Course {
  struct Still {
    double time = 0;  // [s]
    std::string png;  // in base64
  };
  struct Robot {
    std::string name, model;
    std::vector<double> x, y;                 // [m] on the floor
    std::vector<std::vector<double>> asked;   // [rad] by joint, then time
    std::vector<std::vector<double>> sensed;  // [rad]
  };
  struct Ball {
    std::string name;
    std::vector<double> x, y;  // [m]
  };
  std::vector<double> time;  // [s]
  std::vector<Still> stills;
  std::vector<Robot> robots;
  std::vector<Ball> balls;
};

/// How one run of a scenario ended.
struct Result {
  std::string scenario;
  std::string file;
  std::string about;
  std::uint64_t seed = 0;
  std::map<std::string, double> drawn;
  double time = 0;         // [s] simulated
  std::uint64_t hash = 0;  // of all states and inputs
  std::vector<Verdict> verdicts;
  std::string trouble;  // what kept it from being judged; empty: nothing
  Course course;        // of a failed run

  bool passed() const;
};

std::string toJson(const Result& result);
/// @throws InputError unless it is one that toJson() made.
Result parseResult(const std::string& json);

}  // namespace nao::ci
