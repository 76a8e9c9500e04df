#pragma once

#include "validation/diagnosis/report/diagnosis_plots.h"

namespace nao::validation {

/// What a page shows of a joint beside its verdict.
struct ExaminedJoint {
  JointReplay before, after;  // without and with what was found
  JointCourse course;         // empty where nothing is to be found
};

/// All joints of a diagnosis, replayed by the threads and processes of `options`. Test runs are not
/// looked at. `tasks` are those that were diagnosed.
std::vector<ExaminedJoint> examineJoints(const SetDiagnosis& diagnosis,
                                         const std::vector<JointTask>& tasks,
                                         const DiagnosisOptions& options);

}  // namespace nao::validation
