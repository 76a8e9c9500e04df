#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/causes/whole_causes.h"
#include "validation/diagnosis/whole/whole_stage.h"

namespace nao::validation {

/// What a diagnosis of a lower level found: provisional until a higher level has seen the whole
/// robot, where it competes again.
struct HandedOn {
  std::string place;      // as in the report: "robot", a limb or a joint
  std::string cause;      // id
  std::vector<double> x;  // deviations from nominal, one per number of the cause
  bool alone = false;     // named without a rival there
  std::string robot{};    // of several; empty: whichever there is
};

/// All that `report_file` names, and the rivals of it that have a name. `level`: "limb" or "robot".
/// @throws InputError for a file that is no report, one of a level that is not below `level`, and
/// one that names nothing.
std::vector<HandedOn> readHandedOn(const std::string& report_file, const std::string& level);

/// Those of one robot of a set.
std::vector<HandedOn> handedOnTo(const std::string& robot, const std::vector<HandedOn>& all);

/// @throws InputError for one of a robot that is not among these.
void requireRobots(const std::vector<HandedOn>& all, const std::vector<std::string>& robots);

/// One of them in the search of a higher level.
struct Provisional {
  HandedOn was;
  Chosen chosen;  // among the causes of that search
};

/// Those that belong to a search of `joints` (of a limb; none: of the whole robot), each among
/// `causes`: what that level does not try by itself is added there.
std::vector<Provisional> provisionalAmong(std::vector<PlacedCause>& causes,
                                          const std::vector<HandedOn>& handed_on,
                                          const std::vector<Joint>& joints, const RobotModel& model,
                                          const std::vector<Joint>& measured);

/// What became of one.
struct HandedOnFate {
  HandedOn was;
  FoundNumber before;     // its first number, as it was handed on
  FoundNumber now;        // as it is here; without a name if it is not in the model
  double would_show = 0;  // [SD] by which the motions would differ from the nominal model's
  std::string outcome;    // for a person
};

/// Those that no search of a level can try, each with the reason. `whole_robot`: the robot level.
std::vector<HandedOnFate> notTriedAmong(const std::vector<HandedOn>& handed_on, bool whole_robot,
                                        const RobotModel& model,
                                        const std::vector<Joint>& measured);

}  // namespace nao::validation
