#pragma once

#include <string>

#include "validation/diagnosis/joint/diagnose.h"
#include "validation/diagnosis/report/provenance.h"

namespace nao::validation {

/// report.json: verdicts, what was found and rejected and why, thresholds and runs.
std::string toJson(const SetDiagnosis& diagnosis, const Provenance& provenance);
/// The same for a person, the verdict first.
std::string toText(const SetDiagnosis& diagnosis);

}  // namespace nao::validation
