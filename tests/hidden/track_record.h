#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/report/verdict_record.h"

namespace nao::hidden {

/// Adds what the statements in lines of results.jsonl came to, by their kind and by the engine that
/// made the set, to what is known before; lines of sets with spoilt data count for nothing.
/// @throws InputError for a line that is none.
validation::VerdictRecords trackRecord(const std::vector<std::string>& lines,
                                       const validation::VerdictRecords& before = {});

/// The file that `usarnaoqi diagnose --record` reads.
std::string toYaml(const validation::VerdictRecords& records);

}  // namespace nao::hidden
