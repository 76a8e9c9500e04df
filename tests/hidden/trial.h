#pragma once

#include <string>

#include "tests/hidden/given_report.h"
#include "tests/hidden/hidden_set.h"
#include "tests/hidden/score.h"

namespace nao::hidden {

/// Where trials live and what is on trial.
struct TrialPlace {
  std::string program;     // `usarnaoqi`
  std::string robots_dir;  // of the nominal models
  std::string folder;      // made: sets/, truths/, reports/ and results.jsonl below it
  int jobs = 1;            // threads of a diagnosis
  bool keep_sets = false;
};

/// A set in its sealed folder: nothing in it or in its name says what it holds.
struct SealedSet {
  std::string folder;
  Truth truth;
  std::string truth_file;  // elsewhere
};

/// Makes and writes the set of a case; where its effects cannot be made large enough at the first
/// joint, at the next of its places.
SealedSet sealSet(const HiddenCase& hidden, const TrialPlace& place);

/// What a child process that is told the set's folder and the nominal model wrote of it.
struct Diagnosed {
  int exit_code = 0;
  std::string report;  // the JSON file's text; empty: none was written
  std::string printed;
  double wall = 0;  // [s]
  double cpu = 0;   // [s]
};
Diagnosed diagnoseSealed(const std::string& set_folder, const std::string& robot,
                         const std::string& report_folder, const TrialPlace& place,
                         const std::string& level = "joint");

/// How much of what the hidden effects did to the motions that nobody fitted is gone when the
/// causes of a report are put into the model.
struct Gain {
  bool known = false;     // effects showed in the test motions at all
  double removed = 0;     // of the excess squared error
  double over_floor = 0;  // test RMSE after, over what noise alone leaves
};
Gain calcGain(const validation::LogSet& set, const Truth& truth, const GivenReport& report,
              const RobotModel& model);

/// Seals, diagnoses and scores one case: a line of JSON for results.jsonl.
std::string runTrial(const HiddenCase& hidden, const TrialPlace& place);

}  // namespace nao::hidden
