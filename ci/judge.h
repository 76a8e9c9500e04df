#pragma once

#include <vector>

#include "ci/expectation.h"
#include "ci/observation.h"

namespace nao::ci {

/// What became of an expectation.
struct Verdict {
  bool passed = false;
  std::string expected;
  std::string seen;  // what decided it, or the closest it came
  Duration at{};     // when
  int line = 0;      // of the scenario's file
};

/// Holds expectations against what happens, beat by beat. Simulation thread.
class Judge {
 public:
  explicit Judge(const std::vector<Expectation>& expectations);

  /// At every beat, in order of time.
  void look(const Moment& moment);

  /// Whether one has failed already.
  bool hasFailed() const { return failed_; }

  /// After the last beat: what is still open is decided.
  std::vector<Verdict> finish(SimTime end);

 private:
  struct Case {
    Expectation expectation;
    bool decided = false;
    bool passed = false;
    bool looked = false;
    Observation best;  // decisive, or the closest
    Duration at{};
    SimTime next_look{};
  };
  void lookAt(Case& one, const Moment& moment);
  void decide(Case& one, bool passed, const Observation& seen, Duration at);

  std::vector<Case> cases_;
  Observer observer_;
  bool failed_ = false;
};

}  // namespace nao::ci
