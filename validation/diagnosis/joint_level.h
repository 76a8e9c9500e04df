#pragma once

#include <memory>
#include <string>
#include <vector>

#include "validation/diagnosis/report/examined_joint.h"
#include "validation/diagnosis/report/verdict_record.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

struct JointLevelOptions : DiagnosisOptions {
  std::string only;      // this joint alone; empty: all that were measured
  double seconds = 0;    // that the search may take on this machine; 0: any
  bool examine = false;  // for a page: joints are replayed with what was found
};

/// What the joints of a set show, each alone; of several robots a joint is called "7/LHipPitch".
struct JointLevelDiagnosis {
  SetDiagnosis found;
  std::string notes;                    // what else a reader must know, a line each
  std::vector<ExaminedJoint> examined;  // by joint, if they were to be
};

/// Diagnoses a hung up robot joint by joint. Runs of several robots (LogRun::robot_id) are no
/// repeats of each other: each robot is diagnosed apart, with its part of the set's false alarms.
/// @throws InputError as RigSet does, and for `only` if it was not measured in all runs.
JointLevelDiagnosis diagnoseJointLevel(const LogSet& set,
                                       const std::shared_ptr<const RobotModel>& model,
                                       const VerdictRecords& records,
                                       const JointLevelOptions& options);

}  // namespace nao::validation
