#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "validation/diagnosis/report/diagnosis_json.h"
#include "validation/diagnosis/report/diagnosis_plots.h"
#include "validation/diagnosis/whole/whole_search.h"
#include "validation/diagnosis/whole/whole_spread.h"

namespace nao::validation {

/// joint: RigSet and JointSearch; the other two replay the whole robot.
enum class Level { Limb, Robot };

struct WholeDiagnosisOptions {
  Level level = Level::Robot;
  WholeEffort effort;
  std::vector<std::string> only;    // causes to try, "id" or "id at place"; empty: all
  std::vector<HandedOn> handed_on;  // by a lower level: they compete again
  int jobs = 1;                     // threads; the result is the same for any number
  double seconds =
      0;  // of wall time to take, about; which runs it pays for is settled at the start; 0: all
  std::function<void(const std::string& what, double part)> progress;  // part: 0 to 1, never less
  KeptWork kept;  // where a diagnosis that was cut off finds what it simulated
};

/// A gait number of the runs of one motion that serve for one thing, measured and simulated.
struct GaitRow {
  std::string robot, motion, split, name, unit;
  double measured = 0, measured_sd = 0;  // of the repeats
  double nominal = 0, nominal_sd = 0;    // of the nominal model
  double extended = 0;                   // with what was found
};

/// What the limb or robot level shows of a set. Where its runs are of several robots each is
/// diagnosed by itself, with thresholds for all of them together.
struct WholeDiagnosis {
  /// As at the joint level: one entry per place that has a finding, and first one for the robot (or
  /// limb) as a whole, which holds what was rejected and what remains.
  SetDiagnosis set;
  struct RobotSpread {
    std::string robot;
    WholeSpread spread;  // with the nominal model
    WholeSpread found;   // with what was found; limb level: as above
  };
  std::vector<RobotSpread> spreads;
  std::vector<GaitRow> gait;
  std::vector<HandedOnFate> handed_on;  // with several robots of each, their places with its name
  struct Course {
    std::string place, joint;
    JointCourse course;
  };
  std::vector<Course> courses;  // of the joint that is furthest off, by robot or limb
};

/// @throws InputError for a set that the model can not replay.
WholeDiagnosis diagnoseWhole(const LogSet& set, const std::shared_ptr<const RobotModel>& model,
                             const WholeDiagnosisOptions& options);

/// report.json and the text for a person: those of the joint level, and second moments and gait.
std::string toJson(const WholeDiagnosis& diagnosis, const Provenance& provenance);
std::string toText(const WholeDiagnosis& diagnosis);
/// One HTML page that needs no other file: the verdict in words, what was found and what was not,
/// second moments, and gait numbers.
std::string wholePage(const WholeDiagnosis& diagnosis, const Provenance& provenance);

}  // namespace nao::validation
