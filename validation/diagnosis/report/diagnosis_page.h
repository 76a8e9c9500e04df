#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/joint/diagnose.h"
#include "validation/diagnosis/report/diagnosis_json.h"
#include "validation/diagnosis/report/examined_joint.h"

namespace nao::validation {

/// A diagnosis as one HTML page that needs no other file: the verdict in words first; what is
/// wrong, joint by joint, beside what noise explains; for every joint with a finding or a remainder
/// its measured and simulated course, its error by speed and angle, how sharply number and name are
/// told, the causes in order of what they explain, and why others were not taken; last where it all
/// comes from and what is assumed. `examined` is of all joints, as examineJoints() makes it.
/// @throws InputError without gnuplot.
std::string diagnosisPage(const SetDiagnosis& diagnosis, const std::vector<ExaminedJoint>& examined,
                          const Provenance& provenance);

}  // namespace nao::validation
